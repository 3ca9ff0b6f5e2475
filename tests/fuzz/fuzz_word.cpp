// Words. What can be read prints as itself, and as an expression has itself: exactly, or, where it is labelled in part,
// with any label where it has none.

#include <heckbert/taxonomy/expression.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  const auto word = fuzz::answer([&] { return taxonomy::parse_word(fuzz::text_of(data, size)); });
  if (!word) return 0;
  fuzz::require(taxonomy::parse_word(taxonomy::fine(*word)) == *word, "printed and read back as another word");
  const taxonomy::Language as_expression = taxonomy::compile(taxonomy::fine(*word)),
                           exact = taxonomy::Language::of(*word);
  fuzz::require(exact.contains(*word) && exact.is_subset_of(as_expression), "as an expression it has other words");
  fuzz::require(!word->labels.empty() || exact == as_expression, "as an expression it is another language");
  return 0;
}
