// The integrators against each other and against their own promises.

#include <atomic>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/record/sums.h>
#include <heckbert/taxonomy/counting.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/possible.h>
#include <heckbert/transport/eye.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

/// A small room with a lamp, a mirror wall, a glass ball and a glossy floor: every kind of word occurs.
Scene mixed_room() {
  Scene scene;
  scene.name = "mixed room";
  add(scene, make_box({-2, -1, -2}, {2, 2, 2}, true), diffuse(0.6f));
  add(scene, make_quad({-1.99f, -0.5f, -1}, {0, 0, 2}, {0, 1.5f, 0}), {.name = "mirror", .lobes = {Mirror{Rgb(0.9f)}}});
  add(scene, make_quad({-1, 1.99f, -1}, {2, 0, 0}, {0, 0, 2}), emitter(3));
  add(scene, make_quad({-1.8f, -0.6f, -1.98f}, {1.2f, 0, 0}, {0, 1.2f, 0}), emitter(1));
  add(scene, Sphere{{0.5f, 0.1f, 0.4f}, 0.6f}, {.name = "glass", .lobes = {Dielectric{}}});
  add(scene, make_box({-1.5f, -1, -1.5f}, {1.5f, -0.9f, 1.5f}),
      {.name = "glossy", .lobes = {Lambert{Rgb(0.3f)}, ggx(Rgb(0.4f), 0.5f)}});
  scene.camera = {.position = {1.6f, 0.2f, 1.8f}, .look_at = {-0.4f, 0.2f, -0.4f}, .vertical_fov_degrees = 80};
  return scene;
}

/// Coarse patches: what is asked here does not depend on how fine they are.
const Method kCoarse{.radiosity = {.longest_edge = 0.3f, .refinements = 0, .rays_per_side = 32}};

TEST(Render, GivesTheSameBytesForAnyNumberOfThreads) {
  Scene room = mixed_room();
  room.point_lights.push_back({.position = {0.5f, 1.5f, 1}, .intensity = Rgb(1)});  // for those who know no lamps
  for (const AlgorithmFacts& algorithm : kAlgorithms) {
    RenderSettings settings{
        .algorithm = algorithm.id, .width = 100, .height = 70, .samples_per_pixel = 8, .threads = 1, .method = kCoarse};
    const auto one = render(room, settings);
    // Local shading knows the point light alone, ambient occlusion no light at all, and ray casting LE, LDE and LGE.
    const bool is_poor = algorithm.id == AlgorithmId::LocalShading || algorithm.id == AlgorithmId::RayCasting ||
                         algorithm.id == AlgorithmId::AmbientOcclusion;
    ASSERT_TRUE(is_poor ? !one.words.empty() || !one.ambient.empty() : one.words.size() > 5) << algorithm.name;
    for (const int threads : {2, 4}) {
      settings.threads = threads;
      EXPECT_TRUE(render(room, settings) == one) << algorithm.name << " with " << threads;
    }
    settings.seed = 2;
    EXPECT_FALSE(render(room, settings) == one) << algorithm.name << ": another seed must be another picture";
  }
}

/// A tile with more splats than wait at a time is handed over in pieces, each with the splats of its own samples. Half
/// the samples at a time fit.
TEST(Render, HandsOverSplatsWithTheSamplesThatMadeThem) {
  RenderSettings settings{
      .algorithm = AlgorithmId::Light, .width = 20, .height = 16, .samples_per_pixel = 2048, .threads = 1};
  const Scene room = mixed_room();
  const record::Window window = picture_window(settings);
  int pieces = 0;
  const auto sums_of = [&] {
    std::vector<record::Tile> tiles;
    RenderHooks hooks;
    hooks.settled = [&] {
      ++pieces;
      const record::Tile sum = record::added(window, tiles);
      const auto samples = std::accumulate(sum.samples.begin(), sum.samples.end(), std::uint64_t{0});
      EXPECT_EQ(sum.tally.samples, samples);
      std::uint64_t found = 0;
      for (const record::EntrySum& entry : sum.entries) found += entry.count;
      EXPECT_EQ(found, sum.tally.contributions());
    };
    EXPECT_TRUE(render_tiles(room, settings, hooks, [&](record::Tile tile) { tiles.push_back(std::move(tile)); }));
    return record::Sums{info_of(room, settings), record::added(window, std::move(tiles))};
  };
  const record::Sums whole = sums_of();
  EXPECT_GT(pieces, 1);
  std::vector<record::Sums> halves;
  for (const int number : {1, 2}) {
    settings.part = {number, 2};
    pieces = 0;
    halves.push_back(sums_of());
    EXPECT_EQ(pieces, 1);
  }
  EXPECT_TRUE(record::merged(halves[0], halves[1]) == whole);
}

