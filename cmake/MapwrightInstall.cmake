# Installed libraries and headers: another project says find_package(mapwright) and links
# mapwright::mapcore, mapwright::navcore, mapwright::validators or mapwright::converter.
include(CMakePackageConfigHelpers)

set(MAPWRIGHT_LIBRARIES mapcore navcore validators converter)
set(MAPWRIGHT_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/mapwright)

install(TARGETS ${MAPWRIGHT_LIBRARIES}
  EXPORT mapwright_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT mapwright_targets
  FILE mapwrightTargets.cmake
  NAMESPACE mapwright::
  DESTINATION ${MAPWRIGHT_PACKAGE_DIR})

# Headers that begin with "// Private to this folder" stay at home.
foreach(library IN LISTS MAPWRIGHT_LIBRARIES)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
    ${PROJECT_SOURCE_DIR}/${library}/*.hpp ${PROJECT_SOURCE_DIR}/${library}/*.def)
  foreach(header IN LISTS headers)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} first_line LIMIT_COUNT 1)
    if(first_line MATCHES "^// Private to this folder")
      continue()
    endif()
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${header}
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mapwright/${folder})
  endforeach()
endforeach()

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/mapwrightConfig.cmake.in
  ${PROJECT_BINARY_DIR}/mapwrightConfig.cmake
  INSTALL_DESTINATION ${MAPWRIGHT_PACKAGE_DIR})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/mapwrightConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/mapwrightConfig.cmake
  ${PROJECT_BINARY_DIR}/mapwrightConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/MapwrightThirdParty.cmake
  DESTINATION ${MAPWRIGHT_PACKAGE_DIR})
