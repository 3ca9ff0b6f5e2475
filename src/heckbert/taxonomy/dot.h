#pragma once
// The minimal automaton as a drawing for Graphviz.

#include <string>
#include <string_view>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// A digraph in the DOT language: one edge for all symbols between two states, labelled as an expression writes them;
/// the state from which nothing matches is left out.
std::string dot(const Language& language, std::string_view title);

/// The text as a string of the DOT language, quotes included.
std::string dot_string(std::string_view text);

}  // namespace heckbert::taxonomy
