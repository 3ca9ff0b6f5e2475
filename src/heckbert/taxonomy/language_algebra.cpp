// The algebra of languages: one walk over pairs of states gives union, intersection, difference and inclusion; one
// subset construction gives concatenation, repetition and reversal.

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include <heckbert/taxonomy/determinize.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

namespace {

// Copies of an automaton that repeat() chains, times its states; beyond it the result has no hope of its budget.
constexpr std::size_t kChainBudget = 4'000'000;

// Two automata over the alphabet that both fit.
struct Common {
  Common(const Language& a, const Language& b)
      : alphabet(joined(a.alphabet(), b.alphabet())),
        in_a(columns_within(a.alphabet(), alphabet)),
        in_b(columns_within(b.alphabet(), alphabet)) {}
  Alphabet alphabet;
  std::vector<std::size_t> in_a, in_b;
};

// Walks both automata at once from their starts. Calls visit(accepts_a, accepts_b) for each reachable pair of states,
// which says whether the pair accepts; stops early when `stop_at_accepting` and one does.
template <class Visit>
std::vector<State> walk_pairs(const Language& a, const Language& b, const Common& common, Visit visit,
                              bool stop_at_accepting = false) {
  std::vector<std::pair<StateId, StateId>> pairs;
  std::unordered_map<std::uint64_t, StateId> number;
  WorkLimit work(kOperationSteps);
  const auto enter = [&](StateId p, StateId q) {
    work.spend(8);
    const auto [at, is_new] = number.try_emplace(std::uint64_t{p} << 32 | q, static_cast<StateId>(pairs.size()));
    if (is_new) {
      check_state_budget(pairs.size() + 1, common.alphabet);
      pairs.emplace_back(p, q);
    }
    return at->second;
  };
  const std::vector<std::size_t> twins = twin_columns({&a, &b}, {common.in_a, common.in_b});
  std::vector<State> states;
  enter(0, 0);
  while (states.size() < pairs.size()) {
    const auto [p, q] = pairs[states.size()];
    const State& in_a = a.states()[p];
    const State& in_b = b.states()[q];
    State state{std::vector<StateId>(common.alphabet.size()), visit(in_a.accepting, in_b.accepting)};
    for (std::size_t c = 0; c < state.next.size(); ++c)
      state.next[c] =
          twins[c] != c ? state.next[twins[c]] : enter(in_a.next[common.in_a[c]], in_b.next[common.in_b[c]]);
    const bool is_end = stop_at_accepting && state.accepting;
    states.push_back(std::move(state));
    if (is_end) break;
  }
  return states;
}

template <class Visit>
Language combined(const Language& a, const Language& b, Visit visit) {
  const Common common(a, b);
  return Language::from_automaton(walk_pairs(a, b, common, visit), common.alphabet);
}

// From here no string is accepted; minimal automata have at most one such state.
std::vector<bool> dead_states(const Language& a) {
  std::vector<bool> dead(a.states().size());
  for (StateId q = 0; q < dead.size(); ++q) {
    const State& s = a.states()[q];
    dead[q] = !s.accepting;
    for (const StateId to : s.next) dead[q] = dead[q] && to == q;
  }
  return dead;
}

std::vector<std::size_t> own_twins(const Language& a) {
  return twin_columns({&a}, {columns_within(a.alphabet(), a.alphabet())});
}

}  // namespace

std::vector<std::size_t> twin_columns(const std::vector<const Language*>& automata,
                                      const std::vector<std::vector<std::size_t>>& within) {
  for (const Language* automaton : automata)
    WorkLimit(kOperationSteps).spend(automaton->states().size() * within[0].size() / 4);
  const auto are_twins = [&](std::size_t c, std::size_t d) {
    for (std::size_t i = 0; i < automata.size(); ++i) {
      const std::size_t in_c = within[i][c], in_d = within[i][d];
      for (const State& state : automata[i]->states())
        if (state.next[in_c] != state.next[in_d]) return false;
    }
    return true;
  };
  std::vector<std::size_t> twins(within[0].size()), firsts;
  for (std::size_t c = 0; c < twins.size(); ++c) {
    const auto twin = std::find_if(firsts.begin(), firsts.end(), [&](std::size_t d) { return are_twins(d, c); });
    twins[c] = twin == firsts.end() ? c : *twin;
    if (twin == firsts.end()) firsts.push_back(c);
  }
  return twins;
}

