#pragma once
// Subset construction: a nondeterministic automaton, given as functions, becomes a deterministic one whose states are
// sets of its states. It may be exponentially larger, so both the number of states and the work are bounded.
// Source: Hopcroft, Motwani, Ullman, "Introduction to Automata Theory", 2.3.5.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/work.h>

namespace heckbert::taxonomy {

/// Throws LimitError when an automaton of this many states over this alphabet is larger than any may be.
inline void check_state_budget(std::size_t states, const Alphabet& alphabet) {
  const std::size_t most = std::min(kStateBudget, kTableBudget / alphabet.size());
  if (states <= most) return;
  const std::string with_labels =
      alphabet.labels.empty() ? "" : " over " + std::to_string(alphabet.labels.size()) + " labels";
  throw LimitError("the automaton needs more than " + std::to_string(most) + " states" + with_labels);
}

/// The set of states being built; each state enters once.
class Subset {
 public:
  explicit Subset(std::size_t universe) {
    work_.spend(universe / 8);
    entered_.resize(universe, 0);
  }

  /// The set is about to be looked up.
  void spend(std::size_t steps) { work_.spend(steps); }

  void clear() {
    members_.clear();
    ++round_;
  }
  /// False when q was in already.
  bool insert(StateId q) {
    work_.spend(1);
    if (entered_[q] == round_) return false;
    entered_[q] = round_;
    members_.push_back(q);
    return true;
  }
  const std::vector<StateId>& sorted() {
    std::sort(members_.begin(), members_.end());
    return members_;
  }

 private:
  std::vector<std::uint32_t> entered_;
  std::vector<StateId> members_;
  std::uint32_t round_ = 1;
  WorkLimit work_{kOperationSteps};
};

struct SubsetHash {
  std::size_t operator()(const std::vector<StateId>& set) const {
    std::size_t hash = 0xcbf29ce484222325u;
    for (const StateId q : set) hash = (hash ^ q) * 0x100000001b3u;
    return hash;
  }
};

/// For each column the first one that moves every state of all these automata to the same place. Most letters of an
/// expression come without subscripts and labels, so a few columns stand for all and the construction is several times
/// quicker. `within[i]` gives for each column of the common alphabet that of automaton i; see columns_within().
std::vector<std::size_t> twin_columns(const std::vector<const Language*>& automata,
                                      const std::vector<std::vector<std::size_t>>& within);

/// The minimal language over `alphabet` of the automaton with states 0 .. size-1 that starts in what `start(subset)`
/// inserts, goes from q with a letter of column c to what `step(q, c, subset)` inserts and accepts in q when
/// `accepts(q)`. `twins` names for each column an earlier one with the same steps, or itself. Errors: LimitError beyond
/// kStateBudget states or kTableBudget moves in the
/// result, or when the work runs out.
template <class Start, class Step, class Accepts>
Language determinize(std::size_t size, const Alphabet& alphabet, const std::vector<std::size_t>& twins, Start start,
                     Step step, Accepts accepts) {
  Subset subset(size);
  std::unordered_map<std::vector<StateId>, StateId, SubsetHash> number;
  std::vector<const std::vector<StateId>*> sets;  // keys of `number`, which do not move
  std::vector<State> states;
  const auto enter = [&] {
    const auto [at, is_new] = number.try_emplace(subset.sorted(), static_cast<StateId>(sets.size()));
    if (is_new) {
      check_state_budget(sets.size() + 1, alphabet);
      sets.push_back(&at->first);
    }
    return at->second;
  };
  start(subset);
  enter();
  while (states.size() < sets.size()) {
    const std::vector<StateId>& set = *sets[states.size()];
    State state{std::vector<StateId>(alphabet.size()), false};
    for (const StateId q : set) state.accepting = state.accepting || accepts(q);
    for (std::size_t c = 0; c < alphabet.size(); ++c) {
      if (twins[c] != c) {
        state.next[c] = state.next[twins[c]];
        continue;
      }
      subset.clear();
      subset.spend(4 + set.size());
      for (const StateId q : set) step(q, c, subset);
      state.next[c] = enter();
    }
    states.push_back(std::move(state));
  }
  return Language::from_automaton(states, alphabet);
}

}  // namespace heckbert::taxonomy
