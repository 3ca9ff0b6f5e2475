#include <heckbert/record/sum.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace heckbert::record {
namespace {

/// Floats of every exponent that is taken, seed 1.
std::vector<float> floats() {
  std::mt19937 random(1);
  std::vector<float> values{0.0f, -0.0f, std::numeric_limits<float>::denorm_min(), kMostLight};
  while (values.size() < 100'000) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random() >> 1));
    if (value <= kMostLight) values.push_back(value);
  }
  return values;
}

TEST(Quanta, AreTheFloatItselfUnlessItIsFaint) {
  int exact = 0, rounded = 0;
  for (const float value : floats()) {
    const long double quanta = std::ldexp(static_cast<long double>(value), kQuantumBits);
    const Quanta sum = quanta_of(value);
    if (value >= 0x1p-33f) {
      ASSERT_EQ(static_cast<long double>(sum), quanta) << value;
      ++exact;
    } else {
      ASSERT_EQ(static_cast<long double>(sum), std::floor(quanta + 0.5L)) << value;
      rounded += quanta > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(exact, 20'000);
  EXPECT_GT(rounded, 20'000);
}

TEST(Quanta, AddUpToTheSameInAnyOrder) {
  std::vector<float> values = floats();
  const auto total = [&] {
    return std::accumulate(values.begin(), values.end(), Quanta{0},
                           [](Quanta sum, float value) { return sum + quanta_of(value); });
  };
  const Quanta expected = total();
  std::mt19937 random(2);
  for (int trial = 0; trial < 5; ++trial) {
    std::shuffle(values.begin(), values.end(), random);
    EXPECT_EQ(total(), expected);
  }
}

TEST(Quanta, HaveRoomForMoreOfTheBrightestThanAnyPictureHas) {
  constexpr Quanta kMost = quanta_of(kMostLight);
  EXPECT_GE(~Quanta{0} / kMost, Quanta{1} << 40);
}

TEST(MeanOf, IsTheSumOverTheSamples) {
  RgbSum sum({0.5f, 2.0f, 0.0f});
  sum += RgbSum({0.25f, 1.0f, 3.0f});
  EXPECT_EQ(mean_of(sum, 4), Rgb(0.1875f, 0.75f, 0.75f));
}

}  // namespace
}  // namespace heckbert::record
