// Words. What can be read prints as itself, and as an expression has exactly itself.

#include <heckbert/taxonomy/expression.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  const auto word = fuzz::answer([&] { return taxonomy::parse_word(fuzz::text_of(data, size)); });
  if (!word) return 0;
  fuzz::require(taxonomy::parse_word(taxonomy::fine(*word)) == *word, "printed and read back as another word");
  fuzz::require(taxonomy::compile(taxonomy::fine(*word)) == taxonomy::Language::of(*word),
                "as an expression it is another language");
  return 0;
}
