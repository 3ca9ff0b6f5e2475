// Eyes and pixel filters: where each ray goes, what weight each point of the picture has, and the classes that every
// kind of eye must see alike.

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include <heckbert/transport/eye.h>
#include <heckbert/transport/filter.h>

#include "chi_square.h"
#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

TEST(OrthographicEye, SendsParallelRaysFromTheRightPlaces) {
  const Camera camera{
      .position = {1, 2, 3}, .look_at = {1, 2, -7}, .projection = Projection::Orthographic, .height = 4};
  const Eye eye(camera, 8, 4);
  EXPECT_EQ(eye.kind(), taxonomy::Symbol::Ep);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      for (int n = 0; n < 50; ++n) {
        Sampler sampler(1, x, y, n);
        const Ray ray = eye.ray(x, y, sampler);
        EXPECT_EQ(ray.direction, glm::vec3(0, 0, -1));
        EXPECT_EQ(ray.origin.z, 3);
        EXPECT_NEAR(ray.origin.x, x - 2.5, 0.50001);
        EXPECT_NEAR(ray.origin.y, 3.5 - y, 0.50001);
      }
}

TEST(PanoramicEye, LooksAllAroundWithItsAxisInTheMiddle) {
  const Camera camera{.position = {0, 1, 0}, .look_at = {0, 1, 9}, .projection = Projection::Panoramic};
  const Eye eye(camera, 360, 180, {FilterKind::Box, 1e-3f});
  EXPECT_EQ(eye.kind(), taxonomy::Symbol::Ep);
  const auto middle_of = [&](int x, int y) {
    Sampler sampler(1, x, y, 0);
    const Ray ray = eye.ray(x, y, sampler);
    EXPECT_NEAR(glm::length(ray.direction), 1, 1e-6);
    return ray.direction;
  };
  for (const int x : {0, 90, 179, 180, 270, 359})
    for (const int y : {0, 45, 90, 179}) {
      const double longitude = glm::radians(x + 0.5 - 180), latitude = glm::radians(90 - y - 0.5);
      // Looking along +z with +y up, the right hand points along -x.
      const glm::dvec3 expected(-std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                std::cos(latitude) * std::cos(longitude));
      EXPECT_LT(glm::length(glm::dvec3(middle_of(x, y)) - expected), 1e-4) << x << " " << y;
    }
}

TEST(PanoramicEye, TakesAnEnvironmentImageBackAsItWas) {
  Scene scene;
  add(scene, Sphere{{100, 0, 0}, 0.1f}, diffuse(0));
  EnvironmentImage image{.width = 16, .height = 8, .interpolation = Interpolation::Nearest};
  for (int i = 0; i < 128; ++i) image.pixels.emplace_back(static_cast<float>(i + 1), 1.0f, static_cast<float>(i % 3));
  scene.environment_image = image;
  scene.camera = {.position = {0, 0, 0}, .look_at = {0, 0, 1}, .projection = Projection::Panoramic};
  const auto picture = record::beauty(render(scene, {.width = 16, .height = 8, .samples_per_pixel = 16}));
  for (std::size_t i = 0; i < 128; ++i) EXPECT_NEAR(picture.pixels[i].r, image.pixels[i].r, 1e-3f) << i;
}

/// An eye of every kind, in a sphere around the origin.
std::vector<std::pair<const char*, Camera>> eyes() {
  Camera pinhole{.position = {0.1f, 0.2f, 0.3f}, .look_at = {0.9f, 0.1f, -0.4f}, .vertical_fov_degrees = 60};
  Camera lens = pinhole, parallel = pinhole, panorama = pinhole;
  lens.lens_radius = 0.2f;
  lens.focus_distance = 0.8f;
  parallel.projection = Projection::Orthographic;
  parallel.height = 0.5f;
  panorama.projection = Projection::Panoramic;
  return {{"LaDrEp", pinhole}, {"LaDrEl", lens}, {"LaDrEp", parallel}, {"LaDrEp", panorama}};
}

