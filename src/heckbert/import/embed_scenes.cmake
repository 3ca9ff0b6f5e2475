# cmake -DSCENES="a.json;b.json" -DOUTPUT=x.cpp -P embed_scenes.cmake: writes the definition of builtin_scenes().
# Literals are cut into pieces below the 64 KB that every compiler accepts; the compiler joins them again.

set(PIECE_LENGTH 16000)
set(entries "")
foreach(scene IN LISTS SCENES)
  get_filename_component(name "${scene}" NAME_WE)
  file(READ "${scene}" text)
  if(NOT text MATCHES "\"title\": *\"([^\"\\]+)\"")
    message(FATAL_ERROR "${scene}: a built-in scene needs a \"title\" of plain text")
  endif()
  string(APPEND entries "      {\"${name}\", R\"json(${CMAKE_MATCH_1})json\",\n")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} ${PIECE_LENGTH} piece)
    string(APPEND entries "R\"json(${piece})json\"\n")
    math(EXPR at "${at} + ${PIECE_LENGTH}")
  endwhile()
  string(APPEND entries "},\n")
endforeach()

file(WRITE "${OUTPUT}" "// Written by embed_scenes.cmake; edit scenes/*.json instead.
#include <heckbert/import/import.h>

namespace heckbert::import {

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes{
${entries}  };
  return scenes;
}

}  // namespace heckbert::import
")
