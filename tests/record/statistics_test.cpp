#include <heckbert/record/statistics.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/word_literal.h>

#include "synthetic.h"

namespace heckbert::record {
namespace {

using namespace taxonomy::literals;

TEST(StudentQuantile, AgreesWithTheTables) {
  struct Case {
    double probability;
    int degrees;
    double quantile;
  };
  constexpr std::array kCases{
      Case{0.975, 1, 12.706204736},  Case{0.975, 2, 4.302652730},  Case{0.975, 3, 3.182446305},
      Case{0.975, 4, 2.776445105},   Case{0.975, 5, 2.570581836},  Case{0.975, 10, 2.228138852},
      Case{0.975, 30, 2.042272456},  Case{0.975, 31, 2.039513446}, Case{0.975, 120, 1.979930405},
      Case{0.95, 10, 1.812461123},   Case{0.995, 5, 4.032142984},  Case{0.9995, 7, 5.407882521},
      Case{0.75, 3, 0.764892328},    Case{0.9, 1, 3.077683537},    Case{0.6, 8, 0.261921097},
      Case{0.025, 10, -2.228138852}, Case{0.25, 3, -0.764892328},  Case{0.5, 7, 0},
  };
  for (const Case& c : kCases)
    EXPECT_NEAR(student_quantile(c.probability, c.degrees), c.quantile, 1e-8 * std::max(1.0, std::abs(c.quantile)))
        << c.probability << ' ' << c.degrees;
}

/// A record of one pixel and three words whose batch means are given; grey, so that luminance is the value itself.
Record record_with(int samples_per_pixel, const std::vector<std::vector<float>>& by_word_and_batch) {
  Record record;
  record.info = info_for({0, 0, 1, 1}, samples_per_pixel);
  record.words = {"LE"_word, "LDE"_word, "LSE"_word};
  record.counts.assign(3, 20);
  record.batch_means.resize(std::size_t{3} * kBatches);
  for (std::size_t w = 0; w < by_word_and_batch.size(); ++w)
    for (std::size_t b = 0; b < by_word_and_batch[w].size(); ++b)
      record.batch_means[w * kBatches + b] = Rgb(by_word_and_batch[w][b]);
  return record;
}

constexpr double kFloatNoise = 1e-6;  // batch means and luminance are floats

/// Bounds of the mean of a compound Poisson variable (Fay and Feuer 1997), with Wilson and Hilferty's quantiles.
struct Bounds {
  double lower, upper;
};
Bounds bounds_of(double mean, double error, double t) {
  const double found = mean * mean / (error * error), size = error * error / mean;
  const auto quantile = [](double shape, double z) {
    return shape * std::pow(1 - 1 / (9 * shape) + z / (3 * std::sqrt(shape)), 3);
  };
  return {size * quantile(found, -t), size * quantile(found + 1, t)};
}

TEST(Energy, IsTheMeanOfTheBatchesWithTheIntervalOfACompoundPoissonVariable) {
  // Sums over both chosen words: 2, 4, 6, 8. Mean 5, variance of the batches 20/3, error sqrt(20/3/4).
  const Record record = record_with(4, {{1, 1, 2, 2}, {1, 3, 4, 6}, {9, 9, 9, 9}});
  const Estimate e = energy(record, {true, true, false}, 0.9);
  EXPECT_TRUE(e.known);
  EXPECT_NEAR(e.mean, 5, kFloatNoise);
  EXPECT_NEAR(e.standard_error, std::sqrt(5.0 / 3), kFloatNoise);
  const Bounds expected = bounds_of(5, std::sqrt(5.0 / 3), 2.353363435);  // t(0.95, 3)
  EXPECT_NEAR(e.lower, expected.lower, 5 * kFloatNoise);
  EXPECT_NEAR(e.upper, expected.upper, 5 * kFloatNoise);
  EXPECT_NEAR(luminance(mean_colour(record, {true, true, false})), 5, kFloatNoise);
}

TEST(Energy, HasStudentsIntervalWhereMuchWasFound) {
  const Record record = record_with(4, {{1e5f + 2, 1e5f + 4, 1e5f + 6, 1e5f + 8}});
  const Estimate e = energy(record, {true, false, false}, 0.9);
  const double half = 2.353363435 * std::sqrt(5.0 / 3);
  EXPECT_NEAR(e.upper - e.mean, half, 1e-3 * half);
  EXPECT_NEAR(e.mean - e.lower, half, 1e-3 * half);
}

TEST(Energy, WeighsBatchesByTheirSamples) {
  // 33 samples in 32 batches: the first has two samples. Batch means 3 and 31 times 0: sample mean 2 * 3 / 33.
  std::vector<float> means(32);
  means[0] = 3;
  const Record record = record_with(33, {means});
  EXPECT_NEAR(energy(record, {true, false, false}).mean, 6.0 / 33, kFloatNoise);
  EXPECT_NEAR(luminance(mean_colour(record, {true, false, false})), 6.0 / 33, kFloatNoise);
}

TEST(Energy, DoesNotReachBelowZero) {
  const Record record = record_with(2, {{0, 1}});
  const Estimate e = energy(record, {true, false, false});
  EXPECT_EQ(e.lower, 0);
  EXPECT_GT(e.upper, 1);
}

TEST(Share, HasTheErrorOfTheDeltaMethod) {
  // Parts 1, 3; wholes 4, 4: ratio 1/2, residuals -1, 1, error of their mean 1, over the whole 1/4.
  const Record record = record_with(2, {{1, 3}, {3, 1}});
  const Estimate e = share(record, {true, false, false}, {true, true, false}, 0.5);
  EXPECT_NEAR(e.mean, 0.5, kFloatNoise);
  EXPECT_NEAR(e.standard_error, 0.25, kFloatNoise);
  const Bounds expected = bounds_of(0.5, 0.25, 1);  // t(0.75, 1)
  EXPECT_NEAR(e.upper, expected.upper, kFloatNoise);
  EXPECT_NEAR(e.lower, expected.lower, kFloatNoise);
}

TEST(Share, OfAPartThatFollowsTheWholeIsCertainHoweverNoisyTheWhole) {
  const Record record = record_with(4, {{1, 5, 2, 8}, {3, 15, 6, 24}});
  const Estimate e = share(record, {true, false, false}, {true, true, false});
  EXPECT_NEAR(e.mean, 0.25, kFloatNoise);
  EXPECT_NEAR(e.upper - e.lower, 0, kFloatNoise);
}

TEST(Share, OfEverythingIsExact) {
  for (const int samples : {1, 2}) {
    const Record record = record_with(samples, {{1, 7}, {3, 1}});
    const std::vector<bool> all{true, true, true};
    const Estimate one = share(record, all, all);
    EXPECT_TRUE(one.known);
    EXPECT_EQ(one.mean, 1);
    EXPECT_EQ(one.lower, 1);
    EXPECT_EQ(one.upper, 1);
  }
}

TEST(Share, OfNothingIsZeroAndNotKnownFromOneBatch) {
  const Record record = record_with(1, {{1}, {3}});
  const Estimate e = share(record, {false, false, false}, {true, true, true});
  EXPECT_EQ(e.mean, 0);
  EXPECT_FALSE(e.known);
}

TEST(Estimate, OfWhatWasNotFoundIsZeroUpToSomeContributions) {
  // Sixty contributions make 12 in the mean, one of them 0.2. With 31 degrees of freedom the 97.5 % quantile for none
  // found is 3.87 of them; 3.69 would be Poisson's, were their spread known.
  Record record = record_with(32, {std::vector<float>(32, 12)});
  record.tally.hits = 50;
  record.tally.next_events = 10;
  const std::vector<bool> none{false, false, false}, all{true, true, true};
  const Estimate energy_of_none = energy(record, none), share_of_none = share(record, none, all);
  EXPECT_EQ(energy_of_none.mean, 0);
  EXPECT_EQ(energy_of_none.lower, 0);
  EXPECT_NEAR(energy_of_none.upper, 0.2 * 3.87, 0.01);
  EXPECT_NEAR(share_of_none.upper, 3.87 / 60, 0.001);
  EXPECT_EQ(share_of_none.lower, 0);
}

TEST(Estimate, OfWhatWasNotFoundSupposesPathsLikeThoseOfWordsFoundOnce) {
  // Two words of one path each, 3 and 5 in the mean; the third has 40 paths that make 16.
  Record record = record_with(32, {std::vector<float>(32, 16), std::vector<float>(32, 3), std::vector<float>(32, 5)});
  record.counts = {40, 1, 1};
  record.tally.hits = 42;
  const std::vector<bool> none{false, false, false};
  EXPECT_NEAR(contribution_if_none(record), 4, kFloatNoise);
  EXPECT_NEAR(energy(record, none).upper, 4 * 3.87, 0.1);
  record.counts = {1, 21, 20};
  std::fill_n(record.batch_means.begin(), kBatches, Rgb(0.1f));
  EXPECT_NEAR(contribution_if_none(record), 8.1 / 42, kFloatNoise) << "and is not less than the average";
}

TEST(Share, StaysBetweenNothingAndEverything) {
  const Record record = record_with(2, {{0, 4}, {4, 1}});
  const Estimate e = share(record, {true, false, false}, {true, true, false});
  EXPECT_EQ(e.lower, 0);
  EXPECT_EQ(e.upper, 1);
  EXPECT_GT(share(record, {true, true, false}, {true, false, false}).upper, 2) << "not a part of the whole";
}

TEST(Share, OfADarkPictureIsZero) {
  const Record record = record_with(2, {{0, 0}, {0, 0}});
  EXPECT_EQ(share(record, {true, false, false}, {true, true, true}).mean, 0);
}

TEST(Estimate, IsOfUnknownSpreadFromOneBatch) {
  const Record record = record_with(1, {{2}, {6}});
  const Estimate e = energy(record, {true, false, false});
  const Estimate s = share(record, {true, false, false}, {true, true, false});
  for (const auto& [estimate, value] : {std::pair{e, 2.0}, {s, 0.25}}) {
    EXPECT_FALSE(estimate.known);
    EXPECT_NEAR(estimate.mean, value, kFloatNoise);
    EXPECT_EQ(estimate.lower, estimate.mean);
    EXPECT_EQ(estimate.upper, estimate.mean);
  }
}

/// 95 % intervals of 500 records, seeds 0 to 499, each of 4 pixels with 48 samples (batches of one and of two). Samples
/// find LE (mean 0.5, exponential), LDE (mean 2, uniform in 0..4) and LSE (a rare bright one: 8 in one of five).
/// Five counts; each is binomial, and with the nominal 95 % leaves [90 %, 99 %] with probability below 1e-4.
TEST(Interval, HoldsTheTruthAsOftenAsItSays) {
  constexpr int kRecords = 500;
  const RenderInfo info = info_for({0, 0, 2, 2}, 48);
  const std::array<std::vector<bool>, 3> one{{{true, false, false}, {false, true, false}, {false, false, true}}};
  const std::vector<bool> all{true, true, true};
  const std::array<double, 3> means{0.5, 2, 1.6};
  std::array<int, 3> energies_held{};
  std::array<int, 2> shares_held{};
  for (std::uint64_t seed = 0; seed < kRecords; ++seed) {
    std::mt19937_64 random(seed);
    std::exponential_distribution<float> exponential(2);
    std::uniform_real_distribution<float> uniform(0, 4);
    TileRecorder recorder(info);
    recorder.begin_tile(info.window);
    const auto words = {node_of(recorder.words(), "LE"_word), node_of(recorder.words(), "LDE"_word),
                        node_of(recorder.words(), "LSE"_word)};
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 2; ++x) {
        for (int s = 0; s < 48; ++s) {
          recorder.begin_sample(x, y, s);
          const std::array values{exponential(random), uniform(random), random() % 5 == 0 ? 8.0f : 0.0f};
          for (std::size_t w = 0; w < 3; ++w) recorder.add({words.begin()[w], Rgb(values[w]), Technique::Hit});
        }
      }
    }
    Assembler assembler(info);
    assembler.submit(recorder.end_tile());
    const Record record = assembler.finish(false);
    const auto holds = [](const Estimate& e, double truth) { return e.lower <= truth && truth <= e.upper ? 1 : 0; };
    for (std::size_t w = 0; w < 3; ++w) energies_held[w] += holds(energy(record, one[w]), means[w]);
    shares_held[0] += holds(share(record, one[0], all), 0.5 / 4.1);
    shares_held[1] += holds(share(record, one[2], all), 1.6 / 4.1);
  }
  for (const int held : {energies_held[0], energies_held[1], energies_held[2], shares_held[0], shares_held[1]}) {
    EXPECT_GE(held, kRecords * 90 / 100);
    EXPECT_LE(held, kRecords * 99 / 100);
  }
}

