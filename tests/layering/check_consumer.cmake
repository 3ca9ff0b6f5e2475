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

# Words and languages need no renderer: taxonomy installed by itself, the packages of all other layers out of reach, and
# the example for authors of renderers built from outside.
run(${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${SCRATCH_DIR}/taxonomy_prefix" --component taxonomy)
set(out_of_reach "")
foreach(package embree TBB glm OpenEXR Imath fmt PNG nlohmann_json tinyobjloader)
  list(APPEND out_of_reach "-DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON")
endforeach()
run(${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${SCRATCH_DIR}/taxonomy_build" -G "${GENERATOR}" ${out_of_reach} ${flags}
  "-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/taxonomy_prefix" -DCOMPONENTS=taxonomy "-DEXAMPLE=${EXAMPLE}.cpp")
run(${CMAKE_COMMAND} --build "${SCRATCH_DIR}/taxonomy_build")
run("${SCRATCH_DIR}/taxonomy_build/use_taxonomy")
execute_process(COMMAND "${SCRATCH_DIR}/taxonomy_build/example" RESULT_VARIABLE result OUTPUT_VARIABLE output)
file(READ "${EXAMPLE}.expected" expected)
if(NOT result EQUAL 0 OR NOT output STREQUAL expected)
  message(FATAL_ERROR "the example built from outside: ${result}\n${output}")
endif()
# The same packages are missed where they are needed, so they were out of reach indeed.
execute_process(COMMAND ${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${SCRATCH_DIR}/unreachable" -G "${GENERATOR}"
  ${out_of_reach} "-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/prefix" -DCOMPONENTS=record
  RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
if(result EQUAL 0)
  message(FATAL_ERROR "record was found with its packages out of reach")
endif()

# A component that was not installed is refused with a sentence.
execute_process(COMMAND ${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${SCRATCH_DIR}/refused" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/prefix" -DCOMPONENTS=nonesuch RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
if(result EQUAL 0 OR NOT output MATCHES "nonesuch")
  message(FATAL_ERROR "an unknown component was not refused: ${output}")
endif()
