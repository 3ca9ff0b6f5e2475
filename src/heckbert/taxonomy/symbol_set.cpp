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

std::vector<std::string> names_of(SymbolSet set) {
  std::vector<std::string> names;
  for (const Symbol s : members(set)) {
    const SymbolSet whole = with_letter(facts(s).letter);
    const std::string text = (set & whole) == whole ? std::string(1, facts(s).letter) : name(s);
    if (names.empty() || names.back() != text) names.push_back(text);
  }
  return names;
}

namespace {

std::string spelled(SymbolSet set) {
  std::string text;
  for (const std::string& n : names_of(set)) text += n;
  return text;
}

}  // namespace

std::string write(SymbolSet set) {
  if (set == kEvents) return ".";
  constexpr SymbolSet kNotSpecular = with_letter('D') | with_letter('G');
  if (set == kNotSpecular) return "N";
  if (set == (kNotSpecular | with_letter('S'))) return "X";
  if (names_of(set).size() == 1) return names_of(set).front();
  const std::string plain = "[" + spelled(set) + "]";
  if ((set & ~kEvents) != 0) return plain;
  const std::string negated = "[^" + spelled(static_cast<SymbolSet>(kEvents & ~set)) + "]";
  return negated.size() < plain.size() ? negated : plain;
}

std::string describe(SymbolSet set) {
  const std::vector<std::string> names = names_of(set);
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += i + 1 == names.size() ? " or " : ", ";
    out += names[i];
  }
  return out;
}

}  // namespace heckbert::taxonomy
