#include <heckbert/transport/sobol.h>

#include <cstddef>

#include <heckbert/transport/hash.h>

namespace heckbert::transport {

namespace {

constexpr std::uint32_t reverse(std::uint32_t v) {
  v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
  v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
  v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
  v = ((v >> 8) & 0x00ff00ffu) | ((v & 0x00ff00ffu) << 8);
  return (v >> 16) | (v << 16);
}

/// A permutation in which every bit depends on those below it: on reversed fractions, an Owen scramble.
constexpr std::uint32_t permute(std::uint32_t v, std::uint32_t seed) {
  v ^= v * 0x3d20adeau;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

/// A primitive polynomial over the integers modulo 2 without its first and last coefficient, and the first odd numbers.
struct Polynomial {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 3> first;
};
constexpr std::array<Polynomial, 3> kPolynomials{{{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};

/// The direction number of each bit of the index, the point's bits reversed.
constexpr std::array<SobolPoint, 32> kDirections = [] {
  std::array<SobolPoint, 32> all{};
  for (std::size_t bit = 0; bit < 32; ++bit) all[bit][0] = 1u << bit;  // van der Corput's sequence
  for (std::size_t dimension = 1; dimension < 4; ++dimension) {
    const Polynomial& p = kPolynomials[dimension - 1];
    const auto degree = static_cast<std::size_t>(p.degree);
    std::array<std::uint32_t, 32> v{};
    for (std::size_t bit = 0; bit < 32; ++bit) {
      if (bit < degree) {
        v[bit] = p.first[bit] << (31 - bit);
      } else {
        v[bit] = v[bit - degree] ^ (v[bit - degree] >> degree);
        for (std::size_t k = 1; k < degree; ++k)
          if (((p.coefficients >> (degree - 1 - k)) & 1u) != 0) v[bit] ^= v[bit - k];
      }
      all[bit][dimension] = reverse(v[bit]);
    }
  }
  return all;
}();

/// The sums of the direction numbers of four bits at a time: 2 KiB, always in the cache.
constexpr std::array<std::array<SobolPoint, 16>, 8> kNibbles = [] {
  std::array<std::array<SobolPoint, 16>, 8> sums{};
  for (std::size_t nibble = 0; nibble < 8; ++nibble)
    for (std::size_t value = 0; value < 16; ++value)
      for (std::size_t bit = 0; bit < 4; ++bit)
        if (((value >> bit) & 1u) != 0)
          for (std::size_t d = 0; d < 4; ++d) sums[nibble][value][d] ^= kDirections[4 * nibble + bit][d];
  return sums;
}();

}  // namespace

SobolPoint scrambled_sobol(std::uint32_t index, std::uint64_t seed) {
  const std::uint64_t a = mix(seed), b = mix(seed + kWeyl), c = mix(seed + 2 * kWeyl);
  // The order of the points: the index itself is scrambled as a fraction, which keeps aligned blocks together.
  const std::uint32_t shuffled = reverse(permute(reverse(index), static_cast<std::uint32_t>(c)));
  SobolPoint point{};
  for (std::size_t nibble = 0; nibble < 8; ++nibble) {
    const SobolPoint& sum = kNibbles[nibble][(shuffled >> (4 * nibble)) & 15u];
    for (std::size_t d = 0; d < 4; ++d) point[d] ^= sum[d];
  }
  const std::array<std::uint32_t, 4> seeds{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(a >> 32),
                                           static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(b >> 32)};
  for (std::size_t d = 0; d < 4; ++d) point[d] = reverse(permute(point[d], seeds[d]));
  return point;
}

std::uint32_t morton(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint32_t v) {
    v &= 0xffffu;
    v = (v | (v << 8)) & 0x00ff00ffu;
    v = (v | (v << 4)) & 0x0f0f0f0fu;
    v = (v | (v << 2)) & 0x33333333u;
    return (v | (v << 1)) & 0x55555555u;
  };
  return spread(x) | (spread(y) << 1);
}

}  // namespace heckbert::transport
