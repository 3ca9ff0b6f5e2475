// No light is lost in silence: what the depth limit cuts off is estimated, and in the furnace its value is known; what
// roulette ends is on average nothing; walks that leave where there is no sky are counted.

#include <gtest/gtest.h>

#include <heckbert/record/statistics.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr float kD = 0.5f, kS = 0.3f;

record::Record furnace_to(int max_depth, AlgorithmId algorithm) {
  return render(furnace(kD, kS),
                {.algorithm = algorithm, .width = 32, .height = 32, .samples_per_pixel = 256, .max_depth = max_depth});
}

/// z-test, 1 % over the eight limits of this file after Sidak.
void expect_cut_off(const record::Record& record, double expected, const char* what) {
  const record::Estimate e = record::cut_off(record.info, record.tally);
  EXPECT_NEAR(e.mean, expected, 3.23 * e.standard_error) << what;
  EXPECT_LT(e.standard_error, 0.05 * expected) << what << ": too noisy to say anything";
}

double geometric_tail(double ratio, int first) {
  return std::pow(ratio, first) / (1 - ratio);
}

TEST(DepthLimit, CutsOffWhatTheFurnaceSays) {
  for (const int limit : {0, 1, 3, 8}) {
    const record::Record record = furnace_to(limit, AlgorithmId::Path);
    EXPECT_GT(record.tally.depth_limited, 0u);
    expect_cut_off(record, geometric_tail(kD + kS, limit + 1), "path");
  }
}

TEST(DepthLimit, OfTheRecursiveTracersCutsOffTheirOwnWordsOnly) {
  for (const AlgorithmId algorithm : {AlgorithmId::Whitted, AlgorithmId::Lecture})
    for (const int limit : {1, 3}) {
      const record::Record record = furnace_to(limit, algorithm);
      // L D? S* E: of words with k scatterings there are s^k and d s^(k-1).
      expect_cut_off(record, geometric_tail(kS, limit + 1) + kD * geometric_tail(kS, limit), "recursive");
    }
}

TEST(DepthLimit, LeavesTheWordsBelowItAsTheyAre) {
  const record::Record record = furnace_to(3, AlgorithmId::Path);
  std::map<std::string, double> truth;
  for (const std::string& word : words_over_ds(3)) truth[word] = product_of_albedos(word, kD, kS);
  expect_energies(record, truth);
  EXPECT_EQ(record.words.size(), truth.size());
}

TEST(DepthLimit, ThatNoWalkReachesCutsOffNothing) {
  const record::Record record = render(inside_sphere(emitter(1)), {.width = 8, .height = 8, .samples_per_pixel = 4});
  EXPECT_EQ(record.tally.depth_limited, 0u);
  EXPECT_EQ(record::cut_off(record.info, record.tally).mean, 0.0);
}

// Walks from the light, and their joins, end at the limit without a look at what lies beyond.
TEST(DepthLimit, IsSaidToBeUnknownWhereNothingWasEstimated) {
  for (const AlgorithmFacts& algorithm : kAlgorithms) {
    const RenderSettings settings{
        .algorithm = algorithm.id, .width = 8, .height = 8, .samples_per_pixel = 4, .max_depth = 2};
    const record::Record record = render(furnace(kD, 0), settings);
    EXPECT_EQ(record::cut_off(record.info, record.tally).known, !algorithm.from_light) << algorithm.name;
  }
}

TEST(Escape, IsCountedApartWhereThereIsNoEnvironment) {
  Scene scene;
  add(scene, Sphere{{0, 0, 0}, 1}, diffuse(0.5f));
  scene.camera = {.position = {0, 0, 4}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 60};
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LeDrEp")) {
    const RenderSettings settings{.algorithm = algorithm.id, .width = 16, .height = 16, .samples_per_pixel = 4};
    scene.environment = Rgb(0);
    const record::Tally dark = render(scene, settings).tally;
    EXPECT_GT(dark.escaped, 0u);
    EXPECT_EQ(dark.escaped_unlit, dark.escaped) << algorithm.name;
    scene.environment = Rgb(1);
    const record::Tally lit = render(scene, settings).tally;
    EXPECT_GT(lit.escaped, 0u);
    EXPECT_EQ(lit.escaped_unlit, 0u) << algorithm.name;
  }
}

