#pragma once
// The reading of a dialect's text with its tree, which the writer prefers to a tree made from the automaton.

#include <optional>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

struct ReadingWithTree {
  Reading reading;
  /// Whole paths run from light to eye; above them stand operators on whole paths, beside them names. Nothing where the
  /// paths of a dialect that may be written either way do not all run the same way.
  std::optional<Node> tree;
};

/// Errors: as read_expression.
ReadingWithTree read_with_tree(std::string_view text, Dialect dialect, const Names& names, std::string_view source);

}  // namespace heckbert::taxonomy
