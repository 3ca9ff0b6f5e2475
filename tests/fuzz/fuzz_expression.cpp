// Heckbert's own notation, with the names of the shipped grammars.

#include <heckbert/taxonomy/grammar.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  static const taxonomy::Names names = taxonomy::builtin_grammars().names();
  fuzz::expect_answer([&] { taxonomy::compile(fuzz::text_of(data, size), names); });
  return 0;
}
