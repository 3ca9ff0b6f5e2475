#pragma once
// Why a word is in a language or not, and where two languages differ: every no comes with its evidence.

#include <optional>
#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// The walk of one word through a language, letter by letter from the light.
struct Explanation {
  bool matches = false;
  std::size_t letters_read = 0;   ///< the longest beginning of the word (ends count) that some member goes on from
  std::optional<Letter> culprit;  ///< the letter that no member has there; nothing when the word matches
  LetterSet expected;             ///< the letters that members have there; empty when the language is
};

/// `language` must be a set of words, a subset of universe().
Explanation explain(const Language& language, const Word& word);

/// "LDGE: after LD expected S or E, not G", or "LDSE matches", for people.
std::string describe(const Explanation& explanation, const Word& word);

/// One letter of a walk through the minimal automaton.
struct Step {
  StateId from = 0;
  LetterSet expected;  ///< the letters with which members go on from there
  Letter letter;
  std::optional<StateId> to;  ///< nothing when no member goes on with this letter
};

/// The walk of the word, state by state, up to and with the first letter that no member has.
std::vector<Step> trace(const Language& language, const Word& word);

/// The shortest word of a that b lacks; nothing when a is a subset of b.
std::optional<Word> witness_outside(const Language& a, const Language& b);

}  // namespace heckbert::taxonomy
