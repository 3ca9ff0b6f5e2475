#pragma once
// A word: the events of one light path, from the light to the eye, with the kinds of both ends. Words run light -> eye
// everywhere a person or a program sees them; a tracer that walks from the eye hands its letters over in the order it
// met them and Word::from_eye_path reverses them, in that one place.

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/symbol.h>

namespace heckbert::taxonomy {

struct Word {
  Symbol light = Symbol::La;   ///< one of La Lp Ld Le
  std::vector<Symbol> events;  ///< light -> eye; empty for LE
  Symbol eye = Symbol::Ep;     ///< one of Ep El

  /// Takes the letters in the order a walk from the eye met them: events only, nearest the eye first.
  static Word from_eye_path(Symbol eye, const std::vector<Symbol>& events_from_eye, Symbol light);

  std::size_t length() const { return events.size(); }  ///< number of scatterings

  /// Shorter words first, then letter by letter from the light in the order of Symbol (light, events, eye).
  std::strong_ordering operator<=>(const Word& other) const;
  bool operator==(const Word& other) const = default;
};

/// "LDSE": the plain letters. Different words may print alike; fine() tells them apart.
std::string plain(const Word& word);

/// "LaDrSrEp": every letter with its subscript; parse_word reads it back.
std::string fine(const Word& word);

/// Reads one word, light -> eye or eye -> light, letters with or without subscripts. A letter without one gets the
/// commonest: La, Dr, Gr, Sr, Ep. Errors: InputError with a caret.
Word parse_word(std::string_view text);

}  // namespace heckbert::taxonomy
