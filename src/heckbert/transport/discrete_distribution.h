#pragma once
// One of many by weight. The table is cumulative and in double precision: in floats, the steps of a long table would be
// rounding noise, and so would the probabilities that multiple importance weights are made of.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace heckbert::transport {

class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// Weights are not negative.
  explicit DiscreteDistribution(std::vector<double> weights) : cumulative_(std::move(weights)) {
    double sum = 0;
    for (double& w : cumulative_) w = sum += w;
    if (sum > 0)
      for (double& c : cumulative_) c /= sum;
  }

  struct Draw {
    std::size_t index = 0;
    double rest = 0;  ///< where in [0, 1) of its share the number lay: uniform again
  };
  /// Ask only when some weight is above zero; `u` is in [0, 1). Never draws a weight of zero. O(log n).
  Draw sample(double u) const {
    const auto at = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, u);
    const auto index = static_cast<std::size_t>(at - cumulative_.begin());
    const double width = probability(index);
    return {index, width > 0 ? std::clamp((u - below(index)) / width, 0.0, kBelowOne) : 0.0};
  }
  double probability(std::size_t index) const { return cumulative_[index] - below(index); }
  std::size_t size() const { return cumulative_.size(); }
  /// No weight is above zero.
  bool empty() const { return cumulative_.empty() || cumulative_.back() <= 0; }

 private:
  static constexpr double kBelowOne = 1.0 - 0x1p-53;
  double below(std::size_t index) const { return index == 0 ? 0.0 : cumulative_[index - 1]; }

  std::vector<double> cumulative_;  ///< ends at 1
};

}  // namespace heckbert::transport
