#pragma once
// The ends of a word expression. Every string of a path expression must be a whole path, light ... eye or eye ...
// light; this is decided on the tree before any automaton is built, so that each misplaced end is found at its letter.
//
// What may stand first, last and next to each other is computed as for position automata (Glushkov 1961). A language is
// within L (D|G|S|V)* E exactly when every neighbourhood of a letter is allowed there, so the check is exact.

#include <cstdint>
#include <optional>

#include <heckbert/taxonomy/expression_source.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

enum class Direction : std::uint8_t { LightToEye, EyeToLight };

/// Which way the words of this tree of Letters, Sequence, Alternation and Repeat run; nothing when some of its words
/// are not whole paths, which is then reported in the source.
std::optional<Direction> check_ends(const Node& word, ExpressionSource& source);

}  // namespace heckbert::taxonomy
