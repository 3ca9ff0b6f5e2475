#pragma once
// Energies with confidence. The picture mean of a set of words is estimated once per batch of samples; the batches are
// independent, so the spread of their values gives Student intervals for energies, and of their ratios for shares
// (batch means: Law and Kelton, "Simulation Modeling and Analysis", 9.5.3), which where few contributions were found
// become intervals for rare events. What was not found at all may still be there: its upper bound supposes that one
// contribution would have been as bright as those of words that were found once. Energies are luminance unless said
// otherwise.

#include <array>
#include <vector>

#include <heckbert/record/record.h>

namespace heckbert::record {

/// A mean with its two-sided confidence interval; lower == upper == mean when the spread is unknown (one batch),
/// in which case `known` is false.
struct Estimate {
  double mean = 0;
  double standard_error = 0;
  double lower = 0, upper = 0;
  bool known = true;
};

/// Luminance of the picture mean, as each batch alone estimates it; batches not in use are zero.
using BatchSeries = std::array<double, kBatches>;

/// Estimates from batches at one confidence; what all of them share is computed once.
class BatchStatistics {
 public:
  BatchStatistics(const RenderInfo& info, double confidence);
  /// `size_if_none`, here and below: what one contribution would have added to the picture's mean, had one been found.
  Estimate energy(const BatchSeries& values, double size_if_none = 0) const;
  /// A ratio estimate, at most `most`. 0 when the whole is dark.
  Estimate share(const BatchSeries& part, const BatchSeries& whole, double most = 1, double size_if_none = 0) const;
  int batches() const { return batches_; }
  double quantile() const { return quantile_; }  ///< of Student's t for the interval; 0 with one batch

 private:
  double mean(const BatchSeries& values) const;
  double standard_error(const BatchSeries& values) const;

  BatchSeries weights_{};  ///< the fraction of the samples that each batch holds
  int batches_ = 0;        ///< in use
  double quantile_ = 0;
};

/// Picture-mean luminance of the chosen words, with its interval at `confidence`.
Estimate energy(const Record& record, const std::vector<bool>& chosen, double confidence = 0.95);
/// Luminance that a contribution of a word of which none was found would have added to the picture's mean: what was not
/// seen resembles what was seen once (Good 1953, "The population frequencies of species"), so that is the average over
/// words with one contribution, and at least the average over all.
double contribution_if_none(const Record& record);
/// Picture-mean colour of the chosen words (no interval).
Rgb mean_colour(const Record& record, const std::vector<bool>& chosen);
/// Energy of `part` over energy of `whole`, as a ratio estimate. Mean 0 when the whole is dark.
Estimate share(const Record& record, const std::vector<bool>& part, const std::vector<bool>& whole,
               double confidence = 0.95);

/// Picture-mean luminance that the depth limit cut off, as the tracer estimated it; 0 when it reached no limit, and not
/// known where nothing was estimated.
/// Roulette needs no such estimate: what it ends is on average what it adds to the walks that go on.
Estimate cut_off(const RenderInfo& info, const Tally& tally, double confidence = 0.95);

/// Quantile of Student's t with `degrees` degrees of freedom: the t with P(T <= t) = probability.
double student_quantile(double probability, int degrees);
/// P(|T| > t) for t >= 0, to some 1e-15.
double student_tails(double t, int degrees);

}  // namespace heckbert::record
