#pragma once
// The reading of a dialect's text with its tree, which the writer prefers to a tree made from the automaton.

#include <optional>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

struct ReadingWithTree {
  Reading reading;
  Node tree;  ///< whole paths run from light to eye; above them stand operators on whole paths, beside them names
};

/// Errors: as read_expression.
ReadingWithTree read_with_tree(std::string_view text, Dialect dialect, const Names& names, std::string_view source);

}  // namespace heckbert::taxonomy
