#pragma once
// A language: a regular set of strings of letters, held as its minimal complete automaton over the smallest alphabet
// that does it justice (alphabet.h), states numbered breadth-first from the start in the order of that alphabet. Equal
// languages are therefore equal objects, and operator== decides equality (design decision 6).
//
// Most languages here are sets of words, subsets of universe() = L (D|G|S|V)* E. Fragments such as S+D are languages
// too, so that expressions can be built up by concatenation; complement is always taken within the universe.
//
// How it is built: determinize.h (subset construction) and minimize.h (partition refinement).

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <heckbert/taxonomy/alphabet.h>
#include <heckbert/taxonomy/letter_set.h>
#include <heckbert/taxonomy/symbol.h>
#include <heckbert/taxonomy/word.h>

namespace heckbert::taxonomy {

using StateId = std::uint32_t;

/// One state of a complete deterministic automaton.
struct State {
  std::vector<StateId> next{};  ///< by column of the alphabet
  bool accepting = false;
  bool operator==(const State&) const = default;
};

/// The columns of a state that stand for all of them when words are listed or counted: of the labels of a symbol that
/// lead to the same state one, none at all where it can be. By symbol, then by label.
std::vector<std::size_t> representative_columns(const Alphabet& alphabet, const State& state);

/// States an automaton may have before the operation that builds it throws LimitError, and moves, which many labels
/// bring about with fewer states.
inline constexpr std::size_t kStateBudget = 20'000;
inline constexpr std::size_t kTableBudget = 2'000'000;

class Language {
 public:
  Language();  ///< the empty set

  /// The language of any complete automaton over the alphabet whose start is state 0; minimised, renumbered, its
  /// alphabet reduced to the labels that it tells apart. O(n log n).
  static Language from_automaton(const std::vector<State>& states, Alphabet alphabet = {});
  static Language none() { return Language(); }
  static Language epsilon();                    ///< only the empty string
  static Language of(const LetterSet& one_of);  ///< strings of one letter, any of these
  /// The word; where it has no labels at all it stands for itself with any labels.
  static Language of(const Word& word);
  static const Language& universe();  ///< every word: L (D|G|S|V)* E

  bool operator==(const Language&) const = default;
  const std::vector<State>& states() const { return states_; }  ///< start is 0; never empty
  const Alphabet& alphabet() const { return alphabet_; }

  bool contains(const Word& word) const;
  bool contains(std::span<const Symbol> string) const;  ///< without labels
  bool is_empty() const;
  bool is_subset_of(const Language& other) const;
  /// The shortest string, the first in the order of the alphabet among the shortest; nothing when empty.
  std::optional<std::vector<Letter>> shortest() const;
  /// The shortest member as a word; nothing when the language has no word.
  std::optional<Word> shortest_word() const;

 private:
  Alphabet alphabet_;
  std::vector<State> states_;
};

// Every operation throws LimitError when it would exceed `kStateBudget` states or takes more work than it may (work.h).
Language operator|(const Language& a, const Language& b);
Language operator&(const Language& a, const Language& b);
Language operator-(const Language& a, const Language& b);
Language operator!(const Language& a);  ///< universe() - a
Language concat(const Language& a, const Language& b);
Language repeat(const Language& a, unsigned at_least, std::optional<unsigned> at_most);  ///< no at_most: unbounded
Language reverse(const Language& a);
/// { w : h(w) in a } for the letter-to-letter map h. With h sending G to D this reads a two-letter grammar over
/// three-letter words.
Language inverse_image(const Language& a, const std::array<Symbol, kSymbolCount>& h);

}  // namespace heckbert::taxonomy
