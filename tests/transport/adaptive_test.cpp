// Adaptive sampling: a map may spend samples as unevenly as it likes without moving any word's energy, and one planned
// for a class lowers that class's error.

#include <array>

#include <gtest/gtest.h>

#include <heckbert/record/sample_map.h>
#include <heckbert/taxonomy/expression.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

TEST(SampleMap, LeavesEveryWordUnbiased) {
  // Brightness and repeats go together: a mean over samples instead of pixels would be wrong by far.
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  add(scene, make_quad({-50, -1, -60}, {100, 0, 0}, {0, 60, 0}), emitter(1));
  scene.camera = {.position = {0, 2, 0}, .look_at = {0, 1.2f, -3}, .vertical_fov_degrees = 70};
  RenderSettings settings{.width = 32, .height = 32, .samples_per_pixel = 64, .max_depth = 2};
  const record::Record even = render(scene, settings);
  settings.seed = 2;
  record::SampleMap map{.window = {0, 0, 32, 32}};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) map.repeats.push_back(static_cast<std::uint16_t>(y < 16 ? 9 : 1 + x % 3));
  settings.sample_map = map;
  const record::Record uneven = render(scene, settings);
  EXPECT_EQ(static_cast<double>(uneven.tally.samples), 32 * 32 * 64 * map.mean());
  for (const char* word : {"LE", "LDE"}) {
    const record::Estimate a = energy_of(even, word), b = energy_of(uneven, word);
    // Two-sample z-test, 1 % over two words after Sidak.
    EXPECT_NEAR(a.mean, b.mean, 2.81 * std::hypot(a.standard_error, b.standard_error) + 1e-6) << word;
    EXPECT_LT(b.standard_error, 0.01 * b.mean) << word;
  }
  // The picture and the batches say the same.
  double sum = 0;
  const record::Image beauty = record::beauty(uneven);
  for (const Rgb& pixel : beauty.pixels) sum += static_cast<double>(luminance(pixel));
  const double total = record::energy(uneven, std::vector<bool>(uneven.words.size(), true)).mean;
  EXPECT_NEAR(sum / 1024, total, 1e-5 * total);
}

TEST(SampleMap, GivesTheSameBytesForAnyNumberOfThreads) {
  RenderSettings settings{.width = 40, .height = 40, .samples_per_pixel = 4, .threads = 1};
  const auto pilot = [&](std::uint64_t seed) {
    RenderSettings s = settings;
    s.seed = seed;
    return render(furnace(0.4f, 0.3f), s);
  };
  settings.sample_map = record::plan_samples(pilot(11), pilot(12), {}, 3);
  EXPECT_NEAR(settings.sample_map->mean(), 3, 0.3);
  const record::Record one = render(furnace(0.4f, 0.3f), settings);
  for (const int threads : {2, 4}) {
    settings.threads = threads;
    EXPECT_TRUE(render(furnace(0.4f, 0.3f), settings) == one) << threads;
  }
}

/// Mean squared error per pixel of a class, from pairs of independent renders.
double error_of(const Scene& scene, RenderSettings settings, const taxonomy::Language& language) {
  double sum = 0;
  for (std::uint64_t pair = 0; pair < 3; ++pair) {
    std::array<record::Image, 2> images;
    for (std::uint64_t i = 0; i < 2; ++i) {
      settings.seed = 100 + 2 * pair + i;
      const record::Record record = render(scene, settings);
      images[i] = record::image_of(record, record::members(record, language));
    }
    for (std::size_t p = 0; p < images[0].pixels.size(); ++p) {
      const double d = static_cast<double>(luminance(images[0].pixels[p]) - luminance(images[1].pixels[p]));
      sum += 0.5 * d * d;
    }
  }
  return sum;
}

TEST(SampleMap, PlannedForAClassLowersItsError) {
  // The caustic of a glass ball covers a small part of the floor.
  Scene scene;
  add(scene, make_quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10}), diffuse(0.6f));
  add(scene, make_quad({-0.6f, 4, -0.6f}, {1.2f, 0, 0}, {0, 0, 1.2f}), emitter(20));
  add(scene, Sphere{{0, 1, 0}, 0.6f}, {.name = "glass", .lobes = {Dielectric{}}});
  scene.camera = {.position = {0, 5, 6}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 50};
  const std::vector<taxonomy::Language> caustics{taxonomy::compile("L S+ D E")};
  RenderSettings settings{.width = 48, .height = 48, .samples_per_pixel = 32, .max_depth = 4};
  RenderSettings pilot = settings;
  pilot.samples_per_pixel = 16;
  pilot.seed = 50;
  const record::Record first = render(scene, pilot);
  pilot.seed = 51;
  settings.sample_map = record::plan_samples(first, render(scene, pilot), caustics, 4);
  const double adaptive = error_of(scene, settings, caustics[0]);
  RenderSettings even = settings;
  even.samples_per_pixel = static_cast<int>(std::lround(32 * settings.sample_map->mean()));
  even.sample_map.reset();
  EXPECT_LT(adaptive, 0.8 * error_of(scene, even, caustics[0]));
}

}  // namespace
}  // namespace heckbert::transport
