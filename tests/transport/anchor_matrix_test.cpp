// The anchors of docs/anchors.md for the tracers below, every kind of light and every kind of eye, word by word. Light
// tracing, which finds too little of so small a picture, is held against the path tracer in bidirectional_test.cpp.
//
// Each scene looks the same to every eye: inside closed walls light is spread evenly (A1, A2, A4), over a wide floor
// (A8) a panoramic eye sees in one half of its picture what the others see in all of theirs, and in the middle of a
// ball of fog (A13) every direction is alike. Form factors (A8) are seen by the three eyes that can look at one point.
// What a way of tracing cannot find, because its grammar has no such word or because it only runs into lights, must be
// absent.

#include <numbers>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;
constexpr float kAlbedo = 0.5f;

constexpr AlgorithmId kWays[] = {AlgorithmId::Path,       AlgorithmId::PathHits,     AlgorithmId::PathNextEvent,
                                 AlgorithmId::Whitted,    AlgorithmId::Lecture,      AlgorithmId::Distribution,
                                 AlgorithmId::RayCasting, AlgorithmId::Bidirectional};

/// Narrow enough for a point, and of a width that closed scenes do not care about.
struct EyeKind {
  const char* name;
  void (*make)(Camera&);
  bool all_around;
};
constexpr EyeKind kEyes[] = {{"pinhole", [](Camera& c) { c.vertical_fov_degrees = 0.01f; }, false},
                             {"lens",
                              [](Camera& c) {
                                c.vertical_fov_degrees = 0.01f;
                                c.lens_radius = 1e-4f;
                                c.focus_distance = glm::distance(c.position, c.look_at);
                              },
                              false},
                             {"orthographic",
                              [](Camera& c) {
                                c.projection = Projection::Orthographic;
                                c.height = 1e-4f;
                              },
                              false},
                             {"panoramic",
                              [](Camera& c) {
                                c.projection = Projection::Panoramic;
                                c.look_at = c.position + glm::vec3(1, 0, 0);  // along the horizon
                              },
                              true}};

using Energies = std::map<std::string, double>;

struct Anchor {
  std::string name;
  Scene scene;
  Energies truth;       ///< by plain word
  Energies all_around;  ///< to the panoramic eye; empty: it has no closed form
  bool can_be_hit = true;
};

Anchor closed(std::string name, Scene scene, const Energies& truth, bool can_be_hit = true) {
  return {std::move(name), std::move(scene), truth, truth, can_be_hit};
}

// ---- A1, A2: closed walls -------------------------------------------------------------------------------------------

Material glowing_wall() {
  return {.name = "wall", .lobes = {Lambert{Rgb(kAlbedo)}, Mirror{Rgb(0.3f)}}, .emission = Rgb(1)};
}

Energies furnace_energies() {
  Energies truth;
  for (const std::string& word : words_over_ds(2)) truth[word] = product_of_albedos(word, kAlbedo, 0.3);
  return truth;
}

/// Eight triangles that face inwards.
Mesh octahedron() {
  Mesh mesh{.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, .triangles = {}};
  for (const unsigned x : {0u, 1u})
    for (const unsigned y : {2u, 3u})
      for (const unsigned z : {4u, 5u})
        mesh.triangles.emplace_back((x + y + z) % 2 == 0 ? glm::uvec3(x, z, y) : glm::uvec3(x, y, z));
  return mesh;
}

Scene with_eye_inside(Scene scene) {
  scene.camera = {.position = {0.1f, 0.2f, 0.15f}, .look_at = {0.7f, 0.1f, -0.4f}};
  return scene;
}

void add_furnaces(std::vector<Anchor>& anchors) {
  Scene mesh, quads, ball;
  add(mesh, octahedron(), glowing_wall());
  add(quads, make_box({-1, -1, -1}, {1, 1, 1}, true), glowing_wall());
  Material both = glowing_wall();
  both.emission_sides = Sides::Both;
  add(ball, Sphere{{0, 0, 0}, 1}, both);
  anchors.push_back(closed("furnace of triangles", with_eye_inside(mesh), furnace_energies()));
  anchors.push_back(closed("furnace of rectangles", with_eye_inside(quads), furnace_energies()));
  anchors.push_back(closed("furnace of a sphere", with_eye_inside(ball), furnace_energies()));
}