TEST(Render, ACropIsThatPartOfThePicture) {
  RenderSettings settings{.width = 80, .height = 60, .samples_per_pixel = 4};
  const auto whole = record::beauty(render(mixed_room(), settings));
  settings.crop = record::Window{30, 10, 70, 50};
  const auto part = record::beauty(render(mixed_room(), settings));
  for (int y = 10; y < 50; ++y)
    for (int x = 30; x < 70; ++x) ASSERT_EQ(part.at(x, y), whole.at(x, y));
}

TEST(Render, ThePictureOnlyModeTracesTheSamePaths) {
  const RenderSettings settings{.width = 40, .height = 30, .samples_per_pixel = 16};
  const auto picture = render_picture_only(mixed_room(), settings);
  const auto beauty = record::beauty(render(mixed_room(), settings));
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    EXPECT_NEAR(picture.pixels[i].g, beauty.pixels[i].g, 1e-5f * (1 + beauty.pixels[i].g));
}

TEST(Render, TheTracersFromTheEyeFindWhatTheirGrammarsSayAndTheReferenceAgrees) {
  const RenderSettings reference_settings{.width = 24, .height = 18, .samples_per_pixel = 4096, .max_depth = 8};
  const auto reference = render(mixed_room(), reference_settings);
  const struct {
    AlgorithmId algorithm;
    const char* grammar;
    std::vector<std::string> words;
  } rows[] = {{AlgorithmId::Whitted, "L N? S* E", {"LE", "LDE", "LGE", "LSE", "LDSE", "LGSE", "LSSE", "LDSSE"}},
              {AlgorithmId::Lecture, "L D? S* E", {"LE", "LDE", "LSE", "LDSE", "LSSE", "LDSSE"}},
              {AlgorithmId::Distribution,
               "L D? [GS]* E",
               {"LE", "LDE", "LGE", "LSE", "LDSE", "LGSE", "LSSE", "LDSSE", "LDGE", "LSGE"}},
              {AlgorithmId::RayCasting, "L N? E", {"LE", "LDE", "LGE"}}};
  for (const auto& row : rows) {
    RenderSettings settings = reference_settings;
    settings.algorithm = row.algorithm;
    settings.samples_per_pixel = 1024;
    settings.seed = 5;
    const auto record = render(mixed_room(), settings);
    const taxonomy::Language grammar = taxonomy::compile(row.grammar);
    for (const taxonomy::Word& word : record.words) EXPECT_TRUE(grammar.contains(word)) << taxonomy::fine(word);
    for (const std::string& word : row.words) {
      const auto a = energy_of(record, word), b = energy_of(reference, word);
      // Two-sample z-test, 1 % over twenty-seven words after Sidak.
      EXPECT_NEAR(a.mean, b.mean, 3.56 * std::hypot(a.standard_error, b.standard_error)) << row.grammar << " " << word;
      EXPECT_GT(b.mean, 0.0) << word;
      EXPECT_LT(b.standard_error, 0.06 * b.mean) << word;
    }
  }
}

