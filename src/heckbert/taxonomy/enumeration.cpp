#include <heckbert/taxonomy/enumeration.h>

#include <heckbert/taxonomy/determinize.h>

namespace heckbert::taxonomy {

namespace {

class Enumerator {
 public:
  Enumerator(const Language& words, std::size_t count)
      : alphabet_(words.alphabet()), states_(words.states()), count_(count) {
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
      words_.push_back(word_of(string_));
      return;
    }
    for (const std::size_t c : representative_columns(alphabet_, states_[q])) {
      const StateId next = states_[q].next[c];
      if (!reach_[letters - 1][next]) continue;
      string_.push_back(alphabet_.letter(c));
      walk(next, letters - 1);
      string_.pop_back();
    }
  }

  const Alphabet& alphabet_;
  const std::vector<State>& states_;
  std::size_t count_;
  std::vector<std::vector<bool>> reach_;  ///< [k][q]: some string of k letters is accepted from q
  std::vector<Letter> string_;
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
  std::vector<std::size_t> twins;
  for (std::size_t c = 0; c < language.alphabet().size(); ++c) twins.push_back(c);
  return determinize(
      states.size(), language.alphabet(), twins, [](Subset& to) { to.insert(0); },
      [&](StateId q, std::size_t c, Subset& to) {
        for (const Symbol alike : members(stands_for[index(Alphabet::symbol(c))]))
          to.insert(states[q].next[Alphabet::column(alike, Alphabet::class_of_column(c))]);
      },
      [&](StateId q) { return states[q].accepting; });
}

Language plain_words(const Language& language) {
  constexpr std::array<SymbolSet, 6> kPlain{with_letter('L'), with_letter('D'), with_letter('G'),
                                            with_letter('S'), with_letter('V'), with_letter('E')};
  return read_as(language, kPlain);
}

}  // namespace heckbert::taxonomy
