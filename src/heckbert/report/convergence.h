#pragma once
// Does a value that is right only in the limit come nearer to the truth as a setting is made finer? Photons blur light
// over a radius and lose some at edges, patches show it as linear between corners: both errors are at least of first
// order, so a setting that is four times as fine has to leave a quarter of the error or less. What leaves more is not
// on its way to the truth, whatever the setting.

#include <optional>
#include <string>
#include <vector>

#include <heckbert/report/comparison.h>
#include <heckbert/report/evidence.h>

namespace heckbert::report {

/// Renders that are coarser than those on trial.
struct CoarserStage {
  double size = 0;  ///< of the option
  const Evidence* evidence = nullptr;
};

/// How an algorithm is made finer.
struct Refinement {
  std::string option;                   ///< "photon-radius"
  double order = 1;                     ///< the error falls at least as this power of it
  double size = 0;                      ///< in the renders on trial
  std::vector<CoarserStage> coarser{};  ///< coarsest first
};

/// One word, or a block of one, along the stages.
struct Sequence {
  std::vector<record::Estimate> ratios{};  ///< found / expected: the coarsest first, that on trial last
  /// By which power of the option the error fell from the first to the last; unset where one of them is not told from
  /// none by three standard errors.
  std::optional<record::Estimate> order{};
  /// Of an error as large as the last, by chance alone, were it what the order leaves of the most that an earlier
  /// stage lets expect; one-sided.
  double p_value = 1;
};

/// Takes: the comparisons with one witness, coarsest first, that on trial last; `sizes` as long; the batches of the
/// trials; the quantile of intervals.
Sequence sequence_of(const std::vector<Comparison>& comparisons, const std::vector<double>& sizes, double order,
                     int batches, double quantile);

}  // namespace heckbert::report
