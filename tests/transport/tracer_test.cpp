// Rays must neither hit the surface they leave nor skip the next one. The parity rule: with eye and light outside all
// solids, a path crosses glass an even number of times, so every word has an even number of t events.

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/tracer.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

const Material kGlass{.name = "glass", .lobes = {Dielectric{}}};

int transmissions(const taxonomy::Word& word) {
  return static_cast<int>(std::count(word.events.begin(), word.events.end(), taxonomy::Symbol::St));
}

/// A ball that fills the picture, silhouette included, under a white sky.
Scene glass_ball(float radius, glm::vec3 center, float ior) {
  Scene scene;
  add(scene, Sphere{center, radius}, {.name = "glass", .lobes = {Dielectric{.ior = ior}}});
  scene.environment = Rgb(1);
  scene.camera = {.position = center + glm::vec3(0, 0, 3 * radius), .look_at = center, .vertical_fov_degrees = 42};
  return scene;
}

TEST(GlassBall, IsCrossedInPairsAtEveryScaleAndDistance) {
  const struct {
    float radius;
    glm::vec3 center;
    float ior;
  } rows[] = {{1, {0, 0, 0}, 1.5f},    {1e-3f, {0, 0, 0}, 1.5f}, {1e4f, {0, 0, 0}, 1.5f}, {1, {1000, -500, 2000}, 1.5f},
              {1, {0, 0, 0}, 1.0001f}, {1, {0, 0, 0}, 2.5f},     {1, {0, 0, 0}, 0.7f}};
  for (const auto& row : rows) {
    const auto record = render(glass_ball(row.radius, row.center, row.ior),
                               {.width = 64, .height = 64, .samples_per_pixel = 256, .max_depth = 64});
    ASSERT_GT(record.words.size(), 3u);
    for (const taxonomy::Word& word : record.words)
      EXPECT_EQ(transmissions(word) % 2, 0)
          << taxonomy::fine(word) << " at radius " << row.radius << ", ior " << row.ior;
  }
}

TEST(GlassBall, IsInvisibleInAWhiteRoom) {
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LeStStEp")) {
    const auto record =
        render(glass_ball(1, {0, 0, 0}, 1.5f),
               {.algorithm = algorithm.id, .width = 32, .height = 32, .samples_per_pixel = 256, .max_depth = 200});
    const auto total = record::energy(record, std::vector<bool>(record.words.size(), true));
    EXPECT_NEAR(total.mean, 1.0, 4 * total.standard_error + 1e-4) << algorithm.name;
    EXPECT_LT(total.standard_error, 0.01) << algorithm.name;
  }
}

TEST(GlassBall, HoldsRadianceTimesTheSquareOfItsIndex) {
  // From the centre all rays leave head on; inside, the sky's radiance is larger by n^2 (Veach 1997, 5.2).
  Scene scene = glass_ball(1, {0, 0, 0}, 1.5f);
  scene.camera = {.position = {0, 0, 0}, .look_at = {0, 0, -1}};
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LeStEp")) {
    const auto record = render(scene, {.algorithm = algorithm.id, .width = 8, .height = 8, .samples_per_pixel = 256});
    expect_energies(record, {{"LSE", 2.25 * 0.96}});
    const auto total = record::energy(record, std::vector<bool>(record.words.size(), true));
    EXPECT_NEAR(total.mean, 2.25, 4 * total.standard_error + 1e-4) << algorithm.name;
  }
}

TEST(GlassBox, IsCrossedInPairsDespiteItsEdges) {
  Scene scene;
  add(scene, make_box({-1, -1, -1}, {1, 1, 1}), kGlass);
  scene.environment = Rgb(1);
  scene.camera = {.position = {2.5f, 2, 3}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 50};
  const auto record = render(scene, {.width = 64, .height = 64, .samples_per_pixel = 256, .max_depth = 64});
  for (const taxonomy::Word& word : record.words) EXPECT_EQ(transmissions(word) % 2, 0) << taxonomy::fine(word);
}

