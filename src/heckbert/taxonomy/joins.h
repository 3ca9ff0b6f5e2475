#pragma once
// Many languages joined in one subset construction, as a sequence or as alternatives. Joining them two by two would
// build and minimise an automaton for every step of the way: a word of ten thousand letters, or five hundred words side
// by side, take one construction here.

#include <span>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// Strings made of one of each part, in order. Parts may be the same object. Errors: LimitError.
Language concat(std::span<const Language* const> parts);

/// Strings of any of the parts. Errors: LimitError.
Language unite(std::span<const Language* const> parts);

}  // namespace heckbert::taxonomy
