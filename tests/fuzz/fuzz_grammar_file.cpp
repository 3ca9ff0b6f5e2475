// Grammar files. A grammar that is read can be asked for its words.

#include <heckbert/taxonomy/grammar.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  const auto grammar = fuzz::answer(
      [&] { return taxonomy::parse_grammar(fuzz::text_of(data, size), "fuzz.grammar", taxonomy::builtin_grammars()); });
  if (!grammar) return 0;
  fuzz::require(!grammar->name.empty(), "a grammar without a name");
  fuzz::require(taxonomy::has_language(*grammar) == taxonomy::why_no_language(*grammar).empty(),
                "a language and a reason for having none");
  fuzz::require(grammar->language.is_subset_of(taxonomy::Language::universe()), "a string that is no word");
  return 0;
}
