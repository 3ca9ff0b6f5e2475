#pragma once
// The reading of a dialect's text with its tree, which the writer prefers to a tree made from the automaton.

#include <optional>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

struct ReadingWithTree {
  Reading reading;
  std::optional<Node> tree;  ///< from light to eye; nothing when it has operators on whole paths or names
};

/// Errors: as read_expression.
ReadingWithTree read_with_tree(std::string_view text, Dialect dialect, const Names& names, std::string_view source);

}  // namespace heckbert::taxonomy
