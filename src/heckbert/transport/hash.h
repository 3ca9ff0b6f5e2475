#pragma once
// The mixing function of SplitMix64 (Steele, Lea, Flood 2014) and the step of its Weyl sequence.

#include <cstdint>

namespace heckbert::transport {

inline constexpr std::uint64_t kWeyl = 0x9e3779b97f4a7c15u;

constexpr std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace heckbert::transport
