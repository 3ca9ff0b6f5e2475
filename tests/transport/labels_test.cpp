// Labels against closed forms: which wall of a cube light came from and which it met is told by form factors. And they
// change nothing but the words: with the labels left out, a record is the record without labels.

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr float kAlbedo = 0.5f;

Shape named(const std::string& name, Geometry geometry, std::uint32_t material) {
  return {.name = name, .geometry = std::move(geometry), .material = material};
}

/// A cube whose walls all emit 1 and reflect half, each an object of its own. The eye sees the whole of the back wall
/// and nothing else, each part of it alike.
Scene cube_of_six_walls() {
  Scene scene;
  scene.materials = {{.name = "glow", .lobes = {Lambert{Rgb(kAlbedo)}}, .emission = Rgb(1)}};
  const glm::vec3 low(-1), x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
  scene.shapes = {named("left", make_quad(low, y, z), 0),      named("right", make_quad(low + x, z, y), 0),
                  named("floor", make_quad(low, z, x), 0),     named("ceiling", make_quad(low + y, x, z), 0),
                  named("back wall", make_quad(low, x, y), 0), named("front wall", make_quad(low + z, y, x), 0)};
  scene.camera = {.position = {0, 0, 0}, .look_at = {0, 0, -1}, .projection = Projection::Orthographic, .height = 2};
  return scene;
}

RenderSettings settings_with(LabelRule labels) {
  return {.width = 16, .height = 16, .samples_per_pixel = 512, .max_depth = 3, .labels = labels};
}

const record::Record& record_of_cube() {
  static const record::Record record = render(cube_of_six_walls(), settings_with({EventLabels::Object, true}));
  return record;
}

TEST(Labels, TellWhichWallByItsFormFactor) {
  // Opposite and adjacent faces of a cube: docs/anchors.md, A8.
  const double opposite = 0.199824896, adjacent = 0.200043776;
  std::map<std::string, double> truth{{"L'back wall'E", 1.0},
                                      {"L'front wall'D'back wall'E", kAlbedo * opposite},
                                      {"L'left'D'back wall'E", kAlbedo * adjacent},
                                      {"L'right'D'back wall'E", kAlbedo * adjacent},
                                      {"L'floor'D'back wall'E", kAlbedo * adjacent},
                                      {"L'ceiling'D'back wall'E", kAlbedo * adjacent}};
  expect_energies(record_of_cube(), truth);
}

TEST(Labels, AreAskedForInExpressions) {
  const record::Record& record = record_of_cube();
  const auto energy = [&](const std::string& expression) {
    return record::energy(record, record::members(record, taxonomy::compile(expression)));
  };
  const double bound = record::student_quantile(1 - 0.005 / 3, record::kBatches - 1);
  // Light of all walls falls on all of them alike: two bounces are a product.
  const struct {
    const char* expression;
    double truth;
  } rows[] = {{"L D'left' D'back wall' E", kAlbedo * kAlbedo * 0.200043776},
              {"L'ceiling' .* E & L D E", kAlbedo * 0.200043776},
              {"L .* 'front wall' .* E & L D D E", kAlbedo * kAlbedo * 0.199824896}};
  for (const auto& [expression, truth] : rows) {
    const record::Estimate e = energy(expression);
    EXPECT_NEAR(e.mean, truth, bound * e.standard_error) << expression;
    EXPECT_LT(e.standard_error, 0.02 * truth) << expression;
  }
  EXPECT_EQ(energy("L D'nobody' E").mean, 0);
}

TEST(Labels, LeaveEverythingElseAsItIs) {
  const record::Record plain = render(cube_of_six_walls(), settings_with({}));
  const record::Record& labelled = record_of_cube();
  EXPECT_EQ(labelled.tally, plain.tally);
  EXPECT_EQ(labelled.info.labels, "object,light-group");
  EXPECT_EQ(plain.info.labels, "");

  // Word by word: the sum over the labels is the word without labels.
  ASSERT_EQ(plain.words.size(), 4u);  // LE, LDE, LDDE, LDDDE
  for (std::size_t word = 0; word < plain.words.size(); ++word) {
    const taxonomy::Language language = taxonomy::compile(taxonomy::fine(plain.words[word]));
    const std::vector<bool> chosen = record::members(labelled, language);
    const record::Image sum = record::image_of(labelled, chosen);
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
      std::uint32_t count = 0, expected = 0;
      Rgb energy;
      const int x = static_cast<int>(i % 16), y = static_cast<int>(i / 16);
      for (const record::Entry& entry : labelled.pixel(x, y)) count += chosen[entry.word] ? entry.count : 0;
      for (const record::Entry& entry : plain.pixel(x, y)) {
        if (entry.word != word) continue;
        expected = entry.count;
        energy = entry.energy;
      }
      ASSERT_EQ(count, expected);
      // Each of the labelled entries is rounded once more: at most 216 of them here.
      ASSERT_NEAR(sum.pixels[i].g, energy.g, 2 * std::numeric_limits<float>::epsilon() * energy.g);
    }
  }
}

