#include <heckbert/taxonomy/dialect_letters.h>

namespace heckbert::taxonomy {

SymbolSet with_letters(std::string_view letters) {
  return symbols_where([=](const SymbolFacts& f) { return letters.find(f.letter) != std::string_view::npos; });
}

SymbolSet with_mode(char subscript) {
  return symbols_where([=](const SymbolFacts& f) { return f.role == Role::Event && f.subscript == subscript; });
}

SymbolSet symbols_of(const KindLetter& kind) {
  return with_letters(kind.kinds);
}

SymbolSet symbols_of(const LightLetter& light) {
  return symbols_where([&](const SymbolFacts& f) {
    return f.role == Role::Light && light.subscripts.find(f.subscript) != std::string_view::npos;
  });
}

SymbolSet any_of(const DialectFacts& dialect) {
  return dialect.dot_matches_ends ? kAllSymbols : kEvents;
}

std::optional<SymbolSet> kind_of(const DialectFacts& dialect, char c) {
  for (const KindLetter& kind : dialect.kinds)
    if (kind.letter != 0 && kind.letter == c) return symbols_of(kind);
  return std::nullopt;
}

std::optional<SymbolSet> type_of(const DialectFacts& dialect, char c) {
  if (c == 'R') return with_mode('r');
  if (c == 'T') return with_mode('t');
  if (c == 'V') return with_letter('V');
  if (dialect.eyes.find(c) != std::string_view::npos) return kEyes;
  for (const LightLetter& light : dialect.lights)
    if (light.text == std::string_view(&c, 1)) return symbols_of(light);
  return std::nullopt;
}

}  // namespace heckbert::taxonomy
