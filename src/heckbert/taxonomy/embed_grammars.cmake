# Writes the grammar files into one C++ source, so that the library carries them and reads no file when it runs.
# cmake -DOUTPUT=builtin_grammars.cpp -DDIRECTORY=grammar -P embed_grammars.cmake

file(GLOB files "${DIRECTORY}/*.grammar")
list(SORT files)
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" text)
  string(APPEND entries "    {\"${name}\", R\"grammar(${text})grammar\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from grammar/ by embed_grammars.cmake.
#include <vector>

#include <heckbert/taxonomy/grammar.h>

namespace heckbert::taxonomy {

const GrammarLibrary& builtin_grammars() {
  static const GrammarLibrary library = read_grammars(std::vector<GrammarText>{
${entries}  });
  return library;
}

}  // namespace heckbert::taxonomy
")
