#include <heckbert/taxonomy/enumeration.h>

#include <heckbert/taxonomy/determinize.h>

namespace heckbert::taxonomy {

namespace {

class Enumerator {
 public:
  Enumerator(const Language& words, std::size_t count) : states_(words.states()), count_(count) {
    std::vector<bool> now;
    for (const State& s : states_) now.push_back(s.accepting);
    reach_.push_back(std::move(now));
  }

  /// All words of this many letters, ends included, as long as the count allows. False when there is none.
  bool collect(std::size_t letters) {
    while (reach_.size() <= letters) look_further();
    if (!reach_[letters][0]) return false;
    string_.clear();
    walk(0, letters);
    return true;
  }
  bool is_full() const { return words_.size() >= count_; }
  std::vector<Word> take() { return std::move(words_); }

 private:
  void look_further() {
    std::vector<bool> further(states_.size());
    for (std::size_t q = 0; q < states_.size(); ++q)
      for (const StateId to : states_[q].next) further[q] = further[q] || reach_.back()[to];
    reach_.push_back(std::move(further));
  }

  void walk(StateId q, std::size_t letters) {
    if (is_full()) return;
    if (letters == 0) {
      words_.push_back({string_.front(), {string_.begin() + 1, string_.end() - 1}, string_.back()});
      return;
    }
    for (const SymbolFacts& f : kSymbols) {
      const StateId next = states_[q].next[index(f.symbol)];
      if (!reach_[letters - 1][next]) continue;
      string_.push_back(f.symbol);
      walk(next, letters - 1);
      string_.pop_back();
    }
  }

  const std::vector<State>& states_;
  std::size_t count_;
  std::vector<std::vector<bool>> reach_;  ///< [k][q]: some string of k letters is accepted from q
  std::vector<Symbol> string_;
  std::vector<Word> words_;
};

}  // namespace

std::vector<Word> first_words(const Language& language, const WordLimits& limits) {
  const Language words = language & Language::universe();
  Enumerator enumerator(words, limits.count);
  // Cutting a loop out of a word leaves one at most as many letters shorter as there are states: when that many
  // lengths in a row have no word, no longer one has.
  std::size_t lengths_without = 0;
  for (std::size_t length = 0; !enumerator.is_full() && lengths_without <= words.states().size(); ++length) {
    if (limits.max_length && length > *limits.max_length) break;
    lengths_without = enumerator.collect(length + 2) ? 0 : lengths_without + 1;
  }
  return enumerator.take();
}

Language read_as(const Language& language, std::span<const SymbolSet> letters) {
  const std::vector<State>& states = language.states();
  std::array<SymbolSet, kSymbolCount> stands_for{};
  for (const SymbolSet letter : letters) stands_for[index(members(letter).front())] = letter;
  std::array<Symbol, kSymbolCount> twins{};
  for (const SymbolFacts& f : kSymbols) twins[index(f.symbol)] = f.symbol;
  return determinize(
      states.size(), twins, [](Subset& to) { to.insert(0); },
      [&](StateId q, Symbol s, Subset& to) {
        for (const Symbol alike : members(stands_for[index(s)])) to.insert(states[q].next[index(alike)]);
      },
      [&](StateId q) { return states[q].accepting; });
}

Language plain_words(const Language& language) {
  constexpr std::array<SymbolSet, 6> kPlain{with_letter('L'), with_letter('D'), with_letter('G'),
                                            with_letter('S'), with_letter('V'), with_letter('E')};
  return read_as(language, kPlain);
}

}  // namespace heckbert::taxonomy
