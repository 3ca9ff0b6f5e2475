#pragma once
// Several languages in one automaton, whose states know which of them accept: the part of the product of their minimal
// automata that can be reached. It is minimal as it stands: two of its states differ in a language whose two states
// have different futures. Fusing two at a time, small ones first, visits only states that are needed in the end.
//
// The table is laid out for walking. Letters that no language tells apart share a column; a row is a power of two of
// 16-bit entries, so that a step is a shift and one load, and ends in the outcome of its state: the number of the set
// of languages that accept there. States are numbered breadth-first, so the short words that most paths are lie
// together.

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

  StateId step(StateId at, std::size_t column) const { return table_[(std::size_t{at} << row_shift_) + column]; }
  std::size_t outcome(StateId at) const { return table_[(std::size_t{at} << row_shift_) + column_count_]; }
  std::size_t state_count() const { return table_.size() >> row_shift_; }
  std::size_t outcome_count() const { return members_.size() / blocks_; }
  std::span<const std::uint64_t> members(std::size_t outcome) const {
    return {members_.data() + outcome * blocks_, blocks_};
  }
  std::size_t table_bytes() const { return table_.size() * sizeof table_[0]; }

  /// Both in one; nothing when that takes more than `state_budget` states. The two share their columns and have no
  /// language in common.
  friend std::optional<FusedAutomaton> fuse(const FusedAutomaton& a, const FusedAutomaton& b, std::size_t state_budget);

 private:
  FusedAutomaton(std::size_t column_count, std::size_t language_total);
  /// Appends a row; the caller fills in its steps and its outcome.
  std::span<std::uint16_t> add_row();

  std::size_t column_count_;
  unsigned row_shift_;                  ///< a row has 1 << row_shift_ entries
  std::size_t blocks_;                  ///< 64-bit blocks of a set of languages
  std::vector<std::uint16_t> table_;    ///< by state: the next state by column, then the outcome
  std::vector<std::uint64_t> members_;  ///< by outcome: the languages, one bit each
};

std::optional<FusedAutomaton> fuse(const FusedAutomaton& a, const FusedAutomaton& b, std::size_t state_budget);

}  // namespace heckbert::taxonomy
