#pragma once
// What can still happen on the way through an automaton.

#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

/// No string is accepted from here. A minimal automaton has at most one such state, and it only leads to itself.
bool is_dead(const Language& language, StateId state);

/// The symbols with which some member goes on from this state.
SymbolSet going_on(const Language& language, StateId state);

/// The symbols that occur in some member.
SymbolSet symbols_of(const Language& language);

}  // namespace heckbert::taxonomy
