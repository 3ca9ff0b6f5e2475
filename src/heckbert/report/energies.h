#pragma once
// Energies of many groups of words in one pass. A record of a rich scene has tens of thousands of words; asking
// record::energy about each would walk them all each time. Here the batches of a group's words are added up first, and
// the estimators of the record layer are asked about the sums.
//
// Intervals of the whole picture come from its batches. Of a region the record has no batches, but counts: were all
// contributions of a group alike, its sum over an entry of energy e from c contributions would have the variance
// e^2 / c, as that of a Poisson number. They are not alike; by what factor the true variance differs is known from the
// whole picture, where there are batches, and taken to be the same in the region, and so is the correlation of a group
// with the rest. But where the samples of neighbouring pixels are spread over one another, as Sobol points are, errors
// of pixels cancel, the more the more pixels there are. How far they do so in the picture is seen by comparing its
// variance with that of pixels whose errors were independent, which differences between neighbours tell; the variance
// of a mean of n pixels is then taken to go down as a power of n.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/part.h>

namespace heckbert::report {

struct GroupEnergy {
  record::Estimate energy;  ///< mean luminance of the part's pixels
  record::Estimate share;   ///< of all energy of the part
  std::uint64_t count = 0;  ///< contributions
  /// Variance of what one sample finds of the group at a pixel, mean over the part's pixels, over the square of what it
  /// finds on average: a relative error of e takes this over e^2 samples per pixel. Unset where nothing is known of it.
  std::optional<double> relative_variance{};
};

/// The words of a record that are in a language, by word: those that certainly are, and those of a folded record that
/// may be. None is both.
struct Members {
  std::vector<bool> certain, undecided;
  bool is_exact() const;
};
Members members_of(const record::Record& record, const taxonomy::Language& language, taxonomy::GlossyRule rule);

inline constexpr std::size_t kNoGroup = std::numeric_limits<std::size_t>::max();

class Energies {
 public:
  /// O(words x batches), and of a region O(entries); refers to the record, which must outlive it and needs no pixels
  /// unless a region is asked. Words outside of the part belong to no
  /// group.
  Energies(const record::Record& record, double confidence, Part part = {});

  /// Energies of the groups 0 .. groups-1; group_of[w] is the group of word w, or kNoGroup. O(words x batches +
  /// groups).
  std::vector<GroupEnergy> of_groups(const std::vector<std::size_t>& group_of, std::size_t groups) const;
  /// The chosen words as one group.
  GroupEnergy of_words(const std::vector<bool>& chosen) const;

  /// The members as one group: energy and share are those of the certain ones, their intervals reach from the least to
  /// the most that there can be.
  GroupEnergy of_members(const Members& members) const;

  /// Energies of many languages, which may overlap. The words of an outcome are added up once:
  /// O(words x batches + outcomes x languages x batches), of which the languages' number is the small part.
  std::vector<GroupEnergy> of_outcomes(const record::Outcomes& outcomes, std::size_t languages) const;
  /// The mean of a value that each word has, none of them negative, over the energy of the part. In a region its spread
  /// is not known.
  record::Estimate mean_over_energy(const std::vector<double>& value_of_word) const;

  const Part& part() const { return part_; }

 private:
  /// What the entries of one word say.
  struct OfWord {
    std::uint64_t count = 0;  ///< contributions in the part
    double luminance = 0;     ///< summed over the part's pixels
    double scatter = 0;       ///< e^2 / c summed over the part's pixels
    double scatter_all = 0;   ///< the same over the whole picture
    double apart_all = 0;     ///< variance of the sum over the picture, were the errors of pixels independent
    OfWord& operator+=(const OfWord& other);
  };
  /// What is known of a set of words: what each batch alone says of it, and its entries.
  struct Sums {
    record::BatchSeries batches{};
    OfWord entries;
  };
  /// Fills words_ from the entries.
  void look_at_pixels(const record::Window& asked);
  void add_word(Sums& sums, std::size_t word, double weight = 1) const;
  static void add(Sums& sums, const Sums& more);
  GroupEnergy estimate(const Sums& sums) const;
  GroupEnergy estimate_region(const Sums& sums) const;
  std::size_t pixel_count() const { return part_.pixels.value_or(record_.info.window).pixel_count(); }

  const record::Record& record_;
  record::BatchStatistics statistics_;
  double contribution_if_none_;
  Part part_;
  std::vector<OfWord> words_;
  Sums total_;  ///< of the part's words
};

}  // namespace heckbert::report
