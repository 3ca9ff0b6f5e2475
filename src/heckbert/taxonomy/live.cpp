#include <heckbert/taxonomy/live.h>

#include <algorithm>

namespace heckbert::taxonomy {

bool is_dead(const Language& language, StateId state) {
  const State& s = language.states()[state];
  return !s.accepting && std::all_of(s.next.begin(), s.next.end(), [state](StateId to) { return to == state; });
}

SymbolSet going_on(const Language& language, StateId state) {
  return symbols_where(
      [&](const SymbolFacts& f) { return !is_dead(language, language.states()[state].next[index(f.symbol)]); });
}

SymbolSet symbols_of(const Language& language) {
  unsigned set = 0;
  for (StateId q = 0; q < language.states().size(); ++q) set |= going_on(language, q);
  return static_cast<SymbolSet>(set);
}

}  // namespace heckbert::taxonomy
