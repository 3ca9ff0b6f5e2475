#pragma once
// Random numbers as a function of (seed, pixel, sample, dimension) and of nothing else, so that a picture does not
// depend on the number of threads and any sample can be traced again (design decision 7).
//
// Two kinds. `random`: SplitMix64, whose stream for a sample starts at a hash of its coordinates and takes one step per
// dimension. `sobol`: Owen-scrambled Sobol points, in sets of four dimensions, which spread the samples of a pixel and
// of its neighbours evenly. One sequence runs through the whole picture in Morton's order, so that errors of
// neighbours differ (Ahmed and Wonka 2020, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via
// Hierarchical Ordering of Pixels").
//
// Interval estimates come from the spread of 32 batches of samples. The points of one scramble are not independent, so
// every batch has its own: 32 independent randomised quadratures, whose spread is honest (Owen 1997).

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include <glm/vec2.hpp>

#include <heckbert/record/record.h>
#include <heckbert/transport/hash.h>
#include <heckbert/transport/sobol.h>

namespace heckbert::transport {

enum class SamplerKind : std::uint8_t { Sobol, Random };

struct SamplerFacts {
  SamplerKind kind;
  std::string_view name;  ///< as on the command line
};

/// Every sampler, the default first; the command line and the tests read this table.
inline constexpr std::array<SamplerFacts, 2> kSamplers{
    {{SamplerKind::Sobol, "sobol"}, {SamplerKind::Random, "random"}}};

/// What is the same for all samples of a render.
struct SamplePlan {
  SamplerKind kind = kSamplers.front().kind;
  std::uint64_t seed = 1;
  int samples_per_pixel = 1;
};

class Sampler {
 public:
  /// Random numbers of pixel (x, y), whatever the number of samples.
  Sampler(std::uint64_t seed, int x, int y, int sample) : kind_(SamplerKind::Random) {
    const auto pixel =
        (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) | static_cast<std::uint32_t>(x);
    state_ =
        mix(mix(mix(seed + kWeyl) ^ pixel) + static_cast<std::uint64_t>(static_cast<std::uint32_t>(sample)) * kWeyl);
  }

  /// Coordinates of Sobol's points are 0 to 65535.
  Sampler(const SamplePlan& plan, int x, int y, int sample) : Sampler(plan.seed, x, y, sample) {
    kind_ = plan.kind;
    if (kind_ == SamplerKind::Random) return;
    const int batch = record::batch_of(sample, plan.samples_per_pixel);
    const auto in_batch = static_cast<std::uint64_t>(sample - record::first_of_batch(batch, plan.samples_per_pixel));
    // A pixel's samples of a batch are a block of the sequence, of a power of two.
    const int longest = (plan.samples_per_pixel - 1) / record::batch_count(plan.samples_per_pixel);
    const std::uint64_t place =
        (static_cast<std::uint64_t>(morton(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)))
         << std::bit_width(static_cast<std::uint32_t>(longest))) +
        in_batch;
    index_ = static_cast<std::uint32_t>(place);
    // Beyond four thousand million points a new sequence begins.
    state_ = mix(mix(plan.seed + kWeyl) + static_cast<std::uint64_t>(batch)) ^ (place >> 32);
  }

  /// Another stream of the same sample, as well spread as this one: for a second walk, so that neither has to know how
  /// many numbers the other takes.
  Sampler split() const {
    Sampler other = *this;
    other.state_ = mix(state_ ^ kOther);
    other.left_ = 0;
    return other;
  }

  /// The next dimension, uniform in [0, 1).
  float next() {
    if (kind_ == SamplerKind::Random) return static_cast<float>(step() >> 40) * 0x1p-24f;
    return to_float(next_of_set());
  }
  /// The next two dimensions, well spread together.
  glm::vec2 next2() {
    if (kind_ == SamplerKind::Sobol && left_ == 1) left_ = 0;  // a pair from two sets would not be
    const float u = next();
    return {u, next()};
  }
  /// The next dimension with 32 bits, for choices among more than a few.
  double next_fine() {
    if (kind_ == SamplerKind::Random) return static_cast<double>(step() >> 32) * 0x1p-32;
    return static_cast<double>(next_of_set()) * 0x1p-32;
  }

 private:
  static constexpr std::uint64_t kOther = 0x5851f42d4c957f2du;  ///< any number

  std::uint64_t step() { return mix(state_ += kWeyl); }
  static float to_float(std::uint32_t fraction) { return static_cast<float>(fraction >> 8) * 0x1p-24f; }
  std::uint32_t next_of_set() {
    if (left_ == 0) {
      point_ = scrambled_sobol(index_, step());
      left_ = 4;
    }
    return point_[4 - left_--];
  }

  std::uint64_t state_ = 0;
  SobolPoint point_{};       ///< the current set of dimensions
  std::uint32_t index_ = 0;  ///< of the sample in its sequence
  std::uint32_t left_ = 0;   ///< dimensions of the set not yet given out
  SamplerKind kind_;
};

}  // namespace heckbert::transport