std::set<std::string> words_of(const Scene& scene, LabelRule labels, int depth = 2) {
  const record::Record record =
      render(scene, {.width = 8, .height = 8, .samples_per_pixel = 64, .max_depth = depth, .labels = labels});
  std::set<std::string> words;
  for (const taxonomy::Word& word : record.words) words.insert(taxonomy::plain(word));
  return words;
}

/// A lit floor under every kind of light.
Scene floor_under_lights() {
  Scene scene;
  scene.materials = {{.name = "stone", .lobes = {Lambert{Rgb(0.5f)}}},
                     {.name = "tube", .lobes = {}, .emission = Rgb(1), .emission_sides = Sides::Both}};
  scene.shapes = {named("floor", make_quad({-5, 0, -5}, {0, 0, 10}, {10, 0, 0}), 0),
                  named("lamp", make_quad({-1, 3, -1}, {2, 0, 0}, {0, 0, 2}), 1)};
  scene.camera = {.position = {0, 1, 4}, .look_at = {0, 0, 0}};
  return scene;
}

TEST(Labels, CallALampByItsGroupThenItsObjectThenItsMaterial) {
  Scene scene = floor_under_lights();
  const LabelRule rule{EventLabels::None, true};
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"L'lamp'DE"}));
  scene.shapes[1].name = "";
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"L'tube'DE"}));
  scene.materials[1].light_group = "key";
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"L'key'DE"}));
}

TEST(Labels, CallEveryOtherLightByItsGroup) {
  Scene scene = floor_under_lights();
  scene.shapes.pop_back();
  scene.point_lights = {{.position = {0, 2, 0}, .light_group = "bulb"}, {.position = {1, 2, 0}}};
  scene.spot_lights = {{.position = {0, 2, 0}, .direction = {0, -1, 0}, .cutoff_degrees = 80, .light_group = "spot"}};
  scene.distant_lights = {{.direction = {0, -1, 0}, .light_group = "sun"}};
  scene.environment = Rgb(0.5f);
  EXPECT_EQ(
      words_of(scene, {EventLabels::None, true}),
      (std::set<std::string>{"L'bulb'DE", "LDE", "L'spot'DE", "L'sun'DE", "L'environment'DE", "L'environment'E"}));
}

TEST(Labels, CallAnObjectByItsLabelThenItsNameThenItsGroup) {
  Scene scene = floor_under_lights();
  const LabelRule rule{EventLabels::Object, false};
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"LD'floor'E"}));
  scene.shapes[0].label = "ground";
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"LD'ground'E"}));
  scene.shapes[0].label = scene.shapes[0].name = "";
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"LDE"}));

  // The floor as the second of two groups, so that shapes of groups are numbered on.
  scene.groups = {{.name = "nothing", .shapes = {named("speck", Sphere{{0, -9, 0}, 0.1f}, 0)}},
                  {.name = "plot", .shapes = {scene.shapes[0]}}};
  scene.shapes.erase(scene.shapes.begin());
  scene.instances = {{.group = 0}, {.group = 1}};
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"LD'plot'E"}));
}

TEST(Labels, CallAMaterialByItsLabelThenItsName) {
  Scene scene = floor_under_lights();
  const LabelRule rule{EventLabels::Material, false};
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"LD'stone'E"}));
  scene.materials[0].label = "don't\nsay";  // a quote is written with a backslash, a line end as a blank
  EXPECT_EQ(words_of(scene, rule), (std::set<std::string>{"LD'don\\'t say'E"}));
}

TEST(Labels, CallAParticleByItsMedium) {
  Scene scene = floor_under_lights();
  scene.media = {{.name = "unused"}, {.name = "fog", .scattering = Rgb(0.1f)}};
  scene.medium = 1;
  const std::set<std::string> words = words_of(scene, {EventLabels::Object, false}, 1);
  EXPECT_TRUE(words.contains("LV'fog'E"));
  EXPECT_TRUE(words.contains("LD'floor'E"));
  EXPECT_EQ(words_of(scene, {EventLabels::None, true}, 1), (std::set<std::string>{"L'lamp'VE", "L'lamp'DE"}));
}

TEST(Labels, AreFoundByTheRecursiveTracersToo) {
  Scene scene = floor_under_lights();
  scene.materials[0].lobes = {Mirror{Rgb(1)}};
  scene.camera.look_at = {0, -3, 0};  // the lamp's image in the floor
  const record::Record record = render(scene, {.algorithm = AlgorithmId::Whitted,
                                               .width = 8,
                                               .height = 8,
                                               .samples_per_pixel = 4,
                                               .labels = {EventLabels::Object, true}});
  ASSERT_EQ(record.words.size(), 1u);
  EXPECT_EQ(taxonomy::plain(record.words[0]), "L'lamp'S'floor'E");
}

TEST(Labels, AreTheSameForAnyNumberOfThreads) {
  RenderSettings one = settings_with({EventLabels::Object, true});
  one.width = one.height = 64;
  one.samples_per_pixel = 4;
  one.threads = 1;
  RenderSettings three = one;
  three.threads = 3;
  EXPECT_EQ(render(cube_of_six_walls(), one), render(cube_of_six_walls(), three));
}

}  // namespace
}  // namespace heckbert::transport
