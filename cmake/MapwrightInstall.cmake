# Installed libraries and headers, found with find_package(mapwright).
include(CMakePackageConfigHelpers)
