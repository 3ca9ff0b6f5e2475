#pragma once
// What can occur at all: the words that given lights, eyes, scattering events and depth leave possible, and why a
// language has none of them. Half of the questions "why is my class empty?" end here, before anything is rendered.

#include <cstddef>
#include <optional>
#include <string>

#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

/// What a scene and a renderer provide; by default everything.
struct Conditions {
  SymbolSet lights = kLights;
  SymbolSet events = kEvents;
  SymbolSet eyes = kEyes;
  std::optional<std::size_t> max_length = {};  ///< scatterings; nothing: any number
};

/// The words of these ends and events, no longer than allowed. Errors: LimitError for a length near kStateBudget.
Language possible_words(const Conditions& conditions);

/// Why no word of the language is possible, as the end of "it can never match, because ..."; nothing when one is.
std::optional<std::string> why_never(const Language& language, const Conditions& conditions = {});

}  // namespace heckbert::taxonomy
