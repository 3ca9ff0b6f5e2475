#pragma once
// A tree of letters, sequences, alternatives and repetitions back from an automaton, by elimination of states
// (Hopcroft, Motwani, Ullman, 3.2.2), with the rules of a regular algebra applied on the way so that people can read
// it.

#include <cstddef>
#include <optional>

#include <heckbert/taxonomy/expression_tree.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// Nodes a tree may have before regular_expression() gives up.
inline constexpr std::size_t kTreeBudget = 5'000;
/// States an automaton may have before it gives up without trying.
inline constexpr std::size_t kTreeStates = 150;

/// A tree whose language is `language`, not empty. The letters of each node all lead from one state of the minimal
/// automaton to one other, so letters that the language does not tell apart stay together.
/// Gives nothing when a budget is exceeded. Cost: O(states^3) joins of trees.
std::optional<Node> regular_expression(const Language& language);

/// Trees joined, with the laws that shorten them: a|a = a, ab|ac = a(b|c), aa* = a+, and the like.
Node either(Node a, Node b);
Node sequence_of(std::vector<Node> pieces);
Node star_of(Node a);

/// Equal as written, whatever their places in a text.
bool same(const Node& a, const Node& b);

/// How many nodes the tree has.
std::size_t size_of(const Node& tree);

}  // namespace heckbert::taxonomy
