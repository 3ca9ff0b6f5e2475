// Heckbert's own notation, with the names of the shipped grammars. What can be read must print and read back as the
// same language, and be the same in the table of dialects.

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/simplest.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  static const taxonomy::Names names = taxonomy::builtin_grammars().names();
  const std::string_view text = fuzz::text_of(data, size);
  const auto language = fuzz::answer([&] { return taxonomy::compile(text, names); });
  const auto as_dialect =
      fuzz::answer([&] { return taxonomy::read_expression(text, taxonomy::Dialect::Heckbert, names).language; });
  fuzz::require(language == as_dialect, "compile() and the dialect disagree");
  if (!language) return 0;
  fuzz::require(language->is_subset_of(taxonomy::Language::universe()), "a string that is no word");
  if (const auto printed = taxonomy::simplest_expression(*language))
    fuzz::require(taxonomy::compile(*printed) == *language, "printed and read back as another language");
  return 0;
}
