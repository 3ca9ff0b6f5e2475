#include <heckbert/taxonomy/classifier.h>

#include <map>

namespace heckbert::taxonomy {

std::optional<Classifier::Group> Classifier::product(std::span<const Language> languages, std::size_t first,
                                                     std::size_t state_budget) {
  Group group{first, languages.size(), {}, {}};
  std::map<std::vector<StateId>, StateId> number;
  std::vector<std::vector<StateId>> tuples;
  const auto enter = [&](const std::vector<StateId>& tuple) {
    const auto [at, is_new] = number.try_emplace(tuple, static_cast<StateId>(tuples.size()));
    if (is_new) tuples.push_back(tuple);
    return at->second;
  };
  enter(std::vector<StateId>(languages.size(), 0));
  std::vector<StateId> next(languages.size());
  for (std::size_t i = 0; i < tuples.size(); ++i) {
    // One language alone is no product: its automaton is as large as it is.
    if (tuples.size() > state_budget && languages.size() > 1) return std::nullopt;
    group.next.emplace_back();
    for (std::size_t s = 0; s < kSymbolCount; ++s) {
      for (std::size_t k = 0; k < languages.size(); ++k) next[k] = languages[k].states()[tuples[i][k]].next[s];
      group.next[i][s] = enter(next);
    }
    group.accepts.emplace_back(languages.size());
    for (std::size_t k = 0; k < languages.size(); ++k)
      group.accepts[i][k] = languages[k].states()[tuples[i][k]].accepting;
  }
  return group;
}

void Classifier::add_groups(std::span<const Language> languages, std::size_t first, std::size_t state_budget) {
  if (languages.empty()) return;
  if (auto group = product(languages, first, state_budget)) {
    groups_.push_back(std::move(*group));
    return;
  }
  const std::size_t half = languages.size() / 2;
  add_groups(languages.first(half), first, state_budget);
  add_groups(languages.subspan(half), first + half, state_budget);
}

Classifier::Classifier(std::span<const Language> languages, std::size_t state_budget)
    : language_count_(languages.size()) {
  add_groups(languages, 0, state_budget);
}

Membership Classifier::classify(const Word& word) const {
  Membership membership(language_count_);
  for (const Group& group : groups_) {
    StateId q = group.next[0][index(word.light)];
    for (const Symbol s : word.events) q = group.next[q][index(s)];
    q = group.next[q][index(word.eye)];
    for (std::size_t k = 0; k < group.count; ++k) membership[group.first + k] = group.accepts[q][k];
  }
  return membership;
}

}  // namespace heckbert::taxonomy
