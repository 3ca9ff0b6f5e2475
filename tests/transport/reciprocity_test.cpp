// Light paths can be walked both ways. An isotropic point light at P and an eye at Q that looks in all directions: the
// light that reaches Q from P along a word, added up over all directions, is what reaches P from Q along the reversed
// word when the two change places (Veach 1997, 4.5 to 5.2). This sees what a furnace cannot: a wrong direction, cosine
// or squared index, in any class.

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

/// Nothing symmetric: a rough metal floor, a wall, a sheet that lets light through diffusely, a ball of glass,
/// and perhaps fog.
Scene lopsided_room(bool with_fog) {
  Scene scene;
  if (with_fog) {
    scene.media = {{.name = "fog", .absorption = Rgb(0.02f), .scattering = Rgb(0.15f), .anisotropy = 0.4f}};
    scene.medium = 0;
  }
  add(scene, make_quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}),
      {.name = "metal", .lobes = {Lambert{Rgb(0.2f)}, ggx(Rgb(0.6f), 0.4f)}});
  add(scene, make_quad({-2, 0, -2}, {4, 0.3f, 0}, {0, 3, 0}), diffuse(0.7f));
  add(scene, make_quad({-0.2f, 0.5f, -1.5f}, {0.1f, 0, 1.2f}, {0, 1.5f, 0.2f}),
      {.name = "paper", .lobes = {Lambert{Rgb(0.3f)}, DiffuseTransmission{Rgb(0.4f)}}});
  add(scene, Sphere{{1.0f, 0.7f, 0.3f}, 0.6f}, {.name = "glass", .lobes = {Dielectric{.ior = 1.6f}}});
  return scene;
}

constexpr glm::vec3 kHere{-1.2f, 1.3f, 0.4f}, kThere{1.9f, 1.7f, -0.6f};

struct Mean {
  double value = 0, standard_error = 0;
};

struct Picture {
  AlgorithmId algorithm;
  int width, height;
};
constexpr Picture kFromTheEye{AlgorithmId::Path, 64, 192}, kFromBothEnds{AlgorithmId::Bidirectional, 32, 96};

/// The light that arrives at the eye from all directions, by plain word.
std::map<std::string, Mean> fluence(const Picture& picture, bool with_fog, glm::vec3 light, glm::vec3 eye, int longest,
                                    std::uint64_t seed) {
  constexpr int kRuns = 24;
  Scene scene = lopsided_room(with_fog);
  scene.point_lights = {{.position = light, .intensity = Rgb(1)}};
  scene.camera = {.position = eye, .look_at = eye + glm::vec3(0.3f, 0, 1), .projection = Projection::Panoramic};
  std::map<std::string, std::array<double, kRuns>> runs;
  for (std::size_t run = 0; run < kRuns; ++run) {
    const record::Record record = render(scene, {.algorithm = picture.algorithm,
                                                 .width = picture.width,
                                                 .height = picture.height,
                                                 .samples_per_pixel = 4,
                                                 .max_depth = longest,
                                                 .seed = seed + run});
    std::vector<double> sums(record.words.size());
    for (int y = 0; y < picture.height; ++y) {
      // Latitude runs from pole to pole.
      const double pixel =
          2 * M_PI / picture.width * (std::cos(M_PI * y / picture.height) - std::cos(M_PI * (y + 1) / picture.height));
      for (int x = 0; x < picture.width; ++x)
        for (const record::Entry& entry : record.pixel(x, y))
          sums[entry.word] += pixel * static_cast<double>(entry.energy.g);
    }
    for (std::size_t w = 0; w < sums.size(); ++w) runs[taxonomy::plain(record.words[w])][run] += sums[w];
  }
  std::map<std::string, Mean> means;
  for (const auto& [word, values] : runs) {
    double sum = 0, squares = 0;
    for (const double v : values) {
      sum += v;
      squares += v * v;
    }
    const double mean = sum / kRuns;
    means[word] = {mean, std::sqrt(std::max(0.0, squares / kRuns - mean * mean) / (kRuns - 1))};
  }
  return means;
}

std::string reversed(const std::string& word) {
  std::string r = word;
  std::reverse(r.begin() + 1, r.end() - 1);
  return r;
}

void expect_reciprocity(const Picture& picture, bool with_fog, const std::vector<std::string>& words) {
  std::size_t longest = 0;
  for (const std::string& word : words) longest = std::max(longest, word.size() - 2);
  const auto there = fluence(picture, with_fog, kHere, kThere, static_cast<int>(longest), 1000);
  const auto back = fluence(picture, with_fog, kThere, kHere, static_cast<int>(longest), 2000);
  for (const std::string& word : words) {
    const auto a = there.find(word), b = back.find(reversed(word));
    ASSERT_TRUE(a != there.end() && b != back.end()) << word;
    const double error = std::hypot(a->second.standard_error, b->second.standard_error);
    // Two-sample test with 46 degrees of freedom, 1 % over the 26 rows of this file after Sidak.
    EXPECT_NEAR(a->second.value, b->second.value, 3.82 * error) << word << " and " << reversed(word);
    EXPECT_GT(a->second.value, 0) << word;
    EXPECT_LT(error, 0.12 * a->second.value) << word << ": too noisy to say anything";
  }
}

TEST(Reciprocity, OfEveryWordBetweenSurfaces) {
  expect_reciprocity(kFromTheEye, false,
                     {"LDE", "LGE", "LDDE", "LGDE", "LDGE", "LDDDE", "LDGDE", "LDSSDE", "LDSSGE", "LGSSDE"});
}

TEST(Reciprocity, OfWordsThroughAMedium) {
  expect_reciprocity(kFromTheEye, true, {"LVE", "LDVE", "LVDE", "LVVE", "LDVDE", "LGVE"});
}

// Light that a ball of glass throws into the fog, and fog seen in the ball, too.
TEST(Reciprocity, OfWordsThroughAMediumWalkedFromBothEnds) {
  expect_reciprocity(kFromBothEnds, true,
                     {"LVE", "LDVE", "LVDE", "LVVE", "LDVDE", "LGVE", "LSSVE", "LVSSE", "LSSDE", "LVVVE"});
}

}  // namespace
}  // namespace heckbert::transport