TEST(EveryEye, SeesTheClassesOfASphereFromInside) {
  // A1 (iii): the same at every point of the sphere, so in every picture of it.
  Material wall = diffuse(0.5f);
  wall.emission = Rgb(0.5f);
  wall.emission_sides = Sides::Both;
  for (const auto& [word, camera] : eyes())
    for (const FilterFacts& filter : kFilters) {
      Scene scene = inside_sphere(wall);
      scene.camera = camera;
      const auto record =
          render(scene, {.width = 8, .height = 8, .samples_per_pixel = 256, .filter = {filter.kind, filter.radius}});
      expect_energies(record, {{"LE", 0.5}, {"LDE", 0.25}, {"LDDE", 0.125}, {"LDDDE", 0.0625}});
      bool found = false;
      for (const taxonomy::Word& w : record.words) found |= taxonomy::fine(w) == word;
      EXPECT_TRUE(found) << word;
    }
}

TEST(EveryEye, SeesTheClassesOfAPointLightInASphere) {
  // A1 (i).
  for (const auto& [word, camera] : eyes()) {
    Scene scene = inside_sphere(diffuse(0.5f));
    scene.point_lights.push_back({.position = {0, 0, 0}, .intensity = Rgb(std::numbers::pi_v<float>)});
    scene.camera = camera;
    const auto record = render(scene, {.width = 8, .height = 8, .samples_per_pixel = 256});
    expect_energies(record, {{"LDE", 0.5}, {"LDDE", 0.25}, {"LDDDE", 0.125}});
    EXPECT_EQ(energy_of(record, "LE").mean, 0.0);
  }
}

TEST(ThinLens, BlursEveryClassByTheSameCircle) {
  // A half-plane at twice the distance in focus that both emits and reflects a distant light. A ray from the lens point
  // (a, b) through the middle of the focus plane at f t meets it at x = 2 f t - a: the visible share is that of the
  // disk with a > 2 f t. Both classes must be blurred alike.
  constexpr double kRadius = 0.25, kFocus = 2;
  for (const double offset : {-0.6, 0.0, 0.3, 0.8}) {  // of the edge, in lens radii
    Scene scene;
    Material glowing = diffuse(0.5f);
    glowing.emission = Rgb(2);
    const auto edge = static_cast<float>(offset * kRadius);
    add(scene, make_quad({edge - 50, -50, -4}, {50, 0, 0}, {0, 100, 0}), glowing);
    scene.distant_lights.push_back({.direction = {0, 0, -1}, .irradiance = Rgb(3)});
    scene.camera = {.position = {0, 0, 0},
                    .look_at = {0, 0, -1},
                    .vertical_fov_degrees = 0.01f,
                    .lens_radius = static_cast<float>(kRadius),
                    .focus_distance = static_cast<float>(kFocus)};
    const double share = 1 - (std::acos(offset) - offset * std::sqrt(1 - offset * offset)) / kPiD;
    const auto record = render(scene, {.width = 8, .height = 8, .samples_per_pixel = 1024, .max_depth = 1});
    expect_energies(record, {{"LE", 2 * share}, {"LDE", 0.5 / kPiD * 3 * share}});
    for (const taxonomy::Word& word : record.words) EXPECT_EQ(word.eye, taxonomy::Symbol::El);
  }
}

// ---- filters ------------------------------------------------------------------------------------------------------

