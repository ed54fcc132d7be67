# What a person may choose when configuring, and what every target of ours is compiled with.
option(MAPWRIGHT_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(MAPWRIGHT_BUILD_BENCHMARKS "Build the benchmarks" OFF)
option(MAPWRIGHT_BUILD_FUZZERS "Build the libFuzzer targets (needs clang)" OFF)
option(MAPWRIGHT_ASSERTIONS "Keep assert() in optimised builds" OFF)
set(MAPWRIGHT_DOCS_URL "" CACHE STRING
  "Where the folder docs is on the web, without a slash at its end; SARIF reports link to its pages")
set(MAPWRIGHT_SANITIZE "" CACHE STRING "Sanitizers to compile with, for example address,undefined")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(MAPWRIGHT_CCACHE ccache)
if(MAPWRIGHT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${MAPWRIGHT_CCACHE})
endif()

# Debug information enough for a stack trace; the full kind doubles the time to build.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1")
if(NOT MAPWRIGHT_ASSERTIONS)
  string(APPEND CMAKE_CXX_FLAGS_RELWITHDEBINFO " -DNDEBUG")
endif()

add_library(mapwright_build_flags INTERFACE)
target_compile_features(mapwright_build_flags INTERFACE cxx_std_20)
target_compile_options(mapwright_build_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  # The same source must give the same bytes on every machine, so no fused multiply-add.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # With -O3, GCC 12 sees overlapping copies in std::string's operator+ that cannot happen (GCC bug
  # 105651).
  target_compile_options(mapwright_build_flags INTERFACE $<$<CONFIG:Release>:-Wno-restrict>)
endif()
if(MAPWRIGHT_SANITIZE)
  target_compile_options(mapwright_build_flags INTERFACE
    -fsanitize=${MAPWRIGHT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(mapwright_build_flags INTERFACE -fsanitize=${MAPWRIGHT_SANITIZE})
endif()
if(MAPWRIGHT_BUILD_FUZZERS)
  # The libraries tell a fuzzer which of their branches it has reached.
  target_compile_options(mapwright_build_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
