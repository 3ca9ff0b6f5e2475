#pragma once
// Owen-scrambled Sobol points as a function of their index: low-discrepancy sequences without tables to carry along.
//
// Points come in sets of four dimensions. Every set is the first four dimensions of Sobol's sequence (Joe and Kuo 2008;
// made here from its first primitive polynomials), in an order of its own and under a scramble of its own, so that any
// number of sets can be padded side by side (Burley 2020, "Practical Hash-based Owen Scrambling"). The scramble is the
// hash of Laine and Karras (2011), whose higher bits depend on the lower ones alone, with Vegdahl's constants (2021).

#include <array>
#include <cstdint>

namespace heckbert::transport {

using SobolPoint = std::array<std::uint32_t, 4>;  ///< fractions of 2^32

/// Point `index` of the set that belongs to `seed`. Each point alone is uniform in the unit cube over the seeds, and
/// any 2^m points with indices [k 2^m, (k+1) 2^m) are evenly spread.
SobolPoint scrambled_sobol(std::uint32_t index, std::uint64_t seed);

/// Interleaves the bits of two numbers of 16 bits: neighbours in the plane stay near in the order (Morton 1966).
std::uint32_t morton(std::uint32_t x, std::uint32_t y);

}  // namespace heckbert::transport
