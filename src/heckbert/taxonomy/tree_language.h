#pragma once
// The language of an expression's tree whose letters are sets of our symbols, without any rule about ends: what
// native expressions mean between their ends, and what dialects mean by their text before it is cut down to whole
// paths.

#include <cstddef>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression_source.h>
#include <heckbert/taxonomy/expression_tree.h>
#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/work.h>

namespace heckbert::taxonomy {

/// A LimitError that knows which piece of the text is too large.
class PlacedLimitError : public LimitError {
 public:
  /// `is_settled`: no larger piece is to blame.
  PlacedLimitError(const LimitError& error, std::size_t offset, std::size_t length, bool is_settled)
      : LimitError(error), offset_(offset), length_(length), is_settled_(is_settled) {}
  std::size_t offset() const { return offset_; }
  std::size_t length() const { return length_; }
  bool is_settled() const { return is_settled_; }

 private:
  std::size_t offset_, length_;
  bool is_settled_;
};

/// build(), with any LimitError placed. An automaton that is too large is to blame itself. When the work runs out, the
/// smallest piece that took half of it is to blame, not whatever happened to be built last.
template <class Build>
Language place_limits(const Node& node, Build build) {
  const WorkLimit here(kUnlimitedSteps);
  const auto is_settled = [&] { return here.spent() >= kCompileSteps / 2; };
  try {
    return build();
  } catch (const PlacedLimitError& error) {
    if (error.is_settled()) throw;
    throw PlacedLimitError(error, node.offset, node.length, is_settled());
  } catch (const WorkError& error) {
    throw PlacedLimitError(error, node.offset, node.length, is_settled());
  } catch (const LimitError& error) {
    throw PlacedLimitError(error, node.offset, node.length, true);
  }
}

/// Says of the piece that it is too large, with its place in the source and what to do about it.
[[noreturn]] void throw_too_large(const ExpressionSource& source, const PlacedLimitError& error);

/// Strings of a tree of Letters, Sequence, Alternation and Repeat. Errors: PlacedLimitError.
Language language_of(const Node& tree);

/// The tree whose strings are those of `tree` turned round.
Node reversed(Node tree);

/// Whether a node of this kind is in the tree.
bool has_kind(const Node& tree, NodeKind kind);

/// Nothing but letters, sequences, alternatives and repetitions: no operators on whole paths, no names, no errors.
bool is_word_tree(const Node& tree);

}  // namespace heckbert::taxonomy