void add_lights_in_a_ball(std::vector<Anchor>& anchors) {
  const Rgb intensity(std::numbers::pi_v<float>);
  const Energies truth{{"LDE", 0.5}, {"LDDE", 0.25}, {"LDDDE", 0.125}};
  Scene point = with_eye_inside(inside_sphere(diffuse(kAlbedo))), spot = point;
  point.point_lights.push_back({.position = {0, 0, 0}, .intensity = intensity});
  spot.spot_lights.push_back({.intensity = intensity, .cutoff_degrees = 180, .falloff_degrees = 180});
  anchors.push_back(closed("point in a ball", point, truth, false));
  anchors.push_back(closed("spot in a ball", spot, truth, false));
}

// ---- A8: a wide floor under what shines evenly, and points under lamps ----------------------------------------------

/// Seen from so near that the horizon lies in the middle of a panoramic picture.
Scene wide_floor() {
  Scene scene;
  add(scene, make_quad({-1000, 0, -1000}, {0, 0, 2000}, {2000, 0, 0}), diffuse(kAlbedo));
  scene.camera = {.position = {0, 1e-3f, 0}, .look_at = {1e-3f, 0, 0}};
  return scene;
}

Anchor over_a_floor(std::string name, Scene scene, double radiance, double sky, bool can_be_hit) {
  Energies all_around{{"LDE", radiance / 2}};
  if (sky > 0) all_around["LE"] = sky / 2;
  return {std::move(name), std::move(scene), {{"LDE", radiance}}, all_around, can_be_hit};
}

void add_skies(std::vector<Anchor>& anchors) {
  Scene distant = wide_floor(), constant = wide_floor(), image = wide_floor();
  distant.distant_lights.push_back({.direction = {1, -2, 0.5f}, .irradiance = Rgb(3)});
  const double cosine = 2 / std::sqrt(1 + 4 + 0.25);
  anchors.push_back(over_a_floor("distant light over a floor", distant, kAlbedo / kPiD * 3 * cosine, 0, false));
  constant.environment = Rgb(2);
  anchors.push_back(over_a_floor("constant sky over a floor", constant, kAlbedo * 2, 2, true));
  // Eight rows of different radiance; those above the horizon light the floor by the squares of their sines.
  constexpr int kRows = 8;
  EnvironmentImage sky{.width = 4, .height = kRows, .interpolation = Interpolation::Nearest};
  double irradiance = 0, mean = 0;
  for (int row = 0; row < kRows; ++row) {
    const float radiance = row == 1 ? 9.0f : 0.5f + static_cast<float>(row);
    sky.pixels.insert(sky.pixels.end(), 4, Rgb(radiance));
    if (row >= kRows / 2) continue;
    const auto squared_sine = [](int r) { return std::pow(std::sin(kPiD * r / kRows), 2); };
    irradiance += static_cast<double>(radiance) * kPiD * (squared_sine(row + 1) - squared_sine(row));
    mean += static_cast<double>(radiance) / (kRows / 2);
  }
  image.environment_image = sky;
  anchors.push_back(over_a_floor("sky image over a floor", image, kAlbedo * irradiance / kPiD, mean, true));
}

void add_form_factors(std::vector<Anchor>& anchors) {
  const auto under = [&](const char* name, Geometry lamp, double form_factor) {
    Scene scene;
    add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(kAlbedo));
    add(scene, std::move(lamp), emitter(2));
    scene.camera = {.position = {2, 0.5f, 2}, .look_at = {0, 0, 0}};
    anchors.push_back({name, std::move(scene), {{"LDE", kAlbedo * 2 * form_factor}}, {}, true});
  };
  constexpr double kSquare = 0.239456471;  // of a unit square above its middle
  under("point under a rectangle", make_quad({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1}), kSquare);
  under("point under triangles",
        Mesh{.positions = {{0, 1, 0}, {-0.5f, 1, -0.5f}, {0.5f, 1, -0.5f}, {0.5f, 1, 0.5f}, {-0.5f, 1, 0.5f}},
             .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}},
        kSquare);
  under("point under a disk", Disk{{0, 2, 0}, {0, -1, 0}, 1}, 1.0 / 5.0);
  under("point under a sphere", Sphere{{0, 2, 0}, 0.5f}, 1.0 / 16.0);
}

