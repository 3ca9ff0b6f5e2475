#pragma once
// One event or end of a dialect's expression: a letter, [..], [^..], <..> or a label. What is neither is reported here,
// with the letter that the dialect has for it where there is one.

#include <heckbert/taxonomy/dialect_text.h>

namespace heckbert::taxonomy {

/// Characters that begin a repetition.
constexpr bool is_repetition(char c) {
  return c == '*' || c == '+' || c == '?' || c == '{';
}

/// The event or end that stands here, as a node of letters. Goes on behind it, also over what is wrong.
Node read_event(DialectText& text);

}  // namespace heckbert::taxonomy
