# The layering check must fail on each kind of violation, or it holds nothing.
cmake_minimum_required(VERSION 3.25)

function(expect_refused file line why)
  file(REMOVE_RECURSE "${SCRATCH_DIR}")
  file(WRITE "${SCRATCH_DIR}/${file}" "${line}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${SCRATCH_DIR} -P ${CMAKE_CURRENT_LIST_DIR}/check_includes.cmake
    RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  if(result EQUAL 0 OR NOT output MATCHES "${why}")
    message(FATAL_ERROR "${file} with ${line} was let through, or for another reason: ${output}")
  endif()
endfunction()
expect_refused(record/a.h "#include <heckbert/transport/scene.h>" "record must not use transport")
expect_refused(transport/path_tracer.cpp "#include <embree3/rtcore.h>" "may include embree3")
expect_refused(record/record.h "#include <OpenEXR/ImfHeader.h>" "may include OpenEXR")
expect_refused(taxonomy/word.cpp "#include <filesystem>" "taxonomy must do without filesystem")
file(REMOVE_RECURSE "${SCRATCH_DIR}")