TEST(Tracer, RaysLeavingAPlaneNeverHitIt) {
  for (const float scale : {1e-3f, 1.0f, 1e4f}) {
    Scene scene;
    add(scene, make_quad(glm::vec3(-7, 3, -11) * scale, {0, 0, 23 * scale}, {19 * scale, 0, 0}), diffuse(1));
    const Tracer tracer(scene);
    for (int n = 0; n < 100'000; ++n) {
      Sampler sampler(1, n, 0, 0);
      const glm::vec2 u = sampler.next2();
      const glm::vec3 target = glm::vec3(-7 + 19 * u.x, 3, -11 + 23 * u.y) * scale;
      const glm::vec3 origin = target + glm::vec3(0.3f, 2, -0.4f) * scale;
      const auto hit = tracer.intersect({origin, glm::normalize(target - origin)});
      if (!hit) continue;  // the very rim
      const glm::vec3 out = uniform_sphere(sampler.next2());
      const bool up = out.y > 0;
      ASSERT_FALSE(tracer.intersect({leave(*hit, up), out})) << scale << " " << n;
      ASSERT_FALSE(tracer.is_occluded(Ray{leave(*hit, up), out})) << scale << " " << n;
    }
  }
}

TEST(Tracer, SeesASurfaceCloseBehindAnother) {
  Scene scene;
  add(scene, make_quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}), diffuse(1));
  add(scene, make_quad({-1, -1e-4f, -1}, {0, 0, 2}, {2, 0, 0}), diffuse(1));
  const Tracer tracer(scene);
  const glm::vec3 down = glm::normalize(glm::vec3(0.1f, -1, 0.2f));
  const auto first = tracer.intersect({{0, 1, 0}, down});
  ASSERT_TRUE(first);
  const auto second = tracer.intersect({leave(*first, false), down});
  ASSERT_TRUE(second);
  EXPECT_EQ(second->material, 1u);
}

TEST(Instance, IsTracedWhereItIsPlacedAndLightsTheScene) {
  // The unit square of FormFactor.OfAUnitSquareAtDistanceOne, put there by a mirroring, scaling transform.
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  scene.materials.push_back(emitter(2));
  scene.groups.push_back(
      {.name = "lamp",
       .shapes = {{.name = "square", .geometry = make_quad({0, 0, 0}, {0, 0, 2}, {-2, 0, 0}), .material = 1}}});
  scene.instances.push_back(
      {.group = 0,
       .to_world = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, 1, 0)), glm::vec3(-0.5f, 1, 0.5f))});
  scene.camera = {.position = {2.5f, 0.5f, 2.5f}, .look_at = {0.5f, 0, 0.5f}, .vertical_fov_degrees = 0.01f};
  const RenderSettings settings{.width = 8, .height = 8, .samples_per_pixel = 1024, .max_depth = 1};
  expect_energies(render(scene, settings), {{"LDE", 0.239456471}});
  // Mirroring turns directions but not sides: what faced up before still does, and sends nothing down.
  scene.groups[0].shapes[0].geometry = make_quad({0, 0, 0}, {-2, 0, 0}, {0, 0, 2});
  EXPECT_TRUE(render(scene, settings).words.empty());
}

/// A ball of radius one as a mesh of latitudes and longitudes, with the ball's own normals.
Mesh smooth_ball(unsigned rows) {
  Mesh ball;
  const unsigned columns = 2 * rows;
  for (unsigned i = 0; i <= rows; ++i)
    for (unsigned j = 0; j <= columns; ++j) {
      const double theta = std::numbers::pi * i / rows, phi = std::numbers::pi * j / rows;
      ball.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    }
  for (unsigned i = 0; i < rows; ++i)
    for (unsigned j = 0; j < columns; ++j) {
      const unsigned a = i * (columns + 1) + j, b = a + columns + 1;
      if (i > 0) ball.triangles.emplace_back(a, a + 1, b + 1);
      if (i + 1 < rows) ball.triangles.emplace_back(a, b + 1, b);
    }
  ball.normals = ball.positions;
  return ball;
}

TEST(SmoothMesh, AConvexMirrorIsSeenInOneReflectionUpToItsRim) {
  Scene scene;
  add(scene, smooth_ball(16), {.name = "mirror", .lobes = {Mirror{Rgb(1)}}});
  scene.environment = Rgb(1);
  scene.camera = {.position = {0, 0, 4}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 32};
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LeSrEp")) {
    const auto record = render(scene, {.algorithm = algorithm.id, .width = 64, .height = 64, .samples_per_pixel = 16});
    ASSERT_EQ(record.words.size(), 2u) << algorithm.name;
    EXPECT_EQ(taxonomy::plain(record.words[0]), "LE");
    EXPECT_EQ(taxonomy::plain(record.words[1]), "LSE");
    EXPECT_NEAR(energy_of(record, "LE").mean + energy_of(record, "LSE").mean, 1.0, 1e-6);
  }
}

