#pragma once
// Trees to the text of a dialect, with the letters, repetitions and precedence that it has.

#include <optional>
#include <string>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

/// A set of letters as one item of the dialect; nothing when no combination of its letters is that set.
std::optional<std::string> item_text(const LetterSet& set, const DialectFacts& dialect);

/// A tree of Letters, Sequence, Alternation and Repeat in the order in which the dialect is written; nothing when a set
/// of letters cannot be said or the text would be longer than any person reads.
std::optional<std::string> print(const Node& tree, const DialectFacts& dialect);

}  // namespace heckbert::taxonomy
