# Libraries of which only headers are used: whoever links ours does not need them.
set(MAPWRIGHT_HEADERS_ONLY nlohmann_json::nlohmann_json Boost::boost Boost::headers)

# One library target a folder: mapwright_library(NAME SOURCES... PUBLIC libs... PRIVATE libs...)
function(mapwright_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  add_library(mapwright::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES
    OUTPUT_NAME mapwright_${name}
    POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name}
    PUBLIC
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/mapwright>)
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:mapwright_build_flags>)
  target_link_libraries(${name} PUBLIC mapwright_expected ${ARG_PUBLIC})
  foreach(library IN LISTS ARG_PRIVATE)
    if(library IN_LIST MAPWRIGHT_HEADERS_ONLY)
      set(library $<BUILD_INTERFACE:${library}>)
    endif()
    target_link_libraries(${name} PRIVATE ${library})
  endforeach()
endfunction()
