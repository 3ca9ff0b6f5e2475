// Grammar files.

#include <heckbert/taxonomy/grammar.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  fuzz::expect_answer(
      [&] { taxonomy::parse_grammar(fuzz::text_of(data, size), "fuzz.grammar", taxonomy::builtin_grammars()); });
  return 0;
}