/// A word that is found as one contribution of size one in some samples, `expected` of them on average, among as many
/// of another word as there are samples.
struct RareWord {
  double expected;
  int least;  ///< of the records, in which the truth must be held
  int energies_held = 0, shares_held = 0;
};

// Few contributions, or none. Of 500 records the intervals of energies held the truth in 492, 493, 489 and 474, those
// of shares in one fewer to three more: counts are whole, so that a rare word's interval is held rather more often than
// it says. The bounds are three standard deviations below. Student's interval about the mean of the batches would hold
// in 63, 95, 90 and 94 of a hundred.
TEST(Interval, HoldsTheTruthOfRareWords) {
  constexpr int kRecords = 500, kSamples = 64, kPixels = 4;
  const RenderInfo info = info_for({0, 0, 2, 2}, kSamples);
  RareWord rows[] = {{1, 483}, {3, 485}, {8, 480}, {30, 460}};
  for (RareWord& row : rows) {
    const double chance = row.expected / (kPixels * kSamples);
    for (std::uint64_t seed = 0; seed < kRecords; ++seed) {
      std::mt19937_64 random(seed);
      std::uniform_real_distribution<double> uniform(0, 1);
      TileRecorder recorder(info);
      recorder.begin_tile(info.window);
      const auto rare = node_of(recorder.words(), "LSE"_word), frequent = node_of(recorder.words(), "LE"_word);
      for (int pixel = 0; pixel < kPixels; ++pixel)
        for (int s = 0; s < kSamples; ++s) {
          recorder.begin_sample(pixel % 2, pixel / 2, s);
          recorder.add({frequent, Rgb(1), Technique::Hit});
          if (uniform(random) < chance) recorder.add({rare, Rgb(1), Technique::Hit});
        }
      Assembler assembler(info);
      assembler.submit(recorder.end_tile());
      const Record record = assembler.finish(false);
      const std::vector<bool> chosen = members(record, taxonomy::compile("L S E"));
      const auto holds = [](const Estimate& e, double truth) { return e.lower <= truth && truth <= e.upper ? 1 : 0; };
      row.energies_held += holds(energy(record, chosen), chance);
      row.shares_held += holds(share(record, chosen, std::vector<bool>(chosen.size(), true)), chance / (1 + chance));
    }
    for (const int held : {row.energies_held, row.shares_held}) {
      EXPECT_GE(held, row.least) << row.expected;
      EXPECT_LE(held, kRecords * 995 / 1000) << row.expected;
    }
  }
}

}  // namespace
}  // namespace heckbert::record
