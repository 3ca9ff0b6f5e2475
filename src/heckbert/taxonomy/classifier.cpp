#include <heckbert/taxonomy/classifier.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/label.h>

namespace heckbert::taxonomy {

namespace {

std::vector<Language> reversed(std::span<const Language> languages) {
  std::vector<Language> result;
  for (const Language& language : languages) try {
      result.push_back(reverse(language));
    } catch (const LimitError& e) {
      throw LimitError("language " + std::to_string(result.size() + 1) + " of " + std::to_string(languages.size()) +
                       ", read from the eye: " + e.what());
    }
  return result;
}

// Halves first: the automata that grow large are fused last. Halves that are in several groups themselves stay apart.
std::vector<FusedAutomaton> fuse_neighbours(std::span<const FusedAutomaton> automata, std::size_t state_budget) {
  if (automata.size() <= 1) return {automata.begin(), automata.end()};
  std::vector<FusedAutomaton> left = fuse_neighbours(automata.first(automata.size() / 2), state_budget);
  std::vector<FusedAutomaton> right = fuse_neighbours(automata.subspan(automata.size() / 2), state_budget);
  if (left.size() == 1 && right.size() == 1)
    if (auto fused = fuse(left[0], right[0], state_budget)) return {std::move(*fused)};
  left.insert(left.end(), std::make_move_iterator(right.begin()), std::make_move_iterator(right.end()));
  return left;
}

}  // namespace

Classifier::Classifier(std::span<const Language> languages, WalkFrom from, std::size_t state_budget)
    : language_count_(languages.size()), from_(from) {
  const std::vector<Language> turned = from == WalkFrom::Eye ? reversed(languages) : std::vector<Language>{};
  if (from == WalkFrom::Eye) languages = turned;
  columns_ = shared_columns(languages);
  for (const SymbolFacts& f : kSymbols)
    unlabelled_[index(f.symbol)] = columns_.of[Alphabet::column(f.symbol, label_class(kUnlabelled))];
  std::vector<FusedAutomaton> single;
  for (std::size_t i = 0; i < languages.size(); ++i) single.emplace_back(languages[i], columns_, i, languages.size());
  const std::size_t most = std::min({state_budget, kFusedStates, kTableBudget / columns_.count});
  for (FusedAutomaton& automaton : fuse_neighbours(single, most)) {
    const auto bits = static_cast<unsigned>(std::bit_width(automaton.state_count() - 1));
    groups_.push_back({std::move(automaton), prefix_bits_, (Prefix{1} << bits) - 1});
    prefix_bits_ += bits;
  }
}

Classifier::Prefix Classifier::start() const {
  if (prefix_bits_ > 64)
    throw LimitError("walking " + std::to_string(language_count_) + " languages at once takes " +
                     std::to_string(group_count()) + " groups of states, more than 64 bits; classify distinct words");
  return 0;  // the start of each group is its state 0
}

Membership Classifier::classify(const Word& word) const {
  std::vector<std::uint16_t> letters{column(word.light, word.label(0))};
  for (std::size_t i = 0; i < word.length(); ++i) letters.push_back(column(word.events[i], word.label(i + 1)));
  letters.push_back(column(word.eye, kUnlabelled));
  if (from_ == WalkFrom::Eye) std::reverse(letters.begin(), letters.end());
  Membership membership(language_count_);
  for (const Group& g : groups_) {
    StateId at = 0;
    for (const std::uint16_t letter : letters) at = g.automaton.step(at, letter);
    for_each_member(g.automaton, at, [&](std::size_t i) { membership[i] = true; });
  }
  return membership;
}

std::size_t Classifier::state_count() const {
  return std::accumulate(groups_.begin(), groups_.end(), std::size_t{0},
                         [](std::size_t sum, const Group& g) { return sum + g.automaton.state_count(); });
}

std::size_t Classifier::table_bytes() const {
  return std::accumulate(groups_.begin(), groups_.end(), std::size_t{0},
                         [](std::size_t sum, const Group& g) { return sum + g.automaton.table_bytes(); });
}

}  // namespace heckbert::taxonomy
