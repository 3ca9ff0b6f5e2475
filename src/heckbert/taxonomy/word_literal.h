#pragma once
// "LSDE"_word: a word written in a program, read when the program is compiled. A bad word does not compile.

#include <array>
#include <cstddef>

#include <heckbert/taxonomy/word.h>

namespace heckbert::taxonomy {

/// A word of at most N-1 characters, light -> eye, letters with or without subscripts as in parse_word().
template <std::size_t N>
struct WordLiteral {
  std::array<Symbol, N> letters{};
  std::size_t count = 0;

  consteval WordLiteral(const char (&text)[N]) {  // implicit: the literal operator needs it so
    for (std::size_t at = 0; at + 1 < N;) {
      const bool subscripted = text[at + 1] >= 'a' && text[at + 1] <= 'z';
      letters[count++] = find_symbol(text[at], subscripted ? text[at + 1] : '\0').value();
      at += subscripted ? 2 : 1;
    }
    if (count < 2 || !is_light(letters[0]) || !is_eye(letters[count - 1])) throw "a word is L ... E";
    for (std::size_t i = 1; i + 1 < count; ++i)
      if (!is_event(letters[i])) throw "an end in the middle of a word";
  }
};

namespace literals {

template <WordLiteral literal>
Word operator""_word() {
  const auto* const letters = literal.letters.data();
  return {letters[0], {letters + 1, letters + literal.count - 1}, letters[literal.count - 1]};
}

}  // namespace literals
}  // namespace heckbert::taxonomy
