// The sky: the image stands where its mapping says, and directions are drawn with the density that is asked for.

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <heckbert/transport/environment.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/sampler.h>

#include "chi_square.h"
#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

/// Every pixel another value; a bright one, and a black region.
Scene sky(Interpolation interpolation, int width = 12, int height = 6) {
  Scene scene;
  EnvironmentImage image{.width = width, .height = height, .interpolation = interpolation};
  for (int i = 0; i < width * height; ++i)
    image.pixels.emplace_back(i % 7 < 2 ? 0.0f : static_cast<float>(i),
                              i == 20 ? 500.0f : static_cast<float>(i % 7 < 2 ? 0 : 1), 0.0f);
  scene.environment_image = std::move(image);
  return scene;
}

glm::vec3 direction_at(double column, double row, int width, int height) {
  const double phi = 2 * kPiD * column / width, theta = kPiD * row / height;
  return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

TEST(Environment, ShowsEachPixelAtItsPlace) {
  for (const Interpolation interpolation : {Interpolation::Nearest, Interpolation::Bilinear}) {
    const Scene scene = sky(interpolation);
    const Environment environment(scene);
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 12; ++x) {
        const Rgb expected = scene.environment_image->pixels[static_cast<std::size_t>(12 * y + x)];
        EXPECT_NEAR(environment.radiance(direction_at(x + 0.5, y + 0.5, 12, 6)).r, expected.r, 1e-3f) << x << " " << y;
      }
  }
  // Halfway between two pixels, and across the seam.
  const Scene scene = sky(Interpolation::Bilinear);
  const auto& pixels = scene.environment_image->pixels;
  const Environment environment(scene);
  EXPECT_NEAR(environment.radiance(direction_at(5, 2.5, 12, 6)).r, 0.5f * (pixels[28].r + pixels[29].r), 1e-3f);
  EXPECT_NEAR(environment.radiance(direction_at(12, 3.5, 12, 6)).r, 0.5f * (pixels[36].r + pixels[47].r), 1e-3f);
  EXPECT_NEAR(environment.radiance(direction_at(3.5, 2, 12, 6)).r, 0.5f * (pixels[15].r + pixels[27].r), 1e-3f);
}

TEST(Environment, LiesAsTheDocumentationSays) {
  Scene scene;
  EnvironmentImage image{.width = 4, .height = 2, .interpolation = Interpolation::Nearest};
  for (int i = 0; i < 8; ++i) image.pixels.emplace_back(static_cast<float>(i));
  scene.environment_image = image;
  const Environment environment(scene);
  EXPECT_EQ(environment.radiance(glm::normalize(glm::vec3(0.1f, 0.1f, -1))).r, 0) << "left edge: -z, then towards +x";
  EXPECT_EQ(environment.radiance(glm::normalize(glm::vec3(1, 0.1f, 0.1f))).r, 1);
  EXPECT_EQ(environment.radiance(glm::normalize(glm::vec3(-0.1f, 0.1f, 1))).r, 2) << "right of the middle";
  EXPECT_EQ(environment.radiance(glm::normalize(glm::vec3(-0.1f, -0.1f, -1))).r, 7);
  scene.environment_image->to_world = glm::mat3(glm::rotate(glm::mat4(1), glm::radians(90.0f), glm::vec3(1, 0, 0)));
  // What was up lies towards +z now, what was towards -z is up.
  EXPECT_EQ(environment.radiance(glm::normalize(glm::vec3(0.1f, 1, 0.1f))).r, 0);
}

