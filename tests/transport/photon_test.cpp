// Photons. On the inside of a ball the part of the wall that is nearer than r to a place of it has an area of exactly
// pi r^2, whatever the curvature; where light is spread evenly, as in the anchors A1 and A2, the estimate from photons
// is therefore right for every radius, word by word, as long as none is lost that came along the curved wall. In a box
// it is not: near the edges part of the disc is missing.

#include <map>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/strategies.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr AlgorithmId kMerging[] = {AlgorithmId::PhotonMap, AlgorithmId::FinalGathering,
                                    AlgorithmId::ProgressivePhotons, AlgorithmId::ConnectionAndMerging};
constexpr double kD = 0.5, kS = 0.3;

Material wall(float emission) {
  return {.name = "wall",
          .lobes = {Lambert{Rgb(0.5f)}, Mirror{Rgb(0.3f)}},
          .emission = Rgb(emission),
          .emission_sides = Sides::Both};
}

RenderSettings settings_of(AlgorithmId algorithm, float radius) {
  return {.algorithm = algorithm,
          .width = 24,
          .height = 24,
          .samples_per_pixel = 128,
          .max_depth = 4,
          .seed = 7,
          .method = {.photon_radius = radius}};
}

TEST(Photons, OfAGlowingBallGiveEveryWordItsValue) {
  for (const AlgorithmId algorithm : kMerging) {
    std::map<std::string, double> truth;
    for (const std::string& word : words_over_ds(3)) truth[word] = product_of_albedos(word, kD, kS);
    expect_energies(render(inside_sphere(wall(1)), settings_of(algorithm, 0.2f)), truth);
  }
}

TEST(Photons, OfAPointFindWhatNoJoinedWalksCan) {
  // From the centre of the ball all light comes back through the centre, however often it is mirrored.
  Scene scene = inside_sphere(wall(0));
  scene.point_lights.push_back({.position = {0, 0, 0}, .intensity = Rgb(std::numbers::pi_v<float>)});
  std::map<std::string, double> truth;
  for (const std::string& word : words_over_ds(3))
    if (word.find('D') != std::string::npos) truth[word] = product_of_albedos(word, kD, kS);
  for (const AlgorithmId algorithm : kMerging) {
    const record::Record record = render(scene, settings_of(algorithm, 0.2f));
    expect_energies(record, truth);
    EXPECT_EQ(energy_of(record, "LSE").mean, 0);
  }
  const record::Record joined = render(scene, settings_of(AlgorithmId::Bidirectional, 0.1f));
  for (const char* word : {"LSDSE", "LSSDSE", "LSDSSE"}) {
    taxonomy::Word spelt = taxonomy::parse_word(word);
    spelt.light = taxonomy::Symbol::Lp;
    EXPECT_TRUE(taxonomy::strategies(spelt).empty()) << word;
    EXPECT_EQ(energy_of(joined, word).mean, 0) << word;
  }
}

/// How final gathering should find a word over D and S: what the diffuse surface nearest the eye is lit by decides.
record::Technique part_of(const std::string& word) {
  const std::string events = word.substr(1, word.size() - 2);
  const std::size_t last = events.rfind('D');
  if (last == std::string::npos) return record::Technique::Hit;
  if (last == 0) return record::Technique::NextEvent;
  const std::size_t gathered = events.rfind('D', last - 1);
  const std::size_t merged = gathered == std::string::npos ? last : gathered;
  return {static_cast<std::uint16_t>(merged + 2), true};  // the light, and the surfaces up to there
}

TEST(FinalGathering, FindsEveryWordInOneWay) {
  std::map<std::string, std::set<record::Technique>> found, expected;
  for (const record::TechniqueSum& sum :
       measure_techniques(inside_sphere(wall(1)), settings_of(AlgorithmId::FinalGathering, 0.1f)))
    found[taxonomy::plain(sum.word)].insert(sum.technique);
  for (const std::string& word : words_over_ds(4)) expected[word] = {part_of(word)};
  EXPECT_EQ(found, expected);
}

// Rays and photons only share the work.
TEST(FinalGathering, GivesTheSameForAnyNumberOfRaysAndPhotons) {
  std::map<std::string, double> truth;
  for (const std::string& word : words_over_ds(3)) truth[word] = product_of_albedos(word, kD, kS);
  RenderSettings settings = settings_of(AlgorithmId::FinalGathering, 0.1f);
  settings.seed = 8;
  settings.method.photons_per_pixel = 3;
  settings.method.gather_rays = 1;
  expect_energies(render(inside_sphere(wall(1)), settings), truth);
}

TEST(Photons, LoseTheLightOfEdgesInProportionToTheRadius) {
  struct Loss {
    double mean = 0, error = 0;
  };
  std::vector<Loss> losses;
  for (const float radius : {0.24f, 0.12f, 0.06f}) {
    RenderSettings settings = settings_of(AlgorithmId::PhotonMap, radius);
    settings.samples_per_pixel = 512;
    settings.max_depth = 1;
    const record::Estimate e = energy_of(render(furnace(0.5f, 0.3f), settings), "LDE");
    losses.push_back({1 - e.mean / kD, e.standard_error / kD});
  }
  // z-tests, 1 % over three after Sidak: half the radius, half the loss.
  constexpr double kBound = 2.93;
  for (std::size_t i = 0; i + 1 < losses.size(); ++i)
    EXPECT_NEAR(losses[i].mean, 2 * losses[i + 1].mean, kBound * std::hypot(losses[i].error, 2 * losses[i + 1].error));
  EXPECT_GT(losses[0].mean - losses[2].mean, kBound * std::hypot(losses[0].error, losses[2].error));
}

}  // namespace
}  // namespace heckbert::transport
