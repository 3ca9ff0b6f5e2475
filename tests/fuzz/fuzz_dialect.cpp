// Every dialect: the first byte says which one the text is in, the second one which one it is translated to. What is
// written must be read there as the same language.

#include <heckbert/taxonomy/dialect.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  if (size < 2) return 0;
  const auto dialect = [](std::uint8_t byte) { return taxonomy::kDialects[byte % taxonomy::kDialects.size()].dialect; };
  const taxonomy::Dialect to = dialect(data[1]);
  const auto t =
      fuzz::answer([&] { return taxonomy::translate(fuzz::text_of(data + 2, size - 2), dialect(data[0]), to); });
  if (!t) return 0;
  fuzz::require(t->writing.text.empty() != t->writing.refusal.empty(), "neither written nor refused");
  if (!t->writing.text.empty())
    fuzz::require(taxonomy::read_expression(t->writing.text, to).language == t->reading.language,
                  "written and read back as another language");
  return 0;
}
