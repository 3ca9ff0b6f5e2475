#pragma once
// Energies of many groups of words in one pass. A record of a rich scene has tens of thousands of words; asking
// record::energy about each would walk them all each time. Instead each group is added up into a record of two
// words, the group and the rest, and the statistics of the record layer are asked about that: the same estimators,
// at a cost that does not depend on the number of words.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>

namespace heckbert::report {

struct GroupEnergy {
  record::Estimate energy;  ///< picture-mean luminance
  record::Estimate share;   ///< of all recorded energy
  std::uint64_t count = 0;  ///< contributions
};

inline constexpr std::size_t kNoGroup = std::numeric_limits<std::size_t>::max();

class Energies {
 public:
  /// O(entries + words x batches); refers to the record, which must outlive it.
  Energies(const record::Record& record, double confidence);

  /// Energies of the groups 0 .. groups-1; group_of[w] is the group of word w, or kNoGroup. O(words x batches +
  /// groups).
  std::vector<GroupEnergy> of_groups(const std::vector<std::size_t>& group_of, std::size_t groups) const;
  /// The chosen words as one group.
  GroupEnergy of_words(const std::vector<bool>& chosen) const;

 private:
  /// What is known of a set of words: what each batch alone says of it, per channel.
  struct Sums {
    std::array<std::array<double, 3>, record::kBatches> batches{};
    std::uint64_t count = 0;
  };
  void add_word(Sums& sums, std::size_t word) const;
  GroupEnergy estimate(const Sums& sums) const;

  const record::Record& record_;
  double confidence_;
  std::vector<std::uint64_t> counts_;  ///< by word
  Sums total_;
};

}  // namespace heckbert::report
