#pragma once
// Labels: names that a renderer hangs on events and lights, an object's, a material's or a light group's. A letter has
// one label or none; which kind of name it is, the renderer decides. Written behind the letter, 'name', where a
// backslash goes before a quote or a backslash within.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <heckbert/taxonomy/symbol.h>

namespace heckbert::taxonomy {

/// The label of a letter without one. An expression writes it ''.
inline constexpr std::string_view kUnlabelled = "";

/// Lights and events have labels; the eye has none.
constexpr bool may_be_labelled(Symbol s) {
  return !is_eye(s);
}

/// A label read from a text, and how many characters it took there, quotes included.
struct QuotedLabel {
  std::string label;
  std::size_t length = 0;
};

/// The label that begins with the quote at text[at], ' or "; nothing when it is never closed on its line.
std::optional<QuotedLabel> read_label(std::string_view text, std::size_t at);

/// "'key light'": read_label() reads it back. Line ends and other control characters become blanks.
std::string write_label(std::string_view label);

}  // namespace heckbert::taxonomy
