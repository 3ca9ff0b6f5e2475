#pragma once
// Is a list of classes a partition: does every word of a whole belong to exactly one of them? The energies of a
// partition add up to the energy of the whole, which is why the question is asked before pictures are composed.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// Two members of the list that share words.
struct Overlap {
  std::size_t first = 0, second = 0;  ///< places in the list, first < second
  Word shortest;                      ///< the shortest word of both
};

struct Partition {
  std::vector<Overlap> overlaps;  ///< all pairs that share a word of the whole
  std::optional<Word> gap;        ///< the shortest word of the whole that none has
  bool is_disjoint() const { return overlaps.empty(); }
  bool is_exhaustive() const { return !gap; }
};

/// Words outside the whole count for nothing. Errors: LimitError when it takes more work than reading that many
/// expressions may.
Partition partition(std::span<const Language> classes, const Language& whole = Language::universe());

}  // namespace heckbert::taxonomy
