#pragma once
// A short expression back from an automaton, one that a person would have written. Ends first: lights (and eyes) that
// the language treats alike stand together, and what lies between them is a language of events. That becomes a tree by
// elimination of states from either side, and then every edit that makes the text shorter and keeps the language is
// made until none is left, or until the steps for it are used up. So the result is right by construction, and short
// though not proven shortest.

#include <optional>
#include <string>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// "L N? S* E": compile() of it is the language, which is checked. Nothing when the text would be longer than anybody
/// reads, or take more to read than compile() allows. The language is a set of words. Errors: std::logic_error when the
/// check fails, a defect of this program.
std::optional<std::string> simplest_expression(const Language& language);

}  // namespace heckbert::taxonomy
