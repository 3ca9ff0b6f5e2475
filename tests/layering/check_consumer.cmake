# Installs the built tree into a scratch prefix, then configures, builds and runs a project that finds it there.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}\n${output}")
  endif()
endfunction()
file(REMOVE_RECURSE "${SCRATCH_DIR}")
run(${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${SCRATCH_DIR}/prefix")
string(REPLACE ";" "\\;" component_list "${COMPONENTS}")  # one argument, not one per component
set(flags "")
if(SANITIZE)
  set(flags "-DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE}")
endif()
run(${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${SCRATCH_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/prefix" "-DCOMPONENTS=${component_list}" ${flags})
run(${CMAKE_COMMAND} --build "${SCRATCH_DIR}/build")
foreach(component IN LISTS COMPONENTS)
  run("${SCRATCH_DIR}/build/use_${component}")
endforeach()
# A component that was not installed is refused with a sentence.
execute_process(COMMAND ${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${SCRATCH_DIR}/refused" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/prefix" -DCOMPONENTS=nonesuch RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
if(result EQUAL 0 OR NOT output MATCHES "nonesuch")
  message(FATAL_ERROR "an unknown component was not refused: ${output}")
endif()
