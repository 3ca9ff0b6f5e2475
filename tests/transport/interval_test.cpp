// 95 % intervals hold the truth as often as they say: docs/decisions/2026-11-27-intervals.md.

#include "intervals.h"

namespace heckbert::transport {
namespace {

// 200 seeds: the number of intervals that hold the truth is binomial, 190 expected, 3.1 its standard deviation; 180 is
// 90 %. Those of words that few paths find may hold it always.
TEST(Interval, HoldsTheTruthOfFrequentAndRareWordsInScenes) {
  constexpr int kSeeds = 200;
  for (const SamplerFacts& sampler : kSamplers)
    for (const Sampled how : {Sampled::Whole, Sampled::Cropped, Sampled::Adaptive})
      for (const Held& row : count_held(sampler.kind, how, kSeeds))
        EXPECT_GE(row.energies, kSeeds * 90 / 100) << sampler.name << ", " << static_cast<int>(how) << ", " << row.word;
}

}  // namespace
}  // namespace heckbert::transport
