// Tracers that look no farther than one surface, against closed forms: ray casting, local shading, ambient occlusion.

#include <numbers>

#include <gtest/gtest.h>

#include <heckbert/transport/ambient_occlusion.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

/// A wide floor of albedo 1/2 seen from above at its origin, with a point light of intensity 1 two above it.
Scene lit_floor() {
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  scene.point_lights.push_back({.position = {0, 2, 0}, .intensity = Rgb(1)});
  scene.camera = {.position = {3, 0.5f, 0}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 1e-3f};
  return scene;
}

record::Record traced(const Scene& scene, AlgorithmId algorithm, int samples = 32) {
  return render(scene, {.algorithm = algorithm, .width = 4, .height = 4, .samples_per_pixel = samples});
}

TEST(LocalShading, KnowsNoShadows) {
  Scene scene = lit_floor();
  add(scene, make_quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), {.name = "lid", .lobes = {}});
  EXPECT_NEAR(energy_of(traced(scene, AlgorithmId::LocalShading), "LDE").mean, 0.5 / kPiD / 4, 1e-6);
  EXPECT_TRUE(traced(scene, AlgorithmId::RayCasting).words.empty());
}

TEST(LocalShading, AddsUpAllLightsThatNoRayCanHitAndNoLamp) {
  Scene scene = lit_floor();
  scene.point_lights.push_back({.position = {0, 1, 0}, .intensity = Rgb(2)});
  scene.distant_lights.push_back({.direction = {0, -1, 0}, .irradiance = Rgb(3)});
  scene.spot_lights.push_back({.position = {0, 4, 0}, .direction = {0, -1, 0}, .intensity = Rgb(16)});
  add(scene, make_quad({-1, 5, -1}, {2, 0, 0}, {0, 0, 2}), emitter(7));
  const record::Record record = traced(scene, AlgorithmId::LocalShading);
  ASSERT_EQ(record.words.size(), 2u);  // of point and spot lights, and of the distant one
  EXPECT_NEAR(energy_of(record, "LDE").mean, 0.5 / kPiD * (0.25 + 2 + 3 + 1), 1e-5);
}

TEST(LocalShading, KeepsTheAmbientTermApart) {
  Scene scene = lit_floor();
  scene.ambient = Rgb(0.3f);
  const record::Record record = traced(scene, AlgorithmId::LocalShading);
  EXPECT_NEAR(record.ambient.front().g, 0.15f, 1e-6f);
  EXPECT_NEAR(energy_of(record, "LDE").mean, 0.5 / kPiD / 4, 1e-6);
}

TEST(RayCasting, SeesLampsAndNothingInMirrors) {
  Scene scene = lit_floor();
  scene.materials[0].lobes = {Lambert{Rgb(0.5f)}, Mirror{Rgb(0.5f)}};
  scene.environment = Rgb(1);
  const record::Record record = traced(scene, AlgorithmId::RayCasting, 4096);
  expect_energies(record, {{"LDE", 0.5 / kPiD / 4 + 0.5}});
  EXPECT_EQ(energy_of(record, "LSE").mean, 0);
}

/// Mean of the ambient buffer.
double occlusion(const Scene& scene) {
  const record::Record record = traced(scene, AlgorithmId::AmbientOcclusion, 4096);
  EXPECT_TRUE(record.words.empty());
  if (record.ambient.empty()) return 0;
  double sum = 0;
  for (const Rgb& pixel : record.ambient) sum += static_cast<double>(pixel.g);
  return sum / static_cast<double>(record.ambient.size());
}

TEST(AmbientOcclusion, IsTheShareOfASkyThatSurfacesNearbyLeave) {
  Scene scene = lit_floor();
  EXPECT_EQ(occlusion(scene), 1);
  // A wall as high as it is far away, and so long that its ends do not matter: (1 + 1/sqrt 2) / 2 of the sky is left.
  add(scene, make_quad({-0.5f, 0, -50}, {0, 0, 100}, {0, 0.5f, 0}), {.name = "wall", .lobes = {}});
  // 65 536 samples have a standard error of 0.0014 at most; four of them, and 1e-4 for the ends.
  EXPECT_NEAR(occlusion(scene), (1 + 1 / std::numbers::sqrt2) / 2, 0.0056);
}

TEST(AmbientOcclusion, ForgetsWhatIsFartherThanItsReach) {
  // Inside a sphere everything is at most a diameter away, a third of the diagonal of the box around it.
  const auto room = [](float far_corner) {
    Scene scene = inside_sphere(diffuse(0.5f));
    add(scene, make_quad({far_corner, 0, 0}, {1e-3f, 0, 0}, {0, 1e-3f, 0}), diffuse(0.5f));
    return scene;
  };
  EXPECT_GT(occlusion(room(1)), 0.05);
  EXPECT_EQ(occlusion(room(2 / kOcclusionReach)), 0);
}

}  // namespace
}  // namespace heckbert::transport
