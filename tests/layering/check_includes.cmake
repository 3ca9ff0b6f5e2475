# A wrong-direction include compiles, since all layers share one include root; this script is what holds the arrows of
# docs/architecture.md. Usage: cmake -DSOURCE_DIR=.../src/heckbert -P check_includes.cmake

cmake_minimum_required(VERSION 3.25)

set(may_use_taxonomy taxonomy)
set(may_use_record taxonomy record)
set(may_use_report taxonomy record report)
set(may_use_transport taxonomy record transport)
set(may_use_import taxonomy record transport import)
set(may_use_cli taxonomy record report transport import cli)

# A library's header, and the only files that may include it; third-party types stay out of public headers, GLM in
# transport excepted.
set(guarded
  "embree3/=transport/embree_tracer.cpp"
  "glm/=(transport|import)/.*"
  "(oneapi/)?tbb/=transport/[^/]*.cpp"
  "OpenEXR/=(record/([^/]*[.]cpp|(exr|deep_chunk|deep_rows|record_header|sums_parts|words_part)[.]h)|import/radiance_image[.]cpp)"
  "libdeflate[.]h=record/deep_chunk[.]cpp"
  "nlohmann/=((report|import|cli)/.*[.]cpp|report/json_parts[.]h)"
  "CLI/=cli/.*"
  "tiny_obj_loader=import/[^/]*.cpp"
  "mpi[.]h=cli/ranks_mpi[.]cpp"
  "png[.]h=report/[^/]*.cpp"
  "boost/=record/[^/]*.cpp"
  "fmt/=(record|report|transport|import|cli)/.*")
# taxonomy depends on the standard library only, without threads or a file system.
set(forbidden_in_taxonomy "<(thread|mutex|atomic|future|filesystem|fstream|iostream)>")

set(violations "")
file(GLOB_RECURSE files RELATIVE "${SOURCE_DIR}" "${SOURCE_DIR}/*.h" "${SOURCE_DIR}/*.cpp")
if(NOT files)
  message(FATAL_ERROR "no sources in ${SOURCE_DIR}")
endif()
foreach(file IN LISTS files)
  string(REGEX MATCH "^[^/]+" layer "${file}")
  file(STRINGS "${SOURCE_DIR}/${file}" includes REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS includes)
    if(line MATCHES "[<\"]heckbert/([a-z]+)/" AND NOT CMAKE_MATCH_1 IN_LIST may_use_${layer})
      string(APPEND violations "  ${file}: ${layer} must not use ${CMAKE_MATCH_1}\n")
    endif()
    foreach(guard IN LISTS guarded)
      string(REGEX MATCH "^(.*)=(.*)$" _ "${guard}")
      set(header "${CMAKE_MATCH_1}")
      set(allowed "${CMAKE_MATCH_2}")
      if(line MATCHES "[<\"]${header}" AND NOT file MATCHES "^${allowed}$")
        string(APPEND violations "  ${file}: only ${allowed} may include ${header}\n")
      endif()
    endforeach()
    if(layer STREQUAL "taxonomy" AND line MATCHES "${forbidden_in_taxonomy}")
      string(APPEND violations "  ${file}: taxonomy must do without ${CMAKE_MATCH_1}\n")
    endif()
  endforeach()
endforeach()
if(violations)
  message(FATAL_ERROR "includes against the arrows:\n${violations}")
endif()
list(LENGTH files count)
message(STATUS "${count} files follow the arrows")
