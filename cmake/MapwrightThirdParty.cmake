# Third-party libraries whose packages have no target of their own, or one that is not ours to use as
# it is. Included when mapwright is built and, from its installed package, when it is used.
include_guard(GLOBAL)

# std::expected's forerunner: headers only, without a CMake package in older releases.
find_path(MAPWRIGHT_EXPECTED_INCLUDE_DIR tl/expected.hpp REQUIRED)
add_library(mapwright_expected INTERFACE IMPORTED GLOBAL)
set_target_properties(mapwright_expected PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${MAPWRIGHT_EXPECTED_INCLUDE_DIR})

# GeographicLib's package names differ between releases of Debian and Ubuntu: ask for the library.
find_path(MAPWRIGHT_GEOGRAPHICLIB_INCLUDE_DIR GeographicLib/TransverseMercator.hpp REQUIRED)
find_library(MAPWRIGHT_GEOGRAPHICLIB_LIBRARY NAMES GeographicLib Geographic REQUIRED)
add_library(mapwright_geographiclib INTERFACE IMPORTED GLOBAL)
set_target_properties(mapwright_geographiclib PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${MAPWRIGHT_GEOGRAPHICLIB_INCLUDE_DIR}
  INTERFACE_LINK_LIBRARIES ${MAPWRIGHT_GEOGRAPHICLIB_LIBRARY})

# One name for what a library with CGAL inside links. It brings CGAL's flag -frounding-math along,
# which the exact predicates rely on.
add_library(mapwright_cgal INTERFACE IMPORTED GLOBAL)
set_target_properties(mapwright_cgal PROPERTIES INTERFACE_LINK_LIBRARIES CGAL::CGAL)

# Osmium (OpenStreetMap files) is headers only; what they need is not.
find_path(MAPWRIGHT_OSMIUM_INCLUDE_DIR osmium/osm.hpp REQUIRED)
find_package(EXPAT REQUIRED)
find_package(ZLIB REQUIRED)
find_package(BZip2 REQUIRED)
find_package(Threads REQUIRED)
add_library(mapwright_osmium INTERFACE IMPORTED GLOBAL)
set_target_properties(mapwright_osmium PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${MAPWRIGHT_OSMIUM_INCLUDE_DIR}
  INTERFACE_LINK_LIBRARIES "EXPAT::EXPAT;ZLIB::ZLIB;BZip2::BZip2;Threads::Threads")
