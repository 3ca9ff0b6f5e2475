#include <heckbert/taxonomy/live.h>

#include <algorithm>

namespace heckbert::taxonomy {

bool is_dead(const Language& language, StateId state) {
  const State& s = language.states()[state];
  return !s.accepting && std::all_of(s.next.begin(), s.next.end(), [state](StateId to) { return to == state; });
}

std::map<StateId, LetterSet> moves(const Language& language, StateId state) {
  const std::vector<StateId>& next = language.states()[state].next;
  std::map<StateId, std::vector<std::size_t>> columns;
  for (std::size_t c = 0; c < next.size(); ++c)
    if (!is_dead(language, next[c])) columns[next[c]].push_back(c);
  std::map<StateId, LetterSet> letters;
  for (const auto& [to, leading] : columns) letters[to] = language.alphabet().letters(leading);
  return letters;
}

LetterSet going_on(const Language& language, StateId state) {
  LetterSet all;
  for (const auto& [to, letters] : moves(language, state)) all |= letters;
  return all;
}

SymbolSet symbols_of(const Language& language) {
  SymbolSet all = 0;
  for (StateId q = 0; q < language.states().size(); ++q)
    all = static_cast<SymbolSet>(all | going_on(language, q).symbols());
  return all;
}

}  // namespace heckbert::taxonomy
