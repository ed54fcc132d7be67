# Installs the build into a scratch folder, builds a small project against it and runs that.
set(prefix ${SCRATCH_DIR}/prefix)
set(consumer_build ${SCRATCH_DIR}/build)
file(REMOVE_RECURSE ${SCRATCH_DIR})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${ARGN}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=${SANITIZE}")
endif()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${consumer_build} -G Ninja
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${CXX_COMPILER}
  "-D CMAKE_CXX_FLAGS=${flags}")
run(${CMAKE_COMMAND} --build ${consumer_build})
run(${consumer_build}/consumer)

if(NOT output STREQUAL "findings 0, area 4, range 3, picture drawn\n")
  message(FATAL_ERROR "the consumer printed: ${output}")
endif()

# Nothing of ours may point back into the source tree, and private headers stay at home.
file(GLOB_RECURSE installed ${prefix}/*.cmake ${prefix}/*.hpp)
list(LENGTH installed count)
if(count LESS 20)
  message(FATAL_ERROR "only ${count} files were installed")
endif()
get_filename_component(source_dir ${CONSUMER_DIR}/../../.. ABSOLUTE)
foreach(file IN LISTS installed)
  file(READ ${file} text)
  string(FIND "${text}" "${source_dir}/" machine_path)
  string(FIND "${text}" "// Private to this folder" private)
  if(NOT machine_path EQUAL -1)
    message(FATAL_ERROR "${file} names the folder of the sources")
  elseif(private EQUAL 0)
    message(FATAL_ERROR "${file} is private and was installed")
  endif()
endforeach()
message(STATUS "installed ${count} files; the consumer printed: ${output}")
