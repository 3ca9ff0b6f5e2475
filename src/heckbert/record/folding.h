#pragma once
// Records of more words than a memory budget has room for (design decision 4). Words of more than some number of
// scatterings are then not kept apart: of those, the ones that no expression declared before the render tells apart
// become one class, whose energies are kept by pixel and batch as those of a word are. A class stands among the words
// of the record under its first word. So the declared expressions and all that is made of them with &, | and ! are
// answered exactly; of another question it is known which classes lie within and which without, and the others are
// undecided (record.h).
//
// Length decides, and not rarity, because it is known at once and in every thread: the same words are kept whatever
// the order of tiles. Long words are the rare ones. See docs/decisions/2026-11-28-folding.md.

#include <cstddef>
#include <string>
#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::record {

/// How the words of a record are folded.
struct Folding {
  int longest = 0;                          ///< words of up to so many scatterings are kept apart
  std::size_t first = 0;                    ///< the words of the record from here on stand for classes
  std::vector<taxonomy::Language> exact{};  ///< the declared ones: each class lies within or without each of them
  bool operator==(const Folding&) const = default;
};

/// What a budget allows.
struct FoldRule {
  std::size_t most_words = 0;               ///< kept apart, those without a scattering in any case; classes come on top
  std::vector<taxonomy::Language> exact{};  ///< as in Folding
};

/// All words of more than `longest` scatterings.
taxonomy::Language longer_than(int longest);

}  // namespace heckbert::record
