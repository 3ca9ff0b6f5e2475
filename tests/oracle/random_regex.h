#pragma once
// Random expressions for tests of laws. A failing one is shrunk: an operator gives way to an operand, a set to one of
// its letters, a count to a smaller one, until nothing smaller fails.

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "oracle/regex.h"

namespace heckbert::oracle {

/// Any 64 random bits.
using Bits = std::function<std::uint64_t()>;

/// A tree of at most `nodes` nodes, every operator and set among them, counts up to three.
RegexPtr random_regex(std::size_t nodes, std::string_view letters, const Bits& bits);

/// The next smaller trees to try, the smallest first.
std::vector<RegexPtr> smaller(const RegexPtr& regex);

}  // namespace heckbert::oracle