TEST(Render, NoWordHasMoreScatteringsThanTheMaximumDepth) {
  for (const AlgorithmFacts& algorithm : kAlgorithms)
    for (const int max_depth : {0, 1, 3}) {
      const auto record = render(mixed_room(), {.algorithm = algorithm.id,
                                                .width = 24,
                                                .height = 18,
                                                .samples_per_pixel = 64,
                                                .max_depth = max_depth,
                                                .method = kCoarse});
      std::size_t longest = 0;
      for (const taxonomy::Word& word : record.words) longest = std::max(longest, word.events.size());
      // As long as the grammar allows with the lights, walls and mirrors of this room.
      const taxonomy::Language& grammar = taxonomy::builtin_grammars().find(algorithm.grammar)->language;
      const auto possible =
          taxonomy::possible_words({.lights = taxonomy::single(taxonomy::Symbol::La),
                                    .events = static_cast<taxonomy::SymbolSet>(taxonomy::single(taxonomy::Symbol::Dr) |
                                                                               taxonomy::single(taxonomy::Symbol::Gr) |
                                                                               taxonomy::single(taxonomy::Symbol::Sr)),
                                    .eyes = taxonomy::single(taxonomy::Symbol::Ep)});
      std::size_t expected = 0;
      const auto counts = taxonomy::count_words(grammar & possible, static_cast<std::size_t>(max_depth));
      if (algorithm.accuracy != Accuracy::NotLight && algorithm.id != AlgorithmId::LocalShading)  // knows no lamps
        for (std::size_t n = 0; n < counts.size(); ++n)
          if (!counts[n].is_zero()) expected = n;
      EXPECT_EQ(longest, expected) << algorithm.name << " to " << max_depth;
    }
}

TEST(Render, KeepsTheColoursOfLampAndWall) {
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}),
      {.name = "floor", .lobes = {Lambert{Rgb(0.1f, 0.2f, 0.4f)}, Phong{Rgb(0.4f, 0.2f, 0.1f), 2}}});
  Material lamp = emitter(1);
  lamp.emission = Rgb(5, 3, 1);
  add(scene, make_quad({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), lamp);
  scene.camera = {.position = {2, 0.5f, 2}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 1};
  const auto record = render(scene, {.width = 4, .height = 4, .samples_per_pixel = 64, .max_depth = 1});
  const std::map<std::string, Rgb> colours{{"LDE", {0.5f, 0.6f, 0.4f}}, {"LGE", {2, 0.6f, 0.1f}}};
  ASSERT_EQ(record.words.size(), colours.size());
  for (std::size_t w = 0; w < record.words.size(); ++w) {
    std::vector<bool> chosen(record.words.size());
    chosen[w] = true;
    const Rgb seen = record::mean_colour(record, chosen), expected = colours.at(taxonomy::plain(record.words[w]));
    EXPECT_NEAR(seen.r / seen.g, expected.r / expected.g, 1e-4f);
    EXPECT_NEAR(seen.b / seen.g, expected.b / expected.g, 1e-4f);
  }
}

TEST(Lecture, PutsTheMirrorRayAtDiffuseSurfacesIntoThePhantomBufferOnly) {
  Scene scene = mixed_room();
  const RenderSettings settings{.algorithm = AlgorithmId::Lecture, .width = 24, .height = 18, .samples_per_pixel = 16};
  const auto without = render(scene, settings);
  EXPECT_TRUE(without.phantom.empty()) << "k_r is zero everywhere";
  for (Material& material : scene.materials)
    if (material.name == "diffuse") material.phantom_reflectance = Rgb(0.3f);
  const auto with = render(scene, settings);
  ASSERT_EQ(with.phantom.size(), with.info.window.pixel_count());
  double phantom = 0;
  for (const Rgb p : with.phantom) phantom += p.g;
  EXPECT_GT(phantom, 0);
  const taxonomy::Language grammar = taxonomy::compile("L D? S* E");
  for (const taxonomy::Word& word : with.words) EXPECT_TRUE(grammar.contains(word)) << taxonomy::fine(word);
  RenderSettings whitted = settings;
  whitted.algorithm = AlgorithmId::Whitted;
  EXPECT_TRUE(render(scene, whitted).phantom.empty());
}

TEST(Lecture, WhereAMirrorContinuesTheRayNoPhantomDoublesIt) {
  Scene scene = furnace(0, 1);  // at every wall two rays of full strength would be a tree without bound
  scene.materials[0].phantom_reflectance = Rgb(1);
  const auto record = render(
      scene, {.algorithm = AlgorithmId::Lecture, .width = 4, .height = 4, .samples_per_pixel = 4, .max_depth = 12});
  EXPECT_TRUE(record.phantom.empty());
  expect_energies(record, {{"LE", 1}, {"LSE", 1}, {"LSSSE", 1}});
}

