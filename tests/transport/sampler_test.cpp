// Points: evenly spread where that is promised, uniform and independent where that is needed, and intervals that hold
// what they say.

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/transport/sampler.h>
#include <heckbert/transport/sobol.h>

#include "chi_square.h"
#include "test_scenes.h"

namespace heckbert::transport {
namespace {

TEST(Sobol, EveryAlignedBlockHasOnePointInEachStratumOfEveryDimension) {
  for (const int bits : {1, 4, 8})
    for (const std::uint32_t block : {0u, 3u, 77777u})
      for (const std::uint64_t seed : {1u, 2u}) {
        const std::uint32_t count = 1u << bits;
        std::array<std::set<std::uint32_t>, 4> strata;
        for (std::uint32_t i = 0; i < count; ++i) {
          const SobolPoint p = scrambled_sobol(block * count + i, seed);
          for (std::size_t d = 0; d < 4; ++d) strata[d].insert(p[d] >> (32 - bits));
        }
        for (const auto& s : strata) EXPECT_EQ(s.size(), count) << bits << " " << block;
      }
}

TEST(Sobol, TheFirstTwoDimensionsAreANetInEveryShape) {
  // 2^8 points: one in each of the boxes of 2^k by 2^(8-k), for every k.
  for (const std::uint64_t seed : {1u, 9u})
    for (int k = 0; k <= 8; ++k) {
      std::set<std::uint32_t> boxes;
      for (std::uint32_t i = 0; i < 256; ++i) {
        const SobolPoint p = scrambled_sobol(512 + i, seed);
        const std::uint32_t column = k == 0 ? 0 : p[0] >> (32 - k), row = k == 8 ? 0 : p[1] >> (24 + k);
        boxes.insert(column << 8 | row);
      }
      EXPECT_EQ(boxes.size(), 256u) << k;
    }
}

TEST(Sobol, EachPointIsFreeWithinItsStratum) {
  // A mere shift of the digits would put the 1024 points of a block at one and the same place of their strata.
  for (std::size_t d = 0; d < 4; ++d) {
    std::vector<double> expected(64, 1024 / 64.0), seen(64);
    for (std::uint32_t i = 0; i < 1024; ++i) ++seen[(scrambled_sobol(i, 5)[d] << 10) >> 26];
    EXPECT_LT(chi_square_excess(expected, seen), 3.3) << d;
  }
}

TEST(Sobol, APointIsUniformAndItsDimensionsAreIndependentOverTheSeeds) {
  // 4^4 cells of the four dimensions, 100 000 seeds; four indices at 1 % together after Sidak.
  constexpr int kSeeds = 100'000;
  for (const std::uint32_t index : {0u, 1u, 1000u, 0xfffffu}) {
    std::vector<double> expected(256, kSeeds / 256.0), seen(256);
    for (int n = 0; n < kSeeds; ++n) {
      const SobolPoint p = scrambled_sobol(index, mix(static_cast<std::uint64_t>(n)));
      ++seen[p[0] >> 30 | (p[1] >> 30) << 2 | (p[2] >> 30) << 4 | (p[3] >> 30) << 6];
    }
    EXPECT_LT(chi_square_excess(expected, seen), 3.3) << index;
    // The finest of the leading bits too.
    std::fill(seen.begin(), seen.end(), 0.0);
    for (int n = 0; n < kSeeds; ++n) ++seen[scrambled_sobol(index, mix(static_cast<std::uint64_t>(n)))[2] >> 24];
    EXPECT_LT(chi_square_excess(expected, seen), 3.3) << index;
  }
}

TEST(Sampler, PairsOfDimensionsOfDifferentSetsAreIndependent) {
  // Dimension 0 against dimension 4 (the same one of Sobol's, in the next set), over the samples of many pixels.
  for (const SamplerFacts& facts : kSamplers) {
    constexpr int kSide = 128, kSamples = 4;
    std::vector<double> expected(1024, kSide * kSide * kSamples / 1024.0), seen(1024);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        for (int s = 0; s < kSamples; ++s) {
          Sampler sampler({facts.kind, 7, kSamples}, x, y, s);
          const auto a = static_cast<std::size_t>(sampler.next() * 32);
          for (int skip = 0; skip < 3; ++skip) sampler.next();
          ++seen[32 * a + static_cast<std::size_t>(sampler.next() * 32)];
        }
    EXPECT_LT(chi_square_excess(expected, seen), 3.0) << facts.name;
  }
}

TEST(Sampler, NumbersAreBelowOneAndAFunctionOfTheirPlace) {
  for (const SamplerFacts& facts : kSamplers)
    for (int n = 0; n < 1000; ++n) {
      Sampler a({facts.kind, 3, 100}, n % 40, n / 40, n % 100), b({facts.kind, 3, 100}, n % 40, n / 40, n % 100);
      for (int d = 0; d < 20; ++d) {
        const float u = a.next();
        EXPECT_GE(u, 0);
        EXPECT_LT(u, 1);
        EXPECT_EQ(u, b.next());
      }
      const double fine = a.next_fine();
      EXPECT_GE(fine, 0);
      EXPECT_LT(fine, 1);
    }
}

TEST(Sampler, ThePixelsSamplesOfABatchAreStratified) {
  // 1024 samples: 32 of each batch, one in each of 32 strata of every dimension.
  constexpr int kSamples = 1024;
  for (int batch = 0; batch < 32; batch += 31)
    for (int d = 0; d < 9; ++d) {
      std::set<int> strata;
      for (int s = 32 * batch; s < 32 * batch + 32; ++s) {
        Sampler sampler({SamplerKind::Sobol, 5, kSamples}, 13, 200, s);
        float u = 0;
        for (int k = 0; k <= d; ++k) u = sampler.next();
        strata.insert(static_cast<int>(u * 32));
      }
      EXPECT_EQ(strata.size(), 32u) << batch << " " << d;
    }
}

TEST(Morton, VisitsEveryPlaceOnceAndQuartersAfterQuarters) {
  std::set<std::uint32_t> seen;
  for (std::uint32_t y = 0; y < 64; ++y)
    for (std::uint32_t x = 0; x < 64; ++x) {
      seen.insert(morton(x, y));
      EXPECT_EQ(morton(x, y) / 256, (y / 16) % 2 * 2 + (x / 16) % 2 + 4 * ((y / 32) * 2 + x / 32));
    }
  EXPECT_EQ(seen.size(), 4096u);
  EXPECT_EQ(*seen.rbegin(), 4095u);
}

// ---- honest intervals ---------------------------------------------------------------------------------------------

/// A floor point under a square lamp that also hangs over a mirror: LDE by A8 of docs/anchors.md.
Scene lamp_over_floor() {
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  add(scene, make_quad({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), emitter(2));
  scene.camera = {.position = {2.5f, 0.5f, 2.5f}, .look_at = {0.5f, 0, 0.5f}, .vertical_fov_degrees = 0.01f};
  return scene;
}

TEST(Sampler, IntervalsHoldTheTruthAsOftenAsTheySay) {
  // 300 seeds. The number of 95 % intervals that hold the truth is binomial: 285 expected, 3.8 its standard deviation;
  // 274 to 296 at 0.5 %. The mean of the squared standard errors estimates the variance of the means, whose own
  // estimate has 299 degrees of freedom: their ratio lies within 1 +- 0.24 at 0.5 %. Batches that shared one scramble
  // would hold the truth nearly always, with errors several times too large.
  constexpr int kSeeds = 300;
  constexpr double kTruth = 0.239456471;
  const Scene scene = lamp_over_floor();
  for (const SamplerFacts& facts : kSamplers) {
    int held = 0;
    double squared_errors = 0, sum = 0, sum2 = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
      const auto record = render(scene, {.width = 2,
                                         .height = 2,
                                         .samples_per_pixel = 256,
                                         .max_depth = 1,
                                         .seed = static_cast<std::uint64_t>(seed),
                                         .threads = 1,
                                         .sampler = facts.kind});
      const auto e = energy_of(record, "LDE");
      held += e.lower <= kTruth && kTruth <= e.upper ? 1 : 0;
      squared_errors += e.standard_error * e.standard_error / kSeeds;
      sum += e.mean;
      sum2 += (e.mean - kTruth) * (e.mean - kTruth);
    }
    const double variance = sum2 / kSeeds;
    EXPECT_GE(held, 274) << facts.name;
    EXPECT_LE(held, 296) << facts.name;
    EXPECT_NEAR(variance / squared_errors, 1, 0.24) << facts.name;
    EXPECT_NEAR(sum / kSeeds, kTruth, 3 * std::sqrt(variance / kSeeds)) << facts.name;
  }
}

TEST(Sampler, SobolPointsErrLess) {
  // Equal samples, the same scene: the squared standard error is at most a third.
  const Scene scene = lamp_over_floor();
  double error[2] = {0, 0};
  for (const SamplerFacts& facts : kSamplers)
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const auto record = render(
          scene,
          {.width = 4, .height = 4, .samples_per_pixel = 1024, .max_depth = 1, .seed = seed, .sampler = facts.kind});
      error[facts.kind == SamplerKind::Sobol ? 0 : 1] += std::pow(energy_of(record, "LDE").standard_error, 2);
    }
  EXPECT_LT(error[0], error[1] / 3);
}

}  // namespace
}  // namespace heckbert::transport