/// From inside glass every lamp looks n^2 times as bright. Roulette that took this for strength would let walks live
/// too long; one that divided it out twice would end them with light in hand. Either way it must stay unbiased.
TEST(Roulette, StaysUnbiasedInsideGlass) {
  Scene scene;
  add(scene, make_box({-4, -4, -4}, {4, 4, 4}, true),
      {.name = "wall", .lobes = {Lambert{Rgb(0.5f)}}, .emission = Rgb(1)});
  add(scene, Sphere{{0, 0, 0}, 1}, {.name = "glass", .lobes = {Dielectric{.ior = 1.5f}}});
  scene.camera = {.position = {0.3f, 0.2f, 0.4f}, .look_at = {0.9f, 0.1f, -0.4f}, .vertical_fov_degrees = 90};
  const record::Record record = render(scene, {.width = 32, .height = 32, .samples_per_pixel = 512, .max_depth = 200});
  EXPECT_GT(record.tally.roulette, 0u);
  const record::Estimate e = record::energy(record, std::vector<bool>(record.words.size(), true));
  EXPECT_NEAR(e.mean, 2.25 * 2, 2.75 * e.standard_error);  // Student with 31 degrees of freedom, 1 %
  EXPECT_LT(e.standard_error, 0.01 * e.mean);
}

/// Of walks whose every scattering leaves half. Alone they are safe before the fourth; one that is joined to a walk
/// from the light is asked for the third by itself and then for all four, so that as many get through those. A binomial
/// test, 1 % over two counts after Sidak; the others are certain.
TEST(Roulette, BeginsSoonerWhereTwoWalksAreJoined) {
  const struct {
    AlgorithmId algorithm;
    int scatterings;
    double ended;
  } rows[] = {{AlgorithmId::Path, 3, 0},
              {AlgorithmId::Bidirectional, 2, 0},
              {AlgorithmId::Bidirectional, 3, 0.5},
              {AlgorithmId::Bidirectional, 4, 1 - 1.0 / 16},
              {AlgorithmId::ConnectionAndMerging, 3, 0}};
  for (const auto& [algorithm, scatterings, ended] : rows) {
    const record::Record record =
        render(furnace(0.5f, 0),
               {.algorithm = algorithm, .width = 16, .height = 16, .samples_per_pixel = 64, .max_depth = scatterings});
    const double walks = 16 * 16 * 64;
    EXPECT_NEAR(static_cast<double>(record.tally.roulette), walks * ended,
                2.81 * std::sqrt(walks * ended * (1 - ended)))
        << facts(algorithm).name << ", " << scatterings;
  }
}

/// The same of the walk from the light, whose first scattering may end it: of its vertices, which lie alike all over
/// the box, the eye sees half as many second as first ones. Both counts are nearly Poisson's; 1 % for the two rows.
TEST(Roulette, BeginsAtTheFirstScatteringOfAJoinedWalkFromTheLight) {
  const struct {
    AlgorithmId algorithm;
    double share;
  } rows[] = {{AlgorithmId::Light, 1}, {AlgorithmId::Bidirectional, 0.5}};
  for (const auto& [algorithm, share] : rows) {
    double first = 0, second = 0;
    for (const record::TechniqueSum& sum : measure_techniques(
             furnace(0.5f, 0),
             {.algorithm = algorithm, .width = 32, .height = 32, .samples_per_pixel = 64, .max_depth = 3})) {
      if (sum.technique.eye_vertices(sum.word.length()) != 1) continue;
      if (sum.word.length() == 1) first += static_cast<double>(sum.count);
      if (sum.word.length() == 2) second += static_cast<double>(sum.count);
    }
    ASSERT_GT(first, 1000) << facts(algorithm).name;
    EXPECT_NEAR(second, share * first, 2.81 * std::sqrt(second + share * share * first)) << facts(algorithm).name;
  }
}

}  // namespace
}  // namespace heckbert::transport
