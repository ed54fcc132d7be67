# Third-party libraries, all from the distribution's packages (scripts/packages.txt).
find_package(Threads REQUIRED)
find_package(CGAL REQUIRED)
find_package(GDAL REQUIRED)
find_package(Boost 1.74 REQUIRED COMPONENTS program_options iostreams)
find_package(nlohmann_json 3.9 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(Cairo REQUIRED IMPORTED_TARGET cairo cairo-svg cairo-pdf cairo-png)
find_path(EXPECTED_INCLUDE_DIR tl/expected.hpp REQUIRED)

# GeographicLib's package names differ between releases of Debian and Ubuntu: ask for the library.
find_path(GEOGRAPHICLIB_INCLUDE_DIR GeographicLib/TransverseMercator.hpp REQUIRED)
find_library(GEOGRAPHICLIB_LIBRARY NAMES GeographicLib Geographic REQUIRED)
add_library(mapwright_geographiclib INTERFACE)
target_include_directories(mapwright_geographiclib SYSTEM INTERFACE ${GEOGRAPHICLIB_INCLUDE_DIR})
target_link_libraries(mapwright_geographiclib INTERFACE ${GEOGRAPHICLIB_LIBRARY})

# CGAL's own target adds flags that only its exact-rounding kernels need; every file that includes
# CGAL links this instead and keeps its headers quiet.
add_library(mapwright_cgal INTERFACE)
target_link_libraries(mapwright_cgal INTERFACE CGAL::CGAL)
