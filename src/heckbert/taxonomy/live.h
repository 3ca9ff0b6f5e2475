#pragma once
// What can still happen on the way through an automaton.

#include <map>

#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

/// No string is accepted from here. A minimal automaton has at most one such state, and it only leads to itself.
bool is_dead(const Language& language, StateId state);

/// The letters with which some member goes on from this state.
LetterSet going_on(const Language& language, StateId state);

/// The states that members go on to, with the letters that lead there.
std::map<StateId, LetterSet> moves(const Language& language, StateId state);

/// The symbols that occur in some member.
SymbolSet symbols_of(const Language& language);

}  // namespace heckbert::taxonomy