TEST(Filter, PointsFollowItsShape) {
  constexpr int kCells = 60, kSub = 50, kDraws = 300'000;
  for (const FilterFacts& facts : kFilters) {
    const PixelFilter filter{facts.kind, facts.radius};
    const FilterSampler sampler(filter);
    std::vector<double> weights(kCells), seen(kCells);
    double whole = 0;
    for (int i = 0; i < kCells * kSub; ++i) {
      const double w = filter_value(filter, (2 * (i + 0.5) / (kCells * kSub) - 1) * static_cast<double>(facts.radius));
      weights[static_cast<std::size_t>(i / kSub)] += w;
      whole += w;
    }
    for (double& w : weights) w *= kDraws / whole;
    for (int n = 0; n < kDraws; ++n) {
      const glm::vec2 u = Sampler(3, n, 0, 0).next2();
      const glm::vec2 p = sampler.sample(u);
      ASSERT_LE(std::abs(p.x), facts.radius);
      ASSERT_EQ(p.y, sampler.sample({0.5f, u.y}).y) << "the axes are independent";
      ++seen[static_cast<std::size_t>(std::min(kCells - 1, static_cast<int>((p.x / facts.radius + 1) / 2 * kCells)))];
    }
    EXPECT_LT(chi_square_excess(weights, seen), 3.6) << facts.name;  // 1 % over four filters after Sidak, with skew
  }
}

TEST(Filter, ShowsAnEdgeAsItsIntegral) {
  // A half-plane that emits one, its edge at a distance from the pixel's centre: the pixel shows the filter's integral
  // up to there.
  const struct {
    FilterKind kind;
    float radius;
    double (*share)(double);
  } rows[] = {
      {FilterKind::Box, 0.5f, [](double d) { return std::clamp(d + 0.5, 0.0, 1.0); }},
      {FilterKind::Tent, 1.0f, [](double d) { return d < 0 ? (1 + d) * (1 + d) / 2 : 1 - (1 - d) * (1 - d) / 2; }},
      // Standard deviation one half, cut at two and lowered by its value there.
      {FilterKind::Gaussian, 2.0f,
       [](double d) {
         const double edge = std::exp(-8.0), root = std::sqrt(2 * kPiD) / 2;
         const double part = root * std::erf(std::numbers::sqrt2 * d) / 2 - edge * d;
         return 0.5 + part / (root * std::erf(2 * std::numbers::sqrt2) - 4 * edge);
       }},
      // The integral of the four cosines.
      {FilterKind::BlackmanHarris, 1.5f, [](double d) {
         const double t = kPiD * (1 + d / 1.5);
         return (0.35875 * t - 0.48829 * std::sin(t) + 0.14128 / 2 * std::sin(2 * t) - 0.01168 / 3 * std::sin(3 * t)) /
                (2 * kPiD * 0.35875);
       }}};
  for (const auto& row : rows)
    for (const double distance : {-0.4, 0.0, 0.3}) {
      Scene scene;
      add(scene, make_quad({static_cast<float>(distance) - 50, -50, 0}, {50, 0, 0}, {0, 100, 0}), emitter(1));
      scene.camera = {.position = {0, 0, 1}, .look_at = {0, 0, 0}, .projection = Projection::Orthographic, .height = 1};
      const auto record =
          render(scene, {.width = 1, .height = 1, .samples_per_pixel = 1 << 15, .filter = {row.kind, row.radius}});
      expect_energies(record, {{"LE", row.share(distance)}});
    }
}

TEST(Render, GivesTheSameBytesWithEveryEyeFilterAndSampler) {
  Material wall = diffuse(0.5f);
  wall.emission = Rgb(0.5f);
  wall.emission_sides = Sides::Both;
  for (const auto& [word, camera] : eyes())
    for (const SamplerFacts& sampler : kSamplers) {
      Scene scene = inside_sphere(wall);
      scene.camera = camera;
      RenderSettings settings{.width = 40,
                              .height = 35,
                              .samples_per_pixel = 3,
                              .max_depth = 3,
                              .threads = 1,
                              .filter = {FilterKind::Gaussian, 2},
                              .sampler = sampler.kind};
      const auto one = render(scene, settings);
      for (const int threads : {2, 4}) {
        settings.threads = threads;
        EXPECT_TRUE(render(scene, settings) == one) << word << " " << sampler.name;
      }
    }
}

}  // namespace
}  // namespace heckbert::transport
