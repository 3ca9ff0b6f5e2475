#pragma once
// Random numbers as a function of (seed, pixel, sample, dimension) and of nothing else, so that a picture does not
// depend on the number of threads and any sample can be traced again (design decision 7).
//
// SplitMix64 (Steele, Lea, Flood 2014): the stream of a sample starts at a hash of its coordinates; each dimension is
// one step of the Weyl sequence put through the mixing function.

#include <cstdint>

#include <glm/vec2.hpp>

namespace heckbert::transport {

class Sampler {
 public:
  Sampler(std::uint64_t seed, int x, int y, int sample) {
    const auto pixel =
        (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) | static_cast<std::uint32_t>(x);
    state_ =
        mix(mix(mix(seed + kWeyl) ^ pixel) + static_cast<std::uint64_t>(static_cast<std::uint32_t>(sample)) * kWeyl);
  }

  /// The next dimension, uniform in [0, 1).
  float next() {
    state_ += kWeyl;
    return static_cast<float>(mix(state_) >> 40) * 0x1p-24f;
  }
  glm::vec2 next2() {
    const float u = next();
    return {u, next()};
  }

 private:
  static constexpr std::uint64_t kWeyl = 0x9e3779b97f4a7c15u;
  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace heckbert::transport
