// The recursive tracers along one branch find what the whole tree finds: every word with the same energy, and never
// branch.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/word.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

/// A box with a glass ball, a mirror and a floor that is matt and lacquered, under a lamp.
Scene shiny_room() {
  Scene scene;
  add(scene, make_box({-2, -1, -2}, {2, 2, 2}, true), diffuse(0.6f));
  add(scene, make_quad({-1.2f, 1.99f, -1.2f}, {2.4f, 0, 0}, {0, 0, 2.4f}), emitter(1));
  add(scene, make_quad({-1.99f, -0.5f, -1}, {0, 0, 2}, {0, 1.5f, 0}), {.name = "mirror", .lobes = {Mirror{Rgb(0.9f)}}});
  add(scene, Sphere{{0.5f, -0.3f, 0.2f}, 0.7f}, {.name = "glass", .lobes = {Dielectric{}}});
  add(scene, make_box({-1.5f, -1, -1.5f}, {1.5f, -0.9f, 1.5f}),
      {.name = "lacquer", .lobes = {Lambert{Rgb(0.3f)}, ggx(Rgb(0.3f), 0.5f), Mirror{Rgb(0.3f)}}});
  scene.camera = {.position = {1.6f, 0.4f, 1.8f}, .look_at = {-0.4f, -0.2f, -0.4f}, .vertical_fov_degrees = 70};
  return scene;
}

class Branching : public ::testing::TestWithParam<AlgorithmId> {};

/// z-tests of every word that both find often, 1 % for all together (Sidak, at most 60 words).
TEST_P(Branching, AlongOneBranchGivesEveryWordItsEnergyAndNeverBranches) {
  const Scene scene = shiny_room();
  RenderSettings settings{.algorithm = GetParam(), .width = 24, .height = 24, .samples_per_pixel = 256, .max_depth = 6};
  const record::Record tree = render(scene, settings);
  settings.seed = 2;
  settings.method.one_branch = true;
  const record::Record one = render(scene, settings);
  const auto ends = [](const record::Tally& t) {
    return t.escaped + t.escaped_unlit + t.absorbed + t.depth_limited + t.roulette;
  };
  EXPECT_EQ(ends(one.tally), one.tally.samples);
  EXPECT_GT(ends(tree.tally), tree.tally.samples * 3 / 2);
  constexpr double kQuantile = 3.78;  // of the normal distribution, at 1 - 0.01 / 120
  int compared = 0;
  double captured = 0;
  std::set<std::string> words;
  for (const taxonomy::Word& word : tree.words) words.insert(taxonomy::plain(word));
  for (const std::string& word : words) {
    const record::Estimate expected = energy_of(tree, word), found = energy_of(one, word);
    if (std::min(expected.mean / expected.standard_error, found.mean / found.standard_error) < 12) continue;
    EXPECT_LT(std::abs(found.mean - expected.mean),
              kQuantile * std::hypot(found.standard_error, expected.standard_error))
        << word << ": " << found.mean / expected.mean;
    captured += expected.mean;
    ++compared;
  }
  EXPECT_GE(compared, 4);
  EXPECT_LE(compared, 60);
  EXPECT_GT(captured, 0.95 * record::energy(tree, std::vector<bool>(tree.words.size(), true)).mean);
}

INSTANTIATE_TEST_SUITE_P(Recursive, Branching,
                         ::testing::Values(AlgorithmId::Whitted, AlgorithmId::Lecture, AlgorithmId::Distribution));

}  // namespace
}  // namespace heckbert::transport
