// The anchors A1, A3, A4 and A8 of docs/anchors.md, class by class: scenes whose every word has a known value.

#include <numbers>

#include <gtest/gtest.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

// ---- A1: a unit sphere seen from inside, albedo 1/2 (after pbrt-v4's analytic scenes, per class) ------------------

TEST(SphereFromInside, OnePointLightGivesHalfToTheNthPerBounce) {
  Scene scene = inside_sphere(diffuse(0.5f));
  scene.point_lights.push_back({.position = {0, 0, 0}, .intensity = Rgb(std::numbers::pi_v<float>)});
  const auto record = render(scene, {.width = 16, .height = 16, .samples_per_pixel = 256});
  expect_energies(record, {{"LDE", 0.5}, {"LDDE", 0.25}, {"LDDDE", 0.125}, {"LDDDDE", 0.0625}, {"LDDDDDE", 0.03125}});
  EXPECT_EQ(energy_of(record, "LE").mean, 0.0);
}

TEST(SphereFromInside, FourQuarterLightsEqualOne) {
  Scene scene = inside_sphere(diffuse(0.5f));
  for (int i = 0; i < 4; ++i)
    scene.point_lights.push_back({.position = {0, 0, 0}, .intensity = Rgb(std::numbers::pi_v<float> / 4)});
  const auto record = render(scene, {.width = 16, .height = 16, .samples_per_pixel = 256});
  expect_energies(record, {{"LDE", 0.5}, {"LDDE", 0.25}, {"LDDDE", 0.125}});
}

TEST(SphereFromInside, AnEmittingSphereAlsoReflects) {
  Material wall = diffuse(0.5f);
  wall.emission = Rgb(0.5f);
  wall.emission_sides = Sides::Both;
  const auto record = render(inside_sphere(wall), {.width = 16, .height = 16, .samples_per_pixel = 256});
  expect_energies(record, {{"LE", 0.5}, {"LDE", 0.25}, {"LDDE", 0.125}, {"LDDDE", 0.0625}, {"LDDDDE", 0.03125}});
}

// ---- A3: flux book-keeping in a closed room -----------------------------------------------------------------------
// The flux that enters a scattering prefix is the source's flux times the albedos so far, wherever light and walls are.
// A pinhole in the middle of a cube looking squarely at a wall with a view of 90 degrees spreads its pixels evenly over
// that wall; six such pictures average over all walls. Words whose last scattering is diffuse then have the mean
// radiance flux * product of albedos / (pi * area).

struct View {
  glm::vec3 direction, up;
};
constexpr View kSixViews[] = {{{1, 0, 0}, {0, 1, 0}},  {{-1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, 1}},
                              {{0, -1, 0}, {0, 0, 1}}, {{0, 0, 1}, {0, 1, 0}},  {{0, 0, -1}, {0, 1, 0}}};

TEST(FluxInAClosedRoom, EachPrefixHoldsTheFluxTimesItsAlbedos) {
  constexpr double kFlux = 1000, kSide = 4;
  constexpr float kDiffuse = 0.5f, kMirror = 0.3f;
  Scene scene;
  add(scene, make_box(glm::vec3(-2), glm::vec3(2), true),
      {.name = "wall", .lobes = {Lambert{Rgb(kDiffuse)}, Mirror{Rgb(kMirror)}}});
  scene.point_lights.push_back(
      {.position = {0.7f, -1.1f, 1.3f}, .intensity = Rgb(static_cast<float>(kFlux / (4 * kPiD)))});
  // A point light cannot be hit, so of the words ending in D those whose first letter is S are missing; the rest keep
  // their share: L D w D E for any w.
  std::map<std::string, double> truth;
  for (const char* word : {"LDE", "LDDE", "LDDDE", "LDSDE", "LDDDDE", "LDDSDE", "LDSDDE", "LDSSDE"})
    truth[word] = kFlux * product_of_albedos(word, kDiffuse, kMirror) / (kPiD * 6 * kSide * kSide);
  std::map<std::string, double> mean, variance;
  for (const View& view : kSixViews) {
    scene.camera = {.position = {0, 0, 0}, .look_at = view.direction, .up = view.up, .vertical_fov_degrees = 90};
    const auto record = render(scene, {.width = 24, .height = 24, .samples_per_pixel = 256, .max_depth = 8});
    for (const auto& [word, value] : truth) {
      const auto e = energy_of(record, word);
      mean[word] += e.mean / 6;
      variance[word] += e.standard_error * e.standard_error / 36;
    }
    for (const char* word : {"LSE", "LSDE", "LSSE", "LE"}) EXPECT_EQ(energy_of(record, word).mean, 0.0) << word;
  }
  // 1 % for eight words after Sidak; six times 31 degrees of freedom are normal enough.
  for (const auto& [word, value] : truth) {
    EXPECT_NEAR(mean[word], value, 3.22 * std::sqrt(variance[word])) << word;
    EXPECT_LT(std::sqrt(variance[word]), 0.02 * value) << word;
  }
}

