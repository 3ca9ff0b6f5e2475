# One helper makes every layer the same way: a static library heckbert_<name> with the alias heckbert::<name>,
# its headers beside its sources and included as <heckbert/<name>/x.h>, and its own export set, so that each layer
# installs as a component that drags in only what it needs.

add_library(heckbert_warnings INTERFACE)
target_compile_options(heckbert_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<BOOL:${HECKBERT_WARNINGS_AS_ERRORS}>:-Werror>)

if(HECKBERT_SANITIZE)
  # GCC warns of the standard library's own variables under sanitizers (gcc.gnu.org/bugzilla/show_bug.cgi?id=105562).
  target_compile_options(heckbert_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_compile_options(-fsanitize=${HECKBERT_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${HECKBERT_SANITIZE})
endif()

# heckbert_compile_fast(<target> [REUSE_FROM <target> | PRIVATE <header> ...]): for code that runs little, whose optimisation
# costs more than it saves. Builds without HECKBERT_COMPILE_FAST see to it that every file includes what it uses.
function(heckbert_compile_fast target)
  if(HECKBERT_COMPILE_FAST)
    # At -O1 GCC 12 sees strings copied out of bounds that are not (gcc.gnu.org/bugzilla/show_bug.cgi?id=105329).
    target_compile_options(${target} PRIVATE -O1
      "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>")
    if(ARGN)
      target_precompile_headers(${target} ${ARGN})
    endif()
  endif()
endfunction()

# heckbert_layer(<name> SOURCES a.cpp ... HEADERS a.h ... [PUBLIC lib ...] [PRIVATE lib ...])
function(heckbert_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  set(target heckbert_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(heckbert::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/src" FILES ${ARG_HEADERS})
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC}
    PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:heckbert_warnings>)
  install(TARGETS ${target} EXPORT heckbert_${name} FILE_SET HEADERS COMPONENT ${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name})
  install(EXPORT heckbert_${name} NAMESPACE heckbert:: FILE heckbert-${name}.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/heckbert COMPONENT ${name})
endfunction()

# heckbert_test(<name> LABELS unit ... SOURCES a_test.cpp ... LIBS heckbert::x ...): one GoogleTest program.
function(heckbert_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LIBS;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  target_link_libraries(${name} PRIVATE ${ARG_LIBS} GTest::gtest_main GTest::gmock heckbert_warnings)
  target_compile_definitions(${name} PRIVATE
    HECKBERT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" HECKBERT_GRAMMAR_DIR="${PROJECT_SOURCE_DIR}/grammar")
  heckbert_compile_fast(${name} REUSE_FROM heckbert_test_headers)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()

# heckbert_output_test(<name> <file of expected output> <command> ...): runs a command and matches what it prints.
function(heckbert_output_test name expected)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} "-DCOMMAND=${ARGN}" "-DEXPECTED=${expected}"
    "-DACTUAL=${CMAKE_CURRENT_BINARY_DIR}/${name}.actual" -DCOMPARE=$<TARGET_FILE:compare_output>
    -P ${PROJECT_SOURCE_DIR}/tests/support/run_and_compare.cmake)
  set_tests_properties(${name} PROPERTIES LABELS golden TIMEOUT 300)
endfunction()
