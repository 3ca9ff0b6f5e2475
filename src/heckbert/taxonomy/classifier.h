#pragma once
// Many languages asked at once, while a path is walked or afterwards. The languages are fused into one automaton
// (fused_automaton.h) whose states know which of them accept, so a path carries one small integer and pays one table
// step per event, whatever the number of languages:
//
//   const Classifier classifier(languages, WalkFrom::Eye);
//   const auto eye = classifier.step(classifier.start(), Symbol::Ep);  // once: every path begins at this pinhole,
//   const auto at = classifier.step(eye, Symbol::Dr);                   // scatters,
//   const auto lit = classifier.step(at, Symbol::La);                   // and a shadow ray finds an area light:
//   classifier.for_each_member(lit, [&](std::size_t i) { image[i] += value; });
//
// The rule when fusing does not pay. Independent questions multiply: twenty of the kind "touches object i" have a
// million states together. Languages are therefore fused pair by pair, neighbours first, as long as a fused automaton
// stays within the state budget; what would exceed it stays apart, as groups that are evaluated side by side (a
// product), one table step per event and group. The states of all groups are packed into one 64-bit integer. Where
// even that is too small, walking is refused with a LimitError and classify() still answers: the thing to do then is
// to carry words (word_trie.h) and classify each distinct one once.
//
// Immutable once built, so threads may share one.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/fused_automaton.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// Bit i is set when language i contains the word.
using Membership = std::vector<bool>;

/// Which end of a path is met first: walking from the eye asks the reversed languages of words, not other words.
enum class WalkFrom : std::uint8_t { Light, Eye };

class Classifier {
 public:
  /// What was walked of a path so far, one small integer to copy wherever the path branches. With one group these are
  /// the numbers 0, 1, ... of the states of the fused automaton.
  using Prefix = std::uint64_t;

  /// `state_budget`: states that a fused automaton may have, at most kFusedStates; one language alone is always taken.
  /// Cost: O(states) table rows per fusion. Errors: LimitError when a language read from the eye exceeds kStateBudget.
  explicit Classifier(std::span<const Language> languages, WalkFrom from = WalkFrom::Light,
                      std::size_t state_budget = kStateBudget);

  /// Nothing walked yet; the first step is the end that the walk starts from. Errors: LimitError when the groups do not
  /// fit a Prefix.
  Prefix start() const;
  /// One letter without a label further. Cost: one table step per group.
  Prefix step(Prefix at, Symbol symbol) const { return step_column(at, unlabelled_[index(symbol)]); }
  /// One letter further, with a label of this class; what a renderer asks of its objects' names once, beforehand.
  Prefix step(Prefix at, Symbol symbol, std::size_t label_class) const {
    return step_column(at, columns_.of[Alphabet::column(symbol, label_class)]);
  }
  /// Labels that no language singles out are all of one class; so is having none, unless '' is singled out.
  std::size_t label_class(std::string_view label) const { return columns_.alphabet.class_of(label); }
  /// Calls f(i) for each language i that contains the word walked, in ascending order.
  template <class F>
  void for_each_member(Prefix word, F f) const {
    for (const Group& g : groups_) for_each_member(g.automaton, g.state(word), f);
  }

  Membership classify(const Word& word) const;  ///< any number of groups; cost: one table step per letter and group

  std::size_t language_count() const { return language_count_; }
  std::size_t group_count() const { return groups_.size(); }
  std::size_t state_count() const;  ///< of all groups
  std::size_t table_bytes() const;  ///< of all groups

  /// The sets of languages that share some word of group g, numbered from 0, the empty set included. A picture per
  /// outcome holds the picture of every language of the group as a sum, at one addition per path.
  std::size_t outcome_count(std::size_t group) const { return groups_[group].automaton.outcome_count(); }
  std::size_t outcome(Prefix word, std::size_t group) const {
    return groups_[group].automaton.outcome(groups_[group].state(word));
  }
  /// Bit i % 64 of element i / 64 is set when language i is in the outcome.
  std::span<const std::uint64_t> members(std::size_t outcome, std::size_t group) const {
    return groups_[group].automaton.members(outcome);
  }

 private:
  struct Group {
    FusedAutomaton automaton;
    unsigned low_bit = 0;  ///< where its state lies in a Prefix
    Prefix mask = 0;       ///< of its state, shifted down
    std::size_t state(Prefix at) const { return at >> low_bit & mask; }
  };

  template <class F>
  static void for_each_member(const FusedAutomaton& automaton, std::size_t state, F f) {
    const auto bits = automaton.members(automaton.outcome(state));
    for (std::size_t block = 0; block < bits.size(); ++block)
      for (std::uint64_t rest = bits[block]; rest != 0; rest &= rest - 1)
        f(64 * block + static_cast<std::size_t>(std::countr_zero(rest)));
  }

  std::uint16_t column(Symbol symbol, std::string_view label) const {
    return label.empty() ? unlabelled_[index(symbol)] : columns_.of[Alphabet::column(symbol, label_class(label))];
  }
  Prefix step_column(Prefix at, std::size_t column) const {
    if (groups_.size() == 1) [[likely]]
      return groups_[0].automaton.step(at, column);
    Prefix next = 0;
    for (const Group& g : groups_) next |= Prefix{g.automaton.step(g.state(at), column)} << g.low_bit;
    return next;
  }

  std::size_t language_count_ = 0;
  WalkFrom from_;
  Columns columns_;
  std::array<std::uint16_t, kSymbolCount> unlabelled_{};  ///< the column of each symbol without a label
  std::vector<Group> groups_;
  unsigned prefix_bits_ = 0;  ///< that the states of all groups take
};

}  // namespace heckbert::taxonomy
