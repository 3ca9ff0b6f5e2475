#pragma once
// Many languages asked at once: one product automaton whose states carry the set of languages that accept there, so a
// word is walked once whatever the number of languages. When the product would outgrow its budget the languages are
// split into groups, each with its own automaton; the answer is the same.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// Bit i is set when language i contains the word.
using Membership = std::vector<bool>;

class Classifier {
 public:
  /// `state_budget`: states one product automaton may have; at least the largest single language is always taken.
  explicit Classifier(std::span<const Language> languages, std::size_t state_budget = kStateBudget);
  Membership classify(const Word& word) const;  ///< cost: one table step per letter and group
  std::size_t language_count() const { return language_count_; }
  std::size_t group_count() const { return groups_.size(); }

 private:
  struct Group {
    std::size_t first = 0;  ///< index of its first language
    std::size_t count = 0;
    std::vector<std::array<StateId, kSymbolCount>> next;
    std::vector<std::vector<bool>> accepts;  ///< by state, then by language of the group
  };
  // The product of these languages, or nothing when it exceeds the budget.
  static std::optional<Group> product(std::span<const Language> languages, std::size_t first, std::size_t state_budget);
  void add_groups(std::span<const Language> languages, std::size_t first, std::size_t state_budget);

  std::size_t language_count_ = 0;
  std::vector<Group> groups_;
};

}  // namespace heckbert::taxonomy
