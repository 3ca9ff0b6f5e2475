#pragma once
// The kinds of characters that every text of this layer is read by, and the quotes of its messages. ASCII whatever the
// locale.

#include <string>
#include <string_view>

namespace heckbert::taxonomy {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
constexpr bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}

inline std::string quoted(std::string_view text) {
  return "'" + std::string(text) + "'";
}

inline std::string did_you_mean(std::string_view text) {
  return "did you mean " + quoted(text) + "?";
}

}  // namespace heckbert::taxonomy
