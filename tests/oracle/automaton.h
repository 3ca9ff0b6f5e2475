#pragma once
// Slow and simple twins of the automata: the deterministic automaton of an expression by derivatives of sets of
// positions, written down without any merging, and minimisation by filling in the table of distinguishable pairs
// (Hopcroft, Motwani, Ullman 4.4.1), O(n^2) rounds over O(n^2) pairs.

#include <vector>

#include <heckbert/taxonomy/language.h>

#include "oracle/regex.h"

namespace heckbert::oracle {

/// A complete automaton of L (regex) E over the thirteen symbols, not minimal.
std::vector<taxonomy::State> automaton_of(const Regex& regex);

/// The minimal automaton, states numbered breadth-first from the start in the order of Symbol.
std::vector<taxonomy::State> minimize_by_table(const std::vector<taxonomy::State>& states);

/// The same by reversing and determinising twice (Brzozowski 1962), with no merging of states anywhere.
std::vector<taxonomy::State> minimize_by_reversal(const std::vector<taxonomy::State>& states);

}  // namespace heckbert::oracle