// ---- A13: a ball of fog in a constant sky ---------------------------------------------------------------------------

void add_fog(std::vector<Anchor>& anchors) {
  Scene scene;
  scene.media = {{.name = "fog", .scattering = Rgb(1)}};
  add(scene, Sphere{{0, 0, 0}, 1}, {.name = "ball", .interior = Interior{.medium = 0}, .is_index_matched = true});
  scene.environment = Rgb(1);
  scene.camera = {.position = {0, 0, 0}, .look_at = {0, 0, 1}};
  anchors.push_back(closed("middle of a ball of fog", scene, {{"LE", std::exp(-1.0)}}));
}

std::vector<Anchor> all_anchors() {
  std::vector<Anchor> anchors;
  add_furnaces(anchors);
  add_lights_in_a_ball(anchors);
  add_skies(anchors);
  add_form_factors(anchors);
  add_fog(anchors);
  return anchors;
}

// Student's test with 31 degrees of freedom, 1 % over all comparisons of this file after Sidak.
constexpr int kComparisons = 1100;
/// All batches of Sobol points may agree though a stratum is cut by an edge, which one batch in fifty would show.
constexpr double kUnseenByBatches = 1e-4;

/// The grammars are of surfaces. The path tracers scatter at particles as they do at matte walls; the others find
/// nothing there.
bool is_claimed(const AlgorithmFacts& algorithm, taxonomy::Word word) {
  const bool scatters_in_fog = algorithm.id == AlgorithmId::Path || algorithm.id == AlgorithmId::PathHits ||
                               algorithm.id == AlgorithmId::PathNextEvent;
  if (scatters_in_fog) std::ranges::replace(word.events, taxonomy::Symbol::V, taxonomy::Symbol::Dr);
  return taxonomy::builtin_grammars().find(algorithm.grammar)->language.contains(word);
}

int compare(const record::Record& record, const Energies& truth, const AlgorithmFacts& algorithm, bool found,
            const std::string& where) {
  static const double bound = record::student_quantile(1 - 0.005 / kComparisons, record::kBatches - 1);
  int compared = 0;
  for (const taxonomy::Word& word : record.words)
    EXPECT_TRUE(found && is_claimed(algorithm, word)) << where << ": " << taxonomy::fine(word);
  for (const auto& [word, expected] : truth) {
    const record::Estimate e = energy_of(record, word);
    const bool possible = found && is_claimed(algorithm, taxonomy::parse_word(word));
    const double value = possible ? expected : 0;
    EXPECT_NEAR(e.mean, value, bound * e.standard_error + kUnseenByBatches * value)
        << where << ", " << word << ": " << (e.mean - value) / e.standard_error << " standard errors";
    EXPECT_LT(e.standard_error, 0.06 * value + 1e-12) << where << ", " << word << ": too noisy to say anything";
    ++compared;
  }
  return compared;
}

TEST(AnchorMatrix, EightTracersUnderEveryLightToEveryEye) {
  int compared = 0;
  for (const Anchor& anchor : all_anchors())
    for (const AlgorithmId way : kWays) {
      const AlgorithmFacts& algorithm = facts(way);
      if (algorithm.from_light && !anchor.scene.media.empty()) continue;
      const bool is_found = algorithm.reach != Reach::Hit || anchor.can_be_hit;
      for (const EyeKind& eye : kEyes) {
        const Energies& truth = eye.all_around ? anchor.all_around : anchor.truth;
        if (truth.empty()) continue;
        Scene scene = anchor.scene;
        eye.make(scene.camera);
        const record::Record record =
            render(scene, {.algorithm = way, .width = 16, .height = 16, .samples_per_pixel = 64, .max_depth = 5});
        compared += compare(record, truth, algorithm, is_found,
                            anchor.name + ", " + std::string(algorithm.name) + ", " + eye.name);
      }
    }
  EXPECT_EQ(compared, kComparisons);
}

}  // namespace
}  // namespace heckbert::transport
