#pragma once
// Subset construction: a nondeterministic automaton, given as functions, becomes a deterministic one whose states are
// sets of its states. It may be exponentially larger, so both the number of states and the work are bounded.
// Source: Hopcroft, Motwani, Ullman, "Introduction to Automata Theory", 2.3.5.

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <unordered_map>
#include <vector>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// Moves of the nondeterministic automaton that subset construction may follow: a fraction of a second.
inline constexpr std::size_t kMoveBudget = 10'000'000;

[[noreturn]] inline void throw_state_limit() {
  throw LimitError("the automaton needs more than " + std::to_string(kStateBudget) + " states");
}

/// The set of states being built; each state enters once.
class Subset {
 public:
  explicit Subset(std::size_t universe) : entered_(universe, 0) {}

  void clear() {
    members_.clear();
    ++round_;
  }
  /// False when q was in already.
  bool insert(StateId q) {
    if (++moves_ > kMoveBudget)
      throw LimitError("building the automaton takes more than " + std::to_string(kMoveBudget) + " steps");
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
  std::size_t moves_ = 0;
};

struct SubsetHash {
  std::size_t operator()(const std::vector<StateId>& set) const {
    std::size_t hash = 0xcbf29ce484222325u;
    for (const StateId q : set) hash = (hash ^ q) * 0x100000001b3u;
    return hash;
  }
};

/// For each symbol the first one that moves every state of all these automata to the same place. Most letters of an
/// expression come without subscripts, so a few symbols stand for all and the construction is several times quicker.
std::array<Symbol, kSymbolCount> twin_symbols(std::initializer_list<const Language*> automata);

/// The minimal language of the automaton with states 0 .. size-1 that starts in what `start(subset)` inserts, goes from
/// q with symbol s to what `step(q, s, subset)` inserts and accepts in q when `accepts(q)`.
/// `twins` may name for each symbol an earlier one with the same steps. Errors: LimitError beyond kStateBudget states
/// or kMoveBudget insertions.
template <class Start, class Step, class Accepts>
Language determinize(std::size_t size, const std::array<Symbol, kSymbolCount>& twins, Start start, Step step,
                     Accepts accepts) {
  Subset subset(size);
  std::unordered_map<std::vector<StateId>, StateId, SubsetHash> number;
  std::vector<const std::vector<StateId>*> sets;  // keys of `number`, which do not move
  std::vector<State> states;
  const auto enter = [&] {
    const auto [at, is_new] = number.try_emplace(subset.sorted(), static_cast<StateId>(sets.size()));
    if (is_new) {
      if (sets.size() >= kStateBudget) throw_state_limit();
      sets.push_back(&at->first);
    }
    return at->second;
  };
  start(subset);
  enter();
  while (states.size() < sets.size()) {
    const std::vector<StateId>& set = *sets[states.size()];
    State state;
    for (const StateId q : set) state.accepting = state.accepting || accepts(q);
    for (const SymbolFacts& f : kSymbols) {
      if (const Symbol twin = twins[index(f.symbol)]; twin != f.symbol) {
        state.next[index(f.symbol)] = state.next[index(twin)];
        continue;
      }
      subset.clear();
      for (const StateId q : set) step(q, f.symbol, subset);
      state.next[index(f.symbol)] = enter();
    }
    states.push_back(state);
  }
  return Language::from_automaton(states);
}

}  // namespace heckbert::taxonomy