Language operator|(const Language& a, const Language& b) {
  return combined(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
}

Language operator&(const Language& a, const Language& b) {
  return combined(a, b, [](bool in_a, bool in_b) { return in_a && in_b; });
}

Language operator-(const Language& a, const Language& b) {
  return combined(a, b, [](bool in_a, bool in_b) { return in_a && !in_b; });
}

Language operator!(const Language& a) {
  return Language::universe() - a;
}

bool Language::is_subset_of(const Language& other) const {
  const auto walked = walk_pairs(
      *this, other, Common(*this, other), [](bool in_a, bool in_b) { return in_a && !in_b; }, true);
  return !walked.back().accepting;
}

Language concat(const Language& a, const Language& b) {
  const auto size_a = static_cast<StateId>(a.states().size());
  const auto size_b = static_cast<StateId>(b.states().size());
  const std::vector<bool> dead_a = dead_states(a), dead_b = dead_states(b);
  const auto enter_a = [&](StateId q, Subset& to) {
    if (!dead_a[q]) to.insert(q);
    if (a.states()[q].accepting && !dead_b[0]) to.insert(size_a);
  };
  const Common common(a, b);
  return determinize(
      std::size_t{size_a} + size_b, common.alphabet, twin_columns({&a, &b}, {common.in_a, common.in_b}),
      [&](Subset& to) { enter_a(0, to); },
      [&](StateId q, std::size_t c, Subset& to) {
        if (q < size_a) return enter_a(a.states()[q].next[common.in_a[c]], to);
        const StateId next = b.states()[q - size_a].next[common.in_b[c]];
        if (!dead_b[next]) to.insert(size_a + next);
      },
      [&](StateId q) { return q >= size_a && b.states()[q - size_a].accepting; });
}

namespace {

// Two strings of the language make one of it, as those of X+ do; repeated, it stays what it is. Asked of small automata
// only, where the answer costs little.
bool is_closed(const Language& a) {
  constexpr std::size_t kSmall = 16;
  return a.states().size() <= kSmall && concat(a, a).is_subset_of(a);
}

}  // namespace

Language repeat(const Language& a, unsigned at_least, std::optional<unsigned> at_most) {
  if (at_most && *at_most < at_least) return Language::none();
  if (at_most && *at_most == 0) return Language::epsilon();
  if (at_least == 0) return Language::epsilon() | repeat(a, 1, at_most);
  // Where a piece may be empty any count can be made up, so only the other pieces are counted.
  if (a.states()[0].accepting) {
    const Language pieces = a - Language::epsilon();
    return is_closed(pieces) ? a : Language::epsilon() | repeat(pieces, 1, at_most);
  }

  // A chain of copies; accepting in one enters the next, and without an upper bound the last enters itself.
  const auto size = static_cast<StateId>(a.states().size());
  const std::size_t copies = at_most.value_or(at_least);
  if (copies * size > kChainBudget)
    throw LimitError("it repeats an automaton of " + std::to_string(size) + " states " + std::to_string(copies) +
                     " times");
  const std::vector<bool> dead = dead_states(a);
  const auto enter = [&](std::size_t copy, StateId q, Subset& to) {
    if (dead[q]) return;
    to.insert(static_cast<StateId>(copy * size + q));
    if (!a.states()[q].accepting || (at_most && copy + 1 == copies)) return;
    to.insert(static_cast<StateId>(std::min(copy + 1, copies - 1) * size));
  };
  return determinize(
      copies * size, a.alphabet(), own_twins(a), [&](Subset& to) { enter(0, 0, to); },
      [&](StateId q, std::size_t c, Subset& to) { enter(q / size, a.states()[q % size].next[c], to); },
      [&](StateId q) { return q / size + 1 >= at_least && a.states()[q % size].accepting; });
}

Language reverse(const Language& a) {
  const std::size_t size = a.states().size(), columns = a.alphabet().size();
  std::vector<std::vector<StateId>> before(size * columns);
  for (StateId q = 0; q < size; ++q)
    for (std::size_t c = 0; c < columns; ++c) before[a.states()[q].next[c] * columns + c].push_back(q);
  return determinize(
      size, a.alphabet(), own_twins(a),
      [&](Subset& to) {
        for (StateId q = 0; q < size; ++q)
          if (a.states()[q].accepting) to.insert(q);
      },
      [&](StateId q, std::size_t c, Subset& to) {
        for (const StateId from : before[q * columns + c]) to.insert(from);
      },
      [](StateId q) { return q == 0; });
}

Language inverse_image(const Language& a, const std::array<Symbol, kSymbolCount>& h) {
  std::vector<State> states = a.states();
  for (StateId q = 0; q < states.size(); ++q)
    for (std::size_t c = 0; c < states[q].next.size(); ++c) {
      const Symbol image = h[index(Alphabet::symbol(c))];
      states[q].next[c] = a.states()[q].next[Alphabet::column(image, Alphabet::class_of_column(c))];
    }
  return Language::from_automaton(states, a.alphabet());
}

}  // namespace heckbert::taxonomy