TEST(SmoothMesh, HasTheNormalsOfTheSurfaceItStandsForUnderAnyTransform) {
  // Stretching a ball by a along x gives an ellipsoid, whose normal at p is along (p.x / a^2, p.y, p.z).
  for (const float a : {1.0f, 3.0f, -3.0f}) {
    Scene scene;
    scene.materials = {diffuse(1)};
    scene.groups.push_back({.name = "g", .shapes = {{.name = "ball", .geometry = smooth_ball(64)}}});
    scene.instances.push_back({.group = 0, .to_world = glm::scale(glm::mat4(1), glm::vec3(a, 1, 1))});
    const Tracer tracer(scene);
    for (const glm::vec3 towards : {glm::vec3(0, 0, 0), glm::vec3(0.5f * a, 0.3f, 0), glm::vec3(-0.8f * a, -0.2f, 0)}) {
      const auto hit = tracer.intersect({{towards.x, towards.y, 5}, {0, 0, -1}});
      ASSERT_TRUE(hit);
      EXPECT_TRUE(hit->front);
      const glm::vec3 p = hit->position;
      const glm::vec3 expected = glm::normalize(glm::vec3(p.x / (a * a), p.y, p.z));
      EXPECT_LT(glm::length(hit->normal_shading - expected), 1e-3f) << a;
      EXPECT_GT(glm::length(hit->normal_geometric - expected), 1e-3f) << "the facets must not do by themselves";
    }
  }
}

TEST(Instance, ScalesASphereAndTheLightItGives) {
  // FormFactor.OfASphere, with the ball of radius 1/2 at height 2 made of a unit ball by a turning, shrinking
  // transform.
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  scene.materials.push_back(emitter(2));
  scene.groups.push_back(
      {.name = "lamp", .shapes = {{.name = "ball", .geometry = Sphere{{2, 0, 0}, 1}, .material = 1}}});
  const glm::mat4 turned =
      glm::rotate(glm::translate(glm::mat4(1), glm::vec3(0, 1, 0)), glm::radians(90.0f), glm::vec3(0, 0, 1));
  scene.instances.push_back({.group = 0, .to_world = glm::scale(turned, glm::vec3(0.5f))});
  scene.camera = {.position = {2, 0.5f, 2}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 0.01f};
  expect_energies(render(scene, {.width = 8, .height = 8, .samples_per_pixel = 1024, .max_depth = 1}),
                  {{"LDE", 1.0 / 16.0}});
  // Seen directly it is as wide as it should be: half the picture's height at a view of twice its angle.
  scene.camera = {
      .position = {0, 2, 8}, .look_at = {0, 2, 0}, .vertical_fov_degrees = 4 * glm::degrees(std::asin(0.5f / 8))};
  const auto image = record::beauty(render(scene, {.width = 64, .height = 64, .samples_per_pixel = 4, .max_depth = 0}));
  EXPECT_EQ(image.at(32, 32).g, 2.0f);
  EXPECT_EQ(image.at(32, 17).g, 2.0f);
  EXPECT_EQ(image.at(32, 14).g, 0.0f);
}

TEST(Tracer, RefusesWhatBreaksTheRulesOfAScene) {
  Scene stretched;
  stretched.materials = {diffuse(1)};
  stretched.groups.push_back({.name = "g", .shapes = {{.name = "ball", .geometry = Sphere{}}}});
  stretched.instances.push_back({.group = 0, .to_world = glm::scale(glm::mat4(1), glm::vec3(1, 2, 1))});
  EXPECT_THROW(Tracer{stretched}, std::invalid_argument);
  Scene dangling;
  dangling.shapes.push_back({.name = "ball", .geometry = Sphere{}, .material = 3});
  EXPECT_THROW(Tracer{dangling}, std::invalid_argument);
  Scene no_ball;
  no_ball.materials = {diffuse(1)};
  no_ball.shapes.push_back({.name = "ball", .geometry = Sphere{.radius = 0}});
  EXPECT_THROW(Tracer{no_ball}, std::invalid_argument);
  Scene no_vertex;
  no_vertex.materials = {diffuse(1)};
  no_vertex.shapes.push_back({.name = "mesh", .geometry = Mesh{.positions = {{0, 0, 0}}, .triangles = {{0, 1, 2}}}});
  EXPECT_THROW(Tracer{no_vertex}, std::invalid_argument);
}

}  // namespace
}  // namespace heckbert::transport
