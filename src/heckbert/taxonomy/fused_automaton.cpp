#include <heckbert/taxonomy/fused_automaton.h>

#include <unordered_map>
#include <utility>

#include <heckbert/taxonomy/determinize.h>

namespace heckbert::taxonomy {

namespace {

// Numbers pairs in the order in which they are met.
class PairNumbering {
 public:
  std::size_t number(std::size_t a, std::size_t b) {
    const auto [at, is_new] = numbers_.try_emplace(std::uint64_t{a} << 32 | b, pairs_.size());
    if (is_new) pairs_.emplace_back(a, b);
    return at->second;
  }
  const std::vector<std::pair<std::size_t, std::size_t>>& pairs() const { return pairs_; }

 private:
  std::unordered_map<std::uint64_t, std::size_t> numbers_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace

// Refined language by language: letters stay together as long as no language sends them to different places.
Columns shared_columns(std::span<const Language> languages) {
  Columns columns;
  for (const Language& language : languages) columns.alphabet = joined(columns.alphabet, language.alphabet());
  columns.of.resize(columns.alphabet.size());
  columns.count = 1;
  for (const Language& language : languages) {
    const std::vector<std::size_t> within = columns_within(language.alphabet(), columns.alphabet);
    const std::vector<std::size_t> twins =
        twin_columns({&language}, {columns_within(language.alphabet(), language.alphabet())});
    PairNumbering refined;
    for (std::size_t c = 0; c < within.size(); ++c)
      columns.of[c] = static_cast<std::uint16_t>(refined.number(columns.of[c], twins[within[c]]));
    columns.count = refined.pairs().size();
  }
  return columns;
}

FusedAutomaton::FusedAutomaton(const Language& language, const Columns& columns, std::size_t number, std::size_t total)
    : FusedAutomaton(columns.count, total) {
  members_.resize(2 * blocks_);  // outcome 0: not a member, 1: a member
  members_[blocks_ + number / 64] = std::uint64_t{1} << number % 64;
  const std::vector<std::size_t> within = columns_within(language.alphabet(), columns.alphabet);
  for (auto& column : next_) column.resize(language.states().size());
  for (std::size_t q = 0; q < language.states().size(); ++q) {
    const State& state = language.states()[q];
    for (std::size_t c = 0; c < within.size(); ++c)
      next_[columns.of[c]][q] = static_cast<std::uint16_t>(state.next[within[c]]);
    outcomes_.push_back(state.accepting ? 1 : 0);
  }
}

std::optional<FusedAutomaton> fuse(const FusedAutomaton& a, const FusedAutomaton& b, std::size_t state_budget) {
  FusedAutomaton fused(a.next_.size(), 64 * a.blocks_);
  PairNumbering states, outcomes;
  states.number(0, 0);
  for (std::size_t i = 0; i < states.pairs().size(); ++i) {
    const auto p = static_cast<StateId>(states.pairs()[i].first), q = static_cast<StateId>(states.pairs()[i].second);
    for (std::size_t c = 0; c < fused.next_.size(); ++c)
      fused.next_[c].push_back(static_cast<std::uint16_t>(states.number(a.step(p, c), b.step(q, c))));
    if (states.pairs().size() > state_budget) return std::nullopt;
    fused.outcomes_.push_back(static_cast<std::uint16_t>(outcomes.number(a.outcome(p), b.outcome(q))));
  }
  for (const auto& [in_a, in_b] : outcomes.pairs())
    for (std::size_t block = 0; block < a.blocks_; ++block)
      fused.members_.push_back(a.members(in_a)[block] | b.members(in_b)[block]);
  return fused;
}

}  // namespace heckbert::taxonomy
