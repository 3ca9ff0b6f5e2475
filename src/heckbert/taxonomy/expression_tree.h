#pragma once
// The tree of an expression: what was written, with the place of every piece, before any automaton is built.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <heckbert/taxonomy/letter_set.h>

namespace heckbert::taxonomy {

/// The largest count that {n,m} may name.
inline constexpr unsigned kMaxCount = 10'000;
/// How deep parentheses, repetitions and operators may nest; reading and compiling recurse that deep.
inline constexpr std::size_t kMaxDepth = 500;

enum class NodeKind : std::uint8_t {
  Letters,      ///< one of `set`
  Sequence,     ///< children one after the other
  Alternation,  ///< one of the children
  Repeat,       ///< the child at_least to at_most times
  Name,         ///< the language called `name`
  Both,         ///< first & second child
  Without,      ///< first - second child
  Complement,   ///< ! child
  Bad,          ///< something was wrong here and has been reported
};

struct Node {
  NodeKind kind = NodeKind::Bad;
  std::size_t offset = 0;  ///< of the text it was written as, parentheses included; bytes
  std::size_t length = 0;
  LetterSet set = {};
  unsigned at_least = 0;
  std::optional<unsigned> at_most = {};
  std::string name = {};
  std::vector<Node> children = {};
  std::size_t height = 0;  ///< levels of nodes below
};

}  // namespace heckbert::taxonomy