TEST(Lecture, APhantomMirrorOverAWhiteSkyShowsTheSkyTimesItsReflectance) {
  Scene scene;
  Material floor = diffuse(0.5f);
  floor.phantom_reflectance = Rgb(0.25f);
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), floor);
  scene.environment = Rgb(1);
  scene.camera = {.position = {0, 2, 0.1f}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 20};
  const auto record =
      render(scene, {.algorithm = AlgorithmId::Lecture, .width = 8, .height = 8, .samples_per_pixel = 4});
  for (const Rgb p : record.phantom) EXPECT_NEAR(p.g, 0.25f, 1e-6f);
}

TEST(Lecture, APhantomMirrorShowsTheAmbientAndTheDirectLightOfWhatItReflects) {
  // A wall that mirrors the floor before it; light falls straight down.
  Scene scene;
  Material phantom = diffuse(0.5f);
  phantom.phantom_reflectance = Rgb(0.25f);
  add(scene, make_quad({0, 0, -50}, {0, 0, 100}, {100, 0, 0}), phantom);
  add(scene, make_quad({0, 0, -50}, {0, 100, 0}, {0, 0, 100}), phantom);
  scene.point_lights.push_back({.position = {4, 1e4f, 0}, .intensity = Rgb(std::numbers::pi_v<float> * 1e8f)});
  scene.ambient = Rgb(0.1f);
  scene.camera = {.position = {2, 3, 0}, .look_at = {0, 2, 0}, .vertical_fov_degrees = 0.1f};
  RenderSettings settings{.algorithm = AlgorithmId::Lecture, .width = 4, .height = 4, .samples_per_pixel = 4};
  settings.max_depth = 1;  // spent before the floor is shaded
  for (const Rgb p : render(scene, settings).phantom) EXPECT_NEAR(p.g, 0.25f * 0.05f, 1e-6f);
  settings.max_depth = 2;
  for (const Rgb p : render(scene, settings).phantom) EXPECT_NEAR(p.g, 0.25f * (0.05f + 0.5f), 1e-5f);
}

TEST(Ambient, IsItsCoefficientTimesTheAmbientLightAndNoPath) {
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  scene.ambient = Rgb(0.2f, 0.4f, 0.8f);
  scene.camera = {.position = {0, 2, 0.1f}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 20};
  RenderSettings settings{.algorithm = AlgorithmId::Whitted, .width = 8, .height = 8, .samples_per_pixel = 4};
  const auto record = render(scene, settings);
  EXPECT_TRUE(record.words.empty());
  ASSERT_EQ(record.ambient.size(), 64u);
  for (const Rgb a : record.ambient) {
    EXPECT_NEAR(a.r, 0.1f, 1e-6f);
    EXPECT_NEAR(a.b, 0.4f, 1e-6f);
  }
  scene.materials[0].ambient_reflectance = Rgb(0);
  EXPECT_TRUE(render(scene, settings).ambient.empty() || is_black(render(scene, settings).ambient[0]));
  settings.algorithm = AlgorithmId::Path;
  EXPECT_TRUE(render(scene, settings).ambient.empty());
}

TEST(Eye, FillsEachPixelOfAWideAndOfATallPicture) {
  const float half_height = std::tan(glm::radians(30.0f));
  for (const glm::ivec2 size : {glm::ivec2(8, 2), glm::ivec2(2, 8), glm::ivec2(3, 3)}) {
    const Eye eye({.position = {0, 0, 0}, .look_at = {0, 0, -1}, .vertical_fov_degrees = 60}, size.x, size.y);
    const float pixel = 2 * half_height / static_cast<float>(size.y);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::vec2 low(1), high(0);  // of the place within the pixel
        for (int n = 0; n < 1000; ++n) {
          Sampler sampler(1, x, y, n);
          const glm::vec3 d = eye.ray(x, y, sampler).direction;
          const glm::vec2 film = glm::vec2(d.x, -d.y) / (-d.z * pixel) + 0.5f * glm::vec2(size) - glm::vec2(x, y);
          low = glm::min(low, film);
          high = glm::max(high, film);
        }
        for (int axis = 0; axis < 2; ++axis) {
          EXPECT_NEAR(low[axis], 0.0f, 0.01f);
          EXPECT_NEAR(high[axis], 1.0f, 0.01f);
          EXPECT_GT(low[axis], -1e-5f);
          EXPECT_LT(high[axis], 1 + 1e-5f);
        }
      }
  }
}

