#pragma once
// The words of a language one by one, in the order of Word: shorter ones first, then letter by letter. A label is told
// only where it makes a difference; one word stands for all those that differ in other labels.

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

struct WordLimits {
  std::size_t count = std::numeric_limits<std::size_t>::max();
  std::optional<std::size_t> max_length = {};  ///< scatterings
};

/// The first words of the language within the limits; of a finite language all may be asked for. Cost: the letters
/// given back plus states times the longest length looked at.
std::vector<Word> first_words(const Language& language, const WordLimits& limits);

/// The words as they read in coarser letters, each letter a set of symbols and standing for itself as the first symbol
/// of its set: with {Dr, Dt} for D, LaDrEp belongs when LaDrEp or LaDtEp does. The sets are disjoint; words with other
/// symbols are left out. Errors: LimitError.
Language read_as(const Language& language, std::span<const SymbolSet> letters);

/// The words in plain letters: L, D, G, S, V and E.
Language plain_words(const Language& language);

}  // namespace heckbert::taxonomy
