#include "oracle/random_regex.h"

#include <utility>

namespace heckbert::oracle {

namespace {

using Kind = Regex::Kind;

RegexPtr make(Regex regex) {
  return std::make_shared<const Regex>(std::move(regex));
}

RegexPtr random_leaf(std::string_view letters, const Bits& bits) {
  if (bits() % 4 != 0) return make({Kind::Letter, letters[bits() % letters.size()], nullptr, nullptr});
  std::string chosen;
  for (const char letter : letters)
    if (bits() % 2 == 0 && chosen.find(letter) == std::string::npos) chosen += letter;
  if (chosen.empty()) chosen = letters.front();
  return make({.kind = Kind::Set, .letters = std::move(chosen)});
}

}  // namespace

RegexPtr random_regex(std::size_t nodes, std::string_view letters, const Bits& bits) {
  if (nodes < 2) return random_leaf(letters, bits);
  // Half of all operators have two operands, so that trees branch.
  if (nodes >= 3 && bits() % 2 == 0) {
    const std::size_t left_nodes = 1 + bits() % (nodes - 2);
    RegexPtr left = random_regex(left_nodes, letters, bits);
    RegexPtr right = random_regex(nodes - 1 - left_nodes, letters, bits);
    return make({bits() % 2 == 0 ? Kind::Concat : Kind::Either, 0, std::move(left), std::move(right)});
  }
  RegexPtr child = random_regex(nodes - 1, letters, bits);
  constexpr Kind kOperators[] = {Kind::Star, Kind::Plus, Kind::Option, Kind::Repeat};
  Regex regex{kOperators[bits() % std::size(kOperators)], 0, std::move(child), nullptr};
  if (regex.kind == Kind::Repeat) {
    regex.at_least = static_cast<unsigned>(bits() % 3);
    if (bits() % 3 != 0) regex.at_most = regex.at_least + static_cast<unsigned>(bits() % 2);
    // {0} leaves nothing of its operand.
    if (regex.at_most == 0u) regex.at_most = 1;
  }
  return make(std::move(regex));
}

std::vector<RegexPtr> smaller(const RegexPtr& regex) {
  std::vector<RegexPtr> list;
  if (regex->kind == Kind::Set)
    for (const char letter : regex->letters) list.push_back(make({Kind::Letter, letter, nullptr, nullptr}));
  for (const RegexPtr& child : {regex->left, regex->right})
    if (child) list.push_back(child);
  if (regex->kind == Kind::Repeat && regex->at_least > 0) {
    Regex fewer = *regex;
    --fewer.at_least;
    if (fewer.at_most && *fewer.at_most > 1) --*fewer.at_most;
    list.push_back(make(std::move(fewer)));
  }
  for (const auto side : {&Regex::left, &Regex::right})
    if ((*regex).*side)
      for (const RegexPtr& child : smaller((*regex).*side)) {
        Regex changed = *regex;
        changed.*side = child;
        list.push_back(make(std::move(changed)));
      }
  return list;
}

}  // namespace heckbert::oracle
