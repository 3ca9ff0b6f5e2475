#pragma once
// Characters of UTF-8 text, as far as error messages need them: columns count characters, and a letter that only looks
// like one of ours has to be told from it by its code point.

#include <cstddef>
#include <string_view>

namespace heckbert {

struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 1;  ///< bytes
  bool valid = false;      ///< false: the byte begins no UTF-8 sequence; length is 1
};

/// The character that begins at `offset` < text.size().
Utf8Character utf8_at(std::string_view text, std::size_t offset);

/// How many characters the text has; an invalid byte counts as one.
std::size_t utf8_length(std::string_view text);

}  // namespace heckbert
