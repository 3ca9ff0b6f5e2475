#pragma once
// Canonical automata. Two automata accept the same language exactly when their minimal automata are the same up to the
// names of states; numbering the states breadth-first in the order of the alphabet fixes the names too.

#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// The minimal complete automaton of the same language, reachable states only, numbered breadth-first from the start in
/// the order of columns. Takes any complete automaton whose start is state 0. Cost: O(n log n).
/// Source: Hopcroft 1971, "An n log n algorithm for minimizing states in a finite automaton".
std::vector<State> minimize(const std::vector<State>& states);

}  // namespace heckbert::taxonomy
