#include <heckbert/taxonomy/joins.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include <heckbert/taxonomy/determinize.h>
#include <heckbert/taxonomy/live.h>

namespace heckbert::taxonomy {

namespace {

// The automata of all parts side by side, their states numbered one after the other, over the letters that any of them
// tells apart.
class SideBySide {
 public:
  explicit SideBySide(std::span<const Language* const> parts) {
    std::unordered_map<const Language*, std::size_t> known;
    for (const Language* part : parts) {
      const auto [at, is_new] = known.try_emplace(part, kinds_.size());
      if (is_new) kinds_.push_back({part, {}, dead_state(*part)});
      for (std::size_t q = 0; q < part->states().size(); ++q) part_of_.push_back(parts_.size());
      parts_.push_back({at->second, size_});
      size_ += static_cast<StateId>(part->states().size());
    }
    join_alphabets();
  }

  std::size_t size() const { return size_; }
  std::size_t part_count() const { return parts_.size(); }
  std::size_t part_of(StateId q) const { return part_of_[q]; }
  const Alphabet& alphabet() const { return alphabet_; }

  StateId start(std::size_t part) const { return parts_[part].first; }
  bool is_accepting(StateId q) const { return state(q).accepting; }
  bool is_dead(StateId q) const { return kind(q).dead == local(q); }
  StateId next(StateId q, std::size_t column) const {
    return parts_[part_of_[q]].first + state(q).next[kind(q).columns[column]];
  }
  std::vector<std::size_t> twins() const {
    std::vector<const Language*> automata;
    std::vector<std::vector<std::size_t>> within;
    for (const Kind& kind : kinds_) {
      automata.push_back(kind.language);
      within.push_back(kind.columns);
    }
    return twin_columns(automata, within);
  }

 private:
  static constexpr StateId kNone = ~StateId{0};

  struct Kind {
    const Language* language;
    std::vector<std::size_t> columns;  ///< of its alphabet, by column of the common one
    StateId dead;                      ///< kNone when every state leads to some member
  };
  struct Part {
    std::size_t kind;
    StateId first;  ///< its start
  };

  static StateId dead_state(const Language& language) {
    for (StateId q = 0; q < language.states().size(); ++q)
      if (heckbert::taxonomy::is_dead(language, q)) return q;
    return kNone;
  }

  void join_alphabets() {
    std::vector<std::string>& labels = alphabet_.labels;
    for (const Kind& kind : kinds_) {
      const std::vector<std::string>& own = kind.language->alphabet().labels;
      labels.insert(labels.end(), own.begin(), own.end());
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    WorkLimit(kOperationSteps).spend(kinds_.size() * alphabet_.size());
    for (Kind& kind : kinds_) kind.columns = columns_within(kind.language->alphabet(), alphabet_);
  }

  const Kind& kind(StateId q) const { return kinds_[parts_[part_of_[q]].kind]; }
  StateId local(StateId q) const { return q - parts_[part_of_[q]].first; }
  const State& state(StateId q) const { return kind(q).language->states()[local(q)]; }

  std::vector<Kind> kinds_;
  std::vector<Part> parts_;
  std::vector<std::size_t> part_of_;
  StateId size_ = 0;
  Alphabet alphabet_;
};

}  // namespace

Language concat(std::span<const Language* const> parts) {
  if (parts.empty()) return Language::epsilon();
  if (std::any_of(parts.begin(), parts.end(), [](const Language* part) { return part->is_empty(); })) return {};
  if (parts.size() == 1) return *parts[0];
  const SideBySide all(parts);
  // Where one part may end the next may begin; where that may be empty, the one after it too.
  const auto enter = [&](StateId q, Subset& to) {
    if (all.is_dead(q)) return;
    std::size_t part = all.part_of(q);
    while (to.insert(q) && all.is_accepting(q) && ++part < all.part_count()) q = all.start(part);
  };
  return determinize(
      all.size(), all.alphabet(), all.twins(), [&](Subset& to) { enter(0, to); },
      [&](StateId q, std::size_t column, Subset& to) { enter(all.next(q, column), to); },
      [&](StateId q) { return all.part_of(q) + 1 == all.part_count() && all.is_accepting(q); });
}

Language unite(std::span<const Language* const> parts) {
  if (parts.empty()) return {};
  if (parts.size() == 1) return *parts[0];
  const SideBySide all(parts);
  const auto enter = [&](StateId q, Subset& to) {
    if (!all.is_dead(q)) to.insert(q);
  };
  return determinize(
      all.size(), all.alphabet(), all.twins(),
      [&](Subset& to) {
        for (std::size_t part = 0; part < all.part_count(); ++part) enter(all.start(part), to);
      },
      [&](StateId q, std::size_t column, Subset& to) { enter(all.next(q, column), to); },
      [&](StateId q) { return all.is_accepting(q); });
}

}  // namespace heckbert::taxonomy
