// Paths traced again are the paths of the record, and their vertices lie where their letters say.

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <heckbert/transport/retrace.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

/// A room with a lamp, a mirror ball, a glass ball and a sky behind an open front; every surface has its name.
Scene room() {
  Scene scene;
  scene.materials = {{.name = "matt", .lobes = {Lambert{Rgb(0.6f)}}},
                     {.name = "mirror", .lobes = {Mirror{Rgb(0.9f)}}},
                     {.name = "glass", .lobes = {Dielectric{.ior = 1.5f}}},
                     {.name = "tube", .lobes = {}, .emission = Rgb(5)}};
  scene.shapes = {{.name = "floor", .geometry = make_quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}), .material = 0},
                  {.name = "wall", .geometry = make_quad({-2, 0, -2}, {4, 0, 0}, {0, 3, 0}), .material = 0},
                  {.name = "mirror", .geometry = Sphere{{-0.8f, 0.6f, 0}, 0.6f}, .material = 1},
                  {.name = "glass", .geometry = Sphere{{0.8f, 0.6f, 0.3f}, 0.6f}, .material = 2},
                  {.name = "lamp", .geometry = make_quad({-1, 3, 1}, {0, 0, -2}, {2, 0, 0}), .material = 3}};
  scene.environment = Rgb(0.2f);
  scene.camera = {.position = {0, 1, 5}, .look_at = {0, 0.7f, 0}};
  return scene;
}

RenderSettings settings_of(AlgorithmId algorithm) {
  return {.algorithm = algorithm,
          .width = 12,
          .height = 9,
          .samples_per_pixel = 32,
          .max_depth = 6,
          .labels = {EventLabels::Object, true}};
}

double distance_to(const std::string& name, glm::vec3 p) {
  if (name == "floor") return std::abs(p.y);
  if (name == "wall") return std::abs(p.z + 2);
  if (name == "mirror") return std::abs(glm::length(p - glm::vec3(-0.8f, 0.6f, 0)) - 0.6f);
  if (name == "glass") return std::abs(glm::length(p - glm::vec3(0.8f, 0.6f, 0.3f)) - 0.6f);
  if (name == "lamp") return std::abs(p.y - 3);
  return 1;
}

class Retrace : public ::testing::TestWithParam<AlgorithmId> {};

TEST_P(Retrace, FindsThePathsOfTheRecord) {
  const Scene scene = room();
  const RenderSettings settings = settings_of(GetParam());
  const record::Record record = render(scene, settings);
  std::size_t paths_seen = 0;
  for (const auto& [x, y] : {std::pair{2, 5}, {6, 4}, {9, 5}, {6, 8}, {0, 0}}) {
    std::map<taxonomy::Word, std::pair<double, std::uint32_t>> found;
    for (const RetracedPath& path : retrace(scene, settings, x, y)) {
      found[path.word].first += static_cast<double>(path.value.g) / settings.samples_per_pixel;
      ++found[path.word].second;
      ++paths_seen;
    }
    ASSERT_EQ(found.size(), record.pixel(x, y).size()) << x << ' ' << y;
    for (const record::Entry& entry : record.pixel(x, y)) {
      const auto& [energy, count] = found.at(record.words[entry.word]);
      EXPECT_EQ(count, entry.count);
      EXPECT_NEAR(energy, entry.energy.g, 1e-6 * static_cast<double>(entry.energy.g));
    }
  }
  EXPECT_GT(paths_seen, 100u);
}

TEST_P(Retrace, PutsEveryVertexOntoTheObjectOfItsLetter) {
  std::size_t through_glass = 0, skies = 0, with_next_event = 0;
  for (const auto& [x, y] : {std::pair{2, 5}, {6, 4}, {9, 5}, {6, 8}})
    for (const RetracedPath& path : retrace(room(), settings_of(GetParam()), x, y)) {
      const std::vector<taxonomy::Letter> letters = letters_of(path.word);
      ASSERT_EQ(path.vertices.size(), letters.size() - 1);  // all but the eye
      for (std::size_t v = 0; v < path.vertices.size(); ++v) {
        const TrailVertex& vertex = path.vertices[v];
        if (letters[v].symbol == taxonomy::Symbol::Le) {
          EXPECT_TRUE(vertex.is_direction);
          EXPECT_NEAR(glm::length(vertex.position), 1, 1e-5);
          ++skies;
        } else {
          EXPECT_FALSE(vertex.is_direction);
          EXPECT_LT(distance_to(letters[v].label, vertex.position), 1e-4) << fine(path.word) << " at " << v;
        }
        through_glass += letters[v].symbol == taxonomy::Symbol::St ? 1 : 0;
      }
      with_next_event += path.technique == record::Technique::NextEvent ? 1 : 0;
      // What the light gives times the way's throughput is what was recorded, but for the weight of the technique.
      const TrailVertex& light = path.vertices.front();
      const float radiance = letters[0].symbol == taxonomy::Symbol::Le ? 0.2f : 5.0f;
      EXPECT_LE(path.value.g, 1.0001f * radiance * light.throughput.g) << fine(path.word);
    }
  EXPECT_GT(through_glass, 10u);
  EXPECT_GT(skies, 10u);
  EXPECT_GT(with_next_event, 10u);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, Retrace, ::testing::Values(AlgorithmId::Path, AlgorithmId::Whitted),
                         [](const auto& test) {
                           return std::string(test.param == AlgorithmId::Path ? "Path" : "Whitted");
                         });

}  // namespace
}  // namespace heckbert::transport
