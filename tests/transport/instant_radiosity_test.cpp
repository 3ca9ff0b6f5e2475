// Virtual lights. On the inside of a ball every place sends every other the same share of its light (anchor A4), so
// that each virtual light lights the whole wall evenly and words have their values however few there are. What is lost
// when near ones are clamped has a closed form too: the part of the wall nearer than d has an area of pi d^2, and a
// virtual light at distance r < d sends r^2 / d^2 of what it should, hence d^2 / 8 of all is lost in a ball of radius
// one.

#include <numbers>

#include <gtest/gtest.h>

#include <heckbert/transport/emission.h>
#include <heckbert/transport/stage.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kD = 0.5, kS = 0.3;

Scene ball_with_a_point() {
  Scene scene = inside_sphere({.name = "wall", .lobes = {Lambert{Rgb(0.5f)}, Mirror{Rgb(0.3f)}}});
  scene.point_lights.push_back({.position = {0, 0, 0}, .intensity = Rgb(std::numbers::pi_v<float>)});
  return scene;
}

RenderSettings settings_of(AlgorithmId algorithm) {
  return {.algorithm = algorithm, .width = 16, .height = 16, .samples_per_pixel = 256, .max_depth = 4, .seed = 2};
}

TEST(VirtualLights, GiveTheWordsOfTheirGrammarTheirValuesAndNoOthers) {
  const record::Record record = render(ball_with_a_point(), settings_of(AlgorithmId::InstantRadiosity));
  const taxonomy::Language& grammar = taxonomy::builtin_grammars().find("instant-radiosity")->language;
  for (const taxonomy::Word& word : record.words) EXPECT_TRUE(grammar.contains(word)) << taxonomy::fine(word);
  std::map<std::string, double> truth;
  for (const std::string& plain : words_over_ds(3)) {
    taxonomy::Word word = taxonomy::parse_word(plain);
    word.light = taxonomy::Symbol::Lp;
    if (grammar.contains(word)) truth[plain] = product_of_albedos(plain, kD, kS);
  }
  EXPECT_EQ(truth.size(), 7u);  // LDE LDDE LDSE LDDDE LSDDE LDDSE LDSSE
  expect_energies(record, truth);
}

TEST(VirtualLights, ThatAreClampedLoseWhatTheClosedFormSays) {
  const Scene scene = ball_with_a_point();
  const RenderSettings settings = settings_of(AlgorithmId::InstantRadiosityClamped);
  const double least = 0.1 * static_cast<double>(Stage(scene, settings).world().emission.radius());
  const double kept = 1 - least * least / 8;
  expect_energies(render(scene, settings), {{"LDE", kD}, {"LDDE", kD * kD * kept}, {"LDDSE", kD * kD * kS * kept}});
  const record::Estimate whole = energy_of(render(scene, settings_of(AlgorithmId::InstantRadiosity)), "LDDE");
  const record::Estimate clamped = energy_of(render(scene, settings), "LDDE");
  EXPECT_LT(clamped.mean, whole.mean);
}

}  // namespace
}  // namespace heckbert::transport
