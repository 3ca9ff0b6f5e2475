#include <heckbert/taxonomy/glossy_rule.h>

namespace heckbert::taxonomy {

Language apply(GlossyRule rule, const Language& language) {
  std::array<Symbol, kSymbolCount> reading{};
  for (const SymbolFacts& f : kSymbols) reading[index(f.symbol)] = f.symbol;
  if (rule == GlossyRule::Keep) return language;
  const bool diffuse = rule == GlossyRule::Diffuse;
  reading[index(Symbol::Gr)] = diffuse ? Symbol::Dr : Symbol::Sr;
  reading[index(Symbol::Gt)] = diffuse ? Symbol::Dt : Symbol::St;
  return inverse_image(language, reading);
}

}  // namespace heckbert::taxonomy