TEST(Eye, AThinLensEndsWordsInElAndFocusesOnItsPlane) {
  Scene scene;
  add(scene, make_quad({-1, -1, 0}, {1, 0, 0}, {0, 2, 0}), emitter(1));  // the left half, facing +z
  scene.camera = {.position = {0, 0, 4},
                  .look_at = {0, 0, 0},
                  .vertical_fov_degrees = 20,
                  .lens_radius = 0.5f,
                  .focus_distance = 4};
  const RenderSettings settings{.width = 16, .height = 16, .samples_per_pixel = 32};
  const auto sharp = render(scene, settings);
  ASSERT_EQ(sharp.words.size(), 1u);
  EXPECT_EQ(taxonomy::fine(sharp.words[0]), "LaEl");
  const auto image = record::beauty(sharp);
  EXPECT_EQ(image.at(7, 8).g, 1.0f);
  EXPECT_EQ(image.at(8, 8).g, 0.0f);
  scene.camera.focus_distance = 2;
  const auto blurred = record::beauty(render(scene, settings));
  EXPECT_GT(blurred.at(8, 8).g, 0.1f);
  EXPECT_LT(blurred.at(7, 8).g, 0.9f);
}

TEST(Eye, AThinLensFocusesOnAPlaneUpToTheRimOfAWidePicture) {
  Scene scene;
  const float pixel = 2 * std::tan(glm::radians(50.0f)) * 4 / 16;
  add(scene, make_quad({-20, -20, 0}, {20 + 6.5f * pixel, 0, 0}, {0, 40, 0}), emitter(1));  // ends inside pixel 14
  scene.camera = {
      .position = {0, 0, 4}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 100, .lens_radius = 2, .focus_distance = 4};
  const auto image = record::beauty(render(scene, {.width = 16, .height = 16, .samples_per_pixel = 64}));
  for (int y = 0; y < 16; ++y) {
    EXPECT_EQ(image.at(13, y).g, 1.0f);
    EXPECT_EQ(image.at(15, y).g, 0.0f);
  }
}

TEST(Render, StopsWhenAskedAndSaysSo) {
  std::atomic<bool> stop{false};
  RenderHooks hooks;
  hooks.stop = &stop;
  int calls = 0;
  hooks.progress = [&](const Progress& p) {
    ++calls;
    EXPECT_GT(p.fraction, 0);
    EXPECT_LE(p.fraction, 1);
    stop = true;
  };
  const auto record = render(mixed_room(), {.width = 256, .height = 256, .samples_per_pixel = 256}, hooks);
  EXPECT_TRUE(record.info.partial);
  EXPECT_GE(calls, 1);
  EXPECT_LT(record.tally.samples, 256u * 256u * 256u);
  EXPECT_GT(record.entries.size(), 0u);
}

TEST(Render, RefusesSettingsOutOfRange) {
  const Scene scene = mixed_room();
  EXPECT_THROW(render(scene, {.width = 0}), std::invalid_argument);
  EXPECT_THROW(render(scene, {.samples_per_pixel = 0}), std::invalid_argument);
  EXPECT_THROW(render(scene, {.max_depth = -1}), std::invalid_argument);
  EXPECT_THROW(render(scene, {.width = 64, .height = 64, .crop = record::Window{0, 0, 65, 10}}), std::invalid_argument);
  Scene too_smooth = scene;
  too_smooth.materials.push_back({.name = "glossy", .lobes = {ggx(Rgb(0.5f), 0)}});
  EXPECT_THROW(render(too_smooth, {}), std::invalid_argument);
}

TEST(Render, ASceneWithoutLightIsBlackAndHasNoWords) {
  Scene scene;
  add(scene, Sphere{{0, 0, 0}, 1}, diffuse(0.5f));
  const auto record = render(scene, {.width = 8, .height = 8, .samples_per_pixel = 4});
  EXPECT_TRUE(record.words.empty());
  EXPECT_EQ(record.tally.samples, 256u);
}

}  // namespace
}  // namespace heckbert::transport
