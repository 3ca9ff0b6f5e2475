#pragma once
// Sums of light as whole numbers, so that adding is associative: whatever was added in whatever order, by whatever
// number of threads and machines, gives the same sum to the last bit.
//
// A quantum is 2^-56. A float of at least 2^-33 is a whole number of quanta and loses nothing; a smaller one is off by
// half a quantum (7e-18) at most. Floats are bounded by kMostLight, which leaves room for 2^40 of the largest in the
// 128 bits of a sum; nothing overflows. Why these numbers: docs/decisions/2026-11-27-exact-sums.md.

#include <algorithm>
#include <bit>
#include <cstdint>

#include <heckbert/record/rgb.h>

namespace heckbert::record {

__extension__ using Quanta = unsigned __int128;

inline constexpr int kQuantumBits = 56;
inline constexpr double kQuantum = 0x1p-56;
/// The largest contribution that is taken as it is, in each channel: the largest float below 2^32.
inline constexpr float kMostLight = 4294967040.0f;

/// The quanta nearest to `light`, ties upwards. Takes: 0 <= light <= kMostLight.
constexpr Quanta quanta_of(float light) {
  constexpr int kFloatBias = 150;  // light = mantissa x 2^(exponent - 150)
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(light) & 0x7fff'ffffu;  // -0 is 0
  const std::uint32_t exponent = bits >> 23;
  const std::uint32_t mantissa = exponent == 0 ? bits : (bits & 0x7f'ffffu) | 0x80'0000u;
  const int shift = static_cast<int>(exponent) - kFloatBias + kQuantumBits;
  if (shift >= 0) return Quanta{mantissa} << shift;
  return shift < -25 ? 0 : ((std::uint64_t{mantissa} << 1 >> -shift) + 1) >> 1;
}

/// Light over `samples` samples, rounded to double.
inline double mean_of(Quanta sum, double samples) {
  return static_cast<double>(sum) * kQuantum / samples;
}

struct RgbSum {
  Quanta r = 0, g = 0, b = 0;

  constexpr RgbSum() = default;
  constexpr explicit RgbSum(Rgb light) : r(quanta_of(light.r)), g(quanta_of(light.g)), b(quanta_of(light.b)) {}

  constexpr RgbSum& operator+=(const RgbSum& o) {
    r += o.r;
    g += o.g;
    b += o.b;
    return *this;
  }
  constexpr bool operator==(const RgbSum&) const = default;
};

/// The mean, each channel rounded to float at the end; black of no samples: what walks from the light brought to a
/// pixel before its first sample, in a render that was stopped, waits in the sum.
inline Rgb mean_of(const RgbSum& sum, double samples) {
  if (samples <= 0) return {};
  return {static_cast<float>(mean_of(sum.r, samples)), static_cast<float>(mean_of(sum.g, samples)),
          static_cast<float>(mean_of(sum.b, samples))};
}

/// Each channel at most kMostLight.
constexpr Rgb clamped(Rgb light) {
  return {std::min(light.r, kMostLight), std::min(light.g, kMostLight), std::min(light.b, kMostLight)};
}

/// Whether light that is not black has no quantum in any channel.
constexpr bool vanishes(Rgb light, const RgbSum& sum) {
  return sum == RgbSum() && !is_black(light);
}

}  // namespace heckbert::record