// ---- A4: an integrating sphere with two albedos --------------------------------------------------------------------
// Inside a sphere every point sees every other with the same kernel, so light of an emitting cap with area fraction f
// is spread evenly: L D^n E = rho(x) * mean_rho^(n-1) * f * Le.

Mesh icosphere(int subdivisions) {
  const float g = std::numbers::phi_v<float>;
  std::vector<glm::vec3> p{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                           {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<glm::uvec3> t{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                            {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                            {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<unsigned, unsigned>, unsigned> middle;
    const auto mid = [&](unsigned a, unsigned b) {
      const auto [at, added] = middle.try_emplace(std::minmax(a, b), static_cast<unsigned>(p.size()));
      if (added) p.push_back(p[a] + p[b]);
      return at->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3 f : t) {
      const unsigned a = mid(f.x, f.y), b = mid(f.y, f.z), c = mid(f.z, f.x);
      finer.insert(finer.end(), {{f.x, a, c}, {f.y, b, a}, {f.z, c, b}, {a, b, c}});
    }
    t = std::move(finer);
    for (glm::vec3& v : p) v = glm::normalize(v);
  }
  return {.positions = p, .triangles = t};
}

TEST(IntegratingSphere, SpreadsLightEvenlyWhateverTheAlbedos) {
  Mesh sphere = icosphere(5);
  // Bands by height: a bright lower and a dark upper wall, and a lamp at the top.
  constexpr float kLow = 0.8f, kHigh = 0.2f, kLamp = 100.0f;
  double area[3] = {0, 0, 0};
  for (const glm::uvec3 t : sphere.triangles) {
    const glm::vec3 a = sphere.positions[t.x], b = sphere.positions[t.y], c = sphere.positions[t.z];
    const float height = (a.y + b.y + c.y) / 3;
    const std::uint32_t band = height > 0.97f ? 2 : height > 0 ? 1 : 0;
    sphere.face_materials.push_back(band);
    area[band] += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  const double whole = area[0] + area[1] + area[2];
  const double mean_rho = (kLow * area[0] + kHigh * area[1]) / whole;
  const double flux = area[2] / whole * kLamp;

  Scene scene;
  scene.materials = {diffuse(kLow), diffuse(kHigh), emitter(kLamp, Sides::Both)};
  scene.shapes.push_back({.name = "sphere", .geometry = sphere});
  const struct {
    glm::vec3 look_at;
    double rho;
  } views[] = {{{0.4f, -1, 0.1f}, kLow}, {{-0.9f, 0.5f, 0.2f}, kHigh}};
  for (const auto& view : views) {
    scene.camera = {.position = {0, 0, 0}, .look_at = view.look_at, .vertical_fov_degrees = 20};
    const auto record = render(scene, {.width = 16, .height = 16, .samples_per_pixel = 1024});
    // The facets depart from the sphere by 2e-4 of its radius, which is below the noise here.
    expect_energies(record, {{"LDE", view.rho * flux},
                             {"LDDE", view.rho * mean_rho * flux},
                             {"LDDDE", view.rho * mean_rho * mean_rho * flux}});
    EXPECT_EQ(energy_of(record, "LE").mean, 0.0);
  }
}

// ---- A8: direct lighting and form factors -------------------------------------------------------------------------
// The radiance of a floor point of albedo rho under a lamp of radiance Le is rho * Le * F.

/// A floor seen from the side at a point below the origin, with the lamp's quad or fan above.
record::Record point_below(Geometry lamp, glm::vec3 point) {
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  add(scene, std::move(lamp), emitter(2.0f));
  scene.camera = {.position = point + glm::vec3(2, 0.5f, 2), .look_at = point, .vertical_fov_degrees = 0.01f};
  return render(scene, {.width = 8, .height = 8, .samples_per_pixel = 2048, .max_depth = 1});
}

TEST(FormFactor, OfAUnitSquareAtDistanceOne) {
  const Mesh lamp = make_quad({0, 1, 0}, {1, 0, 0}, {0, 0, 1});  // faces down
  expect_energies(point_below(lamp, {0, 0, 0}), {{"LDE", 0.138531606}});
  expect_energies(point_below(lamp, {0.5f, 0, 0.5f}), {{"LDE", 0.239456471}});
}

TEST(FormFactor, OfACoaxialDisk) {
  Mesh disk{.positions = {{0, 2, 0}}, .triangles = {}};
  constexpr unsigned kSegments = 4096;
  for (unsigned i = 0; i < kSegments; ++i) {
    const double phi = 2 * kPiD * i / kSegments;
    disk.positions.emplace_back(std::cos(phi), 2, std::sin(phi));
    disk.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % kSegments);
  }
  expect_energies(point_below(disk, {0, 0, 0}), {{"LDE", 1.0 / 5.0}});  // R^2 / (R^2 + h^2) with R = 1, h = 2
}

TEST(FormFactor, OfASphere) {
  expect_energies(point_below(Sphere{{0, 2, 0}, 0.5f}, {0, 0, 0}), {{"LDE", 1.0 / 16.0}});  // (R / d)^2
}

TEST(FormFactor, OfAStarlikeSphere) {
  // Ten million radii away: neither the cone nor the point on the sphere may be lost to cancellation.
  Scene scene;
  add(scene, make_quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}), diffuse(0.5f));
  add(scene, Sphere{{0, 1000, 0}, 1e-4f}, emitter(2e14f));
  scene.camera = {.position = {0.3f, 0.5f, 0}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 0.01f};
  expect_energies(render(scene, {.width = 8, .height = 8, .samples_per_pixel = 64, .max_depth = 1}), {{"LDE", 1.0}});
}

TEST(FormFactor, OfTheCornellLampFromTheFloor) {
  const Mesh lamp = make_quad({-65, 548.8f, -52.5f}, {130, 0, 0}, {0, 0, 105});
  expect_energies(point_below(lamp, {0, 0, 0}), {{"LDE", 0.01420696}});
}

TEST(FormFactor, BetweenTheFacesOfACube) {
  const Mesh floor = make_quad({-0.5f, -0.5f, -0.5f}, {0, 0, 1}, {1, 0, 0});
  const Mesh ceiling = make_quad({-0.5f, 0.5f, -0.5f}, {1, 0, 0}, {0, 0, 1});
  const Mesh side = make_quad({0.5f, -0.5f, -0.5f}, {0, 0, 1}, {0, 1, 0});
  const struct {
    const Mesh& lamp;
    double form_factor;
  } rows[] = {{ceiling, 0.199824896}, {side, 0.200043776}};
  for (const auto& row : rows) {
    Scene scene;
    add(scene, floor, diffuse(1));
    add(scene, row.lamp, emitter(1, Sides::Both));
    scene.camera = {.position = {0, 0, 0}, .look_at = {0, -1, 0}, .up = {0, 0, 1}, .vertical_fov_degrees = 90};
    expect_energies(render(scene, {.width = 32, .height = 32, .samples_per_pixel = 1024, .max_depth = 1}),
                    {{"LDE", row.form_factor}});
  }
}

TEST(FormFactor, OfTheSkyBesideAWall) {
  // A long wall of height h at distance d covers (1 - d / hypot(d, h)) / 2 of a floor point's view (Lambert's cosine
  // included), and is black itself.
  Scene scene;
  // Rays leave a surface by a few millionths of its size, which the wall must not notice.
  add(scene, make_quad({-100, 0, -100}, {0, 0, 200}, {200, 0, 0}), diffuse(0.5f));
  add(scene, make_quad({1, 0, -100}, {0, 1, 0}, {0, 0, 200}), {.name = "black", .lobes = {}});
  scene.environment = Rgb(2);
  scene.camera = {.position = {-1, 0.5f, 0.2f}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 0.01f};
  expect_energies(render(scene, {.width = 16, .height = 16, .samples_per_pixel = 1024, .max_depth = 1}),
                  {{"LDE", (1 + std::numbers::sqrt2 / 2) / 2}});
}

// ---- Superposition: light adds up -----------------------------------------------------------------------------------
// A scene with several lights holds, word by word, the sum of what each light gives alone. Alone, a light is chosen
// with certainty; together, each with its own probability, which every weight must see.

TEST(Superposition, LightsOfEveryKindAddUpWordByWord) {
  Scene room;
  add(room, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}),
      {.name = "floor", .lobes = {Lambert{Rgb(0.3f)}, ggx(Rgb(0.5f), 0.2f)}});
  add(room, make_quad({1.5f, 0, -2}, {0, 0, 4}, {0, 3, 0}), diffuse(0.6f));
  const std::size_t lamp = room.materials.size();
  add(room, Sphere{{-1.6f, 0.8f, 0}, 0.4f}, emitter(5));
  add(room, make_quad({-1.2f, 1.5f, 0.6f}, {0.5f, 0, 0}, {0, 0, 0.5f}), emitter(9));
  const PointLight point{.position = {-0.5f, 1, -1}, .intensity = Rgb(1)};
  room.camera = {.position = {1.3f, 0.9f, 0}, .look_at = {-0.1f, 0, 0}, .vertical_fov_degrees = 30};
  const auto lit_by = [&](bool ball, bool square, bool lamp_point, bool sky) {
    Scene scene = room;
    if (!ball) scene.materials[lamp].emission = Rgb(0);
    if (!square) scene.materials[lamp + 1].emission = Rgb(0);
    if (lamp_point) scene.point_lights.push_back(point);
    // The power of the sky goes by the size of the scene: dim, or nothing else would ever be chosen.
    if (sky) scene.environment = Rgb(2e-3f);
    return render(scene, {.width = 16, .height = 16, .samples_per_pixel = 1024, .max_depth = 2});
  };
  const record::Record alone[] = {lit_by(true, false, false, false), lit_by(false, true, false, false),
                                  lit_by(false, false, true, false), lit_by(false, false, false, true)};
  const record::Record together = lit_by(true, true, true, true);
  for (const char* word : {"LDE", "LGE", "LDDE"}) {
    double sum = 0, variance = 0;
    for (const record::Record& r : alone) {
      const auto e = energy_of(r, word);
      EXPECT_GT(e.mean, 0) << word;
      sum += e.mean;
      variance += e.standard_error * e.standard_error;
    }
    const auto e = energy_of(together, word);
    variance += e.standard_error * e.standard_error;
    // Two-sample z-test, 1 % over three words after Sidak.
    EXPECT_NEAR(e.mean, sum, 2.93 * std::sqrt(variance)) << word;
    EXPECT_LT(std::sqrt(variance), 0.02 * sum) << word;
  }
}

TEST(FormFactor, OfALargeLightFarBelowTheHorizonIsOccluded) {
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  add(scene, make_quad({-1, -1, -1}, {2, 0, 0}, {0, 0, 2}), emitter(2.0f, Sides::Both));
  scene.camera = {.position = {2, 0.5f, 2}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 1};
  const auto record = render(scene, {.width = 8, .height = 8, .samples_per_pixel = 64, .max_depth = 4});
  EXPECT_TRUE(record.words.empty());
}

}  // namespace
}  // namespace heckbert::transport
