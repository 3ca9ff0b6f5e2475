#pragma once
// The letters, operators and names of an expression. Sets in brackets and counts in braces are one token each.

#include <vector>

#include <heckbert/taxonomy/expression_source.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

enum class TokenKind : std::uint8_t {
  Letters,
  Open,
  Close,
  Bar,
  And,
  Minus,
  Not,
  Repeat,  ///< * + ? or a count
  Name,
  Bad,  ///< reported already; stands for any letter
  End,
};

struct Token {
  TokenKind kind = TokenKind::End;
  std::size_t offset = 0;
  std::size_t length = 0;
  LetterSet set = {};
  unsigned at_least = 0;
  std::optional<unsigned> at_most = {};
};

/// All tokens of the source, the last one an End placed behind the last piece of text. Reports what is no token.
std::vector<Token> read_tokens(ExpressionSource& source);

}  // namespace heckbert::taxonomy
