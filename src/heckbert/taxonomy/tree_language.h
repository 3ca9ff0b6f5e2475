#pragma once
// The language of an expression's tree whose letters are sets of our symbols, without any rule about ends: what
// dialects mean by their text before it is cut down to whole paths.

#include <heckbert/taxonomy/expression_tree.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// Strings of a tree of Letters, Sequence, Alternation and Repeat. Errors: LimitError.
Language language_of(const Node& tree);

/// The tree whose strings are those of `tree` turned round.
Node reversed(Node tree);

/// Whether a node of this kind is in the tree.
bool has_kind(const Node& tree, NodeKind kind);

/// Nothing but letters, sequences, alternatives and repetitions: no operators on whole paths, no names, no errors.
bool is_word_tree(const Node& tree);

}  // namespace heckbert::taxonomy
