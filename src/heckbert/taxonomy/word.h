#pragma once
// A word: the events of one light path, from the light to the eye, with the kinds of both ends, and the labels of the
// light and the events where they have any. Words run light -> eye
// everywhere a person or a program sees them; a tracer that walks from the eye hands its letters over in the order it
// met them and Word::from_eye_path reverses them, in that one place.

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/letter.h>
#include <heckbert/taxonomy/symbol.h>

namespace heckbert::taxonomy {

struct Word {
  Symbol light = Symbol::La;   ///< one of La Lp Ld Le
  std::vector<Symbol> events;  ///< light -> eye; empty for LE
  Symbol eye = Symbol::Ep;     ///< one of Ep El
  /// Of the light and then of each event, "" for none. Empty when nothing is labelled, else one more than events.
  std::vector<std::string> labels = {};

  /// Takes the letters in the order a walk from the eye met them: events only, nearest the eye first.
  static Word from_eye_path(Symbol eye, const std::vector<Symbol>& events_from_eye, Symbol light);

  std::size_t length() const { return events.size(); }  ///< number of scatterings
  /// The label of the light (0) or of event place - 1; empty for none.
  std::string_view label(std::size_t place) const { return labels.empty() ? std::string_view{} : labels[place]; }
  /// One for the light and one for each event; kept only when one of them is not empty.
  void set_labels(std::vector<std::string> all);

  /// Shorter words first, then letter by letter from the light in the order of Symbol (light, events, eye), then by
  /// labels.
  std::strong_ordering operator<=>(const Word& other) const;
  bool operator==(const Word& other) const = default;
};

/// The letters from the light to the eye, and back. At least two, the first a light and the last an eye.
std::vector<Letter> letters_of(const Word& word);
Word word_of(std::vector<Letter> letters);

/// "LDSE", "LD'wall'E": the plain letters. Different words may print alike; fine() tells them apart.
std::string plain(const Word& word);

/// "LaDrSrEp", "LaDr'wall'Ep": every letter with its subscript; parse_word reads it back.
std::string fine(const Word& word);

/// Reads one word, light -> eye or eye -> light, letters with or without subscripts and labels. A letter without a
/// subscript gets the commonest: La, Dr, Gr, Sr, Ep. Errors: InputError with a caret.
Word parse_word(std::string_view text);

}  // namespace heckbert::taxonomy