TEST(Environment, DrawsDirectionsByItsDensity) {
  constexpr int kRows = 24, kColumns = 24, kSub = 16, kDraws = 200'000;
  for (const Interpolation interpolation : {Interpolation::Nearest, Interpolation::Bilinear}) {
    Scene scene = sky(interpolation);
    scene.environment_image->to_world = glm::mat3(glm::rotate(glm::mat4(1), 1.1f, glm::normalize(glm::vec3(1, 2, 3))));
    const Environment environment(scene);
    std::vector<double> expected(kRows * kColumns), seen(kRows * kColumns);
    double whole = 0;
    for (int i = 0; i < kRows * kSub; ++i)
      for (int j = 0; j < kColumns * kSub; ++j) {
        // Cells of the image's own sphere, so that none straddles an edge of the density.
        const double low = std::cos(kPiD * i / (kRows * kSub)), high = std::cos(kPiD * (i + 1) / (kRows * kSub));
        const glm::vec3 local = direction_at(j + 0.5, i + 0.5, kColumns * kSub, kRows * kSub);
        const double p = environment.pdf_solid_angle(scene.environment_image->to_world * local) * (low - high) * 2 *
                         kPiD / (kColumns * kSub);
        expected[static_cast<std::size_t>(i / kSub * kColumns + j / kSub)] += p * kDraws;
        whole += p;
      }
    EXPECT_NEAR(whole, 1, 1e-4);
    for (int n = 0; n < kDraws; ++n) {
      const EnvironmentSample s = environment.sample(Sampler(3, n, 0, 0).next2());
      ASSERT_NEAR(glm::length(s.direction), 1, 1e-5);
      const glm::vec3 local = glm::transpose(scene.environment_image->to_world) * s.direction;
      double turn = std::atan2(local.x, -local.z) / (2 * kPiD);
      if (turn < 0) turn += 1;
      const int row = std::min(static_cast<int>(std::acos(static_cast<double>(local.y)) / kPiD * kRows), kRows - 1);
      const int column = std::min(static_cast<int>(turn * kColumns), kColumns - 1);
      ++seen[static_cast<std::size_t>(row * kColumns + column)];
    }
    EXPECT_LT(chi_square_excess(expected, seen), 3.2);  // 1 % over two cases after Sidak, with skew
  }
}

TEST(Environment, IsNowhereBrightWhereItIsNeverDrawn) {
  for (const Interpolation interpolation : {Interpolation::Nearest, Interpolation::Bilinear}) {
    const Scene scene = sky(interpolation);
    const Environment environment(scene);
    for (int n = 0; n < 100'000; ++n) {
      const glm::vec3 d = uniform_sphere(Sampler(9, n, 0, 0).next2());
      ASSERT_TRUE(max_channel(environment.radiance(d)) < 1e-4f || environment.pdf_solid_angle(d) > 0);
    }
  }
}

TEST(Environment, AConstantImageIsAConstantSky) {
  // A convex body of albedo rho under a sky of radiance one: L(e)DE = rho; the sky itself is L(e)E = 1. A2 and A13.
  for (const Interpolation interpolation : {Interpolation::Nearest, Interpolation::Bilinear}) {
    Scene scene;
    add(scene, Sphere{{0, 0, 0}, 1}, diffuse(0.6f));
    scene.environment_image = EnvironmentImage{
        .width = 8, .height = 4, .pixels = std::vector<Rgb>(32, Rgb(0.75f)), .interpolation = interpolation};
    scene.environment = Rgb(0.25f);
    scene.camera = {.position = {0, 0, 3}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 10};
    for (const AlgorithmFacts& algorithm : algorithms_that_find("LeDrEp")) {
      const auto record =
          render(scene, {.algorithm = algorithm.id, .width = 8, .height = 8, .samples_per_pixel = 1024});
      expect_energies(record, {{"LDE", 0.6}});
      EXPECT_EQ(taxonomy::fine(record.words.at(0)), "LeDrEp");
    }
  }
}

TEST(Environment, LightsAFloorByItsRows) {
  // Rows of constant radiance between polar angles a and b send pi (sin^2 b - sin^2 a) each.
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), {.name = "floor", .lobes = {Lambert{Rgb(0.5f)}}});
  EnvironmentImage image{.width = 2, .height = 8, .interpolation = Interpolation::Nearest};
  const double rows[] = {10, 0, 3, 1, 50, 50, 50, 50};
  double expected = 0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 2; ++x) image.pixels.emplace_back(static_cast<float>(rows[y]));
    const auto sine = [](double row) { return std::sin(row * kPiD / 8); };
    if (y < 4) expected += 0.5 * rows[y] * (sine(y + 1) * sine(y + 1) - sine(y) * sine(y));
  }
  scene.environment_image = image;
  scene.camera = {.position = {0, 2, 1}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 1};
  for (const AlgorithmId algorithm : {AlgorithmId::Path, AlgorithmId::Whitted}) {
    const auto record =
        render(scene, {.algorithm = algorithm, .width = 8, .height = 8, .samples_per_pixel = 2048, .max_depth = 1});
    expect_energies(record, {{"LDE", expected}});
  }
}

TEST(Environment, RefusesAnImageThatDoesNotFitItsSize) {
  Scene scene;
  scene.environment_image = EnvironmentImage{.width = 3, .height = 2, .pixels = std::vector<Rgb>(5)};
  EXPECT_THROW(Environment{scene}, std::invalid_argument);
}

}  // namespace
}  // namespace heckbert::transport
