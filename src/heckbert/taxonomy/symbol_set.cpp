#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

std::vector<Symbol> members(SymbolSet set) {
  std::vector<Symbol> list;
  for (const SymbolFacts& f : kSymbols)
    if (has(set, f.symbol)) list.push_back(f.symbol);
  return list;
}

std::string name(Symbol s) {
  std::string text(1, facts(s).letter);
  if (facts(s).subscript != 0) text += facts(s).subscript;
  return text;
}

std::string describe(SymbolSet set) {
  std::vector<std::string> names;
  for (const Symbol s : members(set)) {
    const SymbolSet whole = with_letter(facts(s).letter);
    const std::string text = (set & whole) == whole ? std::string(1, facts(s).letter) : name(s);
    if (names.empty() || names.back() != text) names.push_back(text);
  }
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += i + 1 == names.size() ? " or " : ", ";
    out += names[i];
  }
  return out;
}

}  // namespace heckbert::taxonomy
