# Runs COMMAND (a list) and compares what it prints with EXPECTED by COMPARE; leaves the output beside in ACTUAL.
# HECKBERT_UPDATE_DOCS=1 in the environment makes it what is expected.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${COMMAND} OUTPUT_FILE "${ACTUAL}" ERROR_VARIABLE errors RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "exit ${result}: ${errors}")
endif()
if(DEFINED ENV{HECKBERT_UPDATE_DOCS})
  file(COPY_FILE "${ACTUAL}" "${EXPECTED}")
endif()
execute_process(COMMAND "${COMPARE}" "${EXPECTED}" "${ACTUAL}" ERROR_VARIABLE errors RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${errors}\nthe whole output is in ${ACTUAL}; HECKBERT_UPDATE_DOCS=1 puts it in place")
endif()
