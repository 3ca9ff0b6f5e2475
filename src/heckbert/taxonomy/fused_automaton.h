#pragma once
// Several languages in one automaton, whose states know which of them accept: the part of the product of their minimal
// automata that can be reached. It is minimal as it stands: two of its states differ in a language whose two states
// have different futures. Fusing two at a time, small ones first, visits only states that are needed in the end.
//
// The table is laid out for walking. Letters that no language tells apart share a column, and the entries of a column,
// 16 bits each, lie together: where the column begins is known before the state is, so that a path waits for one load
// per step and for nothing else. States are numbered breadth-first, so the short words that most paths are share
// cache lines. The outcome of a state is the number of the set of languages that accept there.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// States a fused automaton can have: its table has 16-bit entries.
inline constexpr std::size_t kFusedStates = 65'536;
static_assert(kStateBudget <= kFusedStates, "a single language always fits");

/// The letters that some of the languages tell apart, and the column of each: equal for letters that none of them does,
/// numbered from 0.
struct Columns {
  Alphabet alphabet;
  std::vector<std::uint16_t> of;  ///< by column of the alphabet
  std::size_t count = 0;          ///< of different columns
};
Columns shared_columns(std::span<const Language> languages);

class FusedAutomaton {
 public:
  /// Language number `number` of `total`, alone.
  FusedAutomaton(const Language& language, const Columns& columns, std::size_t number, std::size_t total);

  StateId step(std::size_t at, std::size_t column) const { return next_[column][at]; }
  std::size_t outcome(std::size_t at) const { return outcomes_[at]; }
  std::size_t state_count() const { return outcomes_.size(); }
  std::size_t outcome_count() const { return members_.size() / blocks_; }
  std::span<const std::uint64_t> members(std::size_t outcome) const {
    return {members_.data() + outcome * blocks_, blocks_};
  }
  std::size_t table_bytes() const { return (next_.size() + 1) * outcomes_.size() * sizeof outcomes_[0]; }

  /// Both in one; nothing when that takes more than `state_budget` states. The two share their columns and have no
  /// language in common.
  friend std::optional<FusedAutomaton> fuse(const FusedAutomaton& a, const FusedAutomaton& b, std::size_t state_budget);

 private:
  FusedAutomaton(std::size_t column_count, std::size_t language_total)
      : blocks_((language_total + 63) / 64), next_(column_count) {}

  std::size_t blocks_;                            ///< 64-bit blocks of a set of languages
  std::vector<std::vector<std::uint16_t>> next_;  ///< by column, then by state
  std::vector<std::uint16_t> outcomes_;           ///< by state
  std::vector<std::uint64_t> members_;            ///< by outcome: the languages, one bit each
};

std::optional<FusedAutomaton> fuse(const FusedAutomaton& a, const FusedAutomaton& b, std::size_t state_budget);

}  // namespace heckbert::taxonomy
