#pragma once
// A letter as it occurs in a word: a symbol, and the label that a renderer gave it, if any.

#include <string>

#include <heckbert/taxonomy/symbol.h>

namespace heckbert::taxonomy {

struct Letter {
  Symbol symbol = Symbol::La;
  std::string label = {};  ///< empty: none
  bool operator==(const Letter&) const = default;
};

/// "Dr", "Dr'wall'".
std::string name(const Letter& letter);

}  // namespace heckbert::taxonomy
