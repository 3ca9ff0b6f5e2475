// The built-in scenes are what a newcomer sees first: they load, and nothing about them is guessed.

#include <algorithm>

#include <glm/geometric.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/import.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const BuiltinScene& scene : builtin_scenes()) {
    out.emplace_back(scene.name);
  }
  return out;
}

TEST(BuiltinScenes, AreThoseOfTheScenesFolder) {
  EXPECT_THAT(names(), ElementsAre("caustic-point", "caustic", "cornell-balls", "cornell", "door", "furnace", "lantern",
                                   "lecture"));
}

TEST(BuiltinScenes, LoadWithNothingGuessedOrIgnored) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    SCOPED_TRACE(builtin.name);
    const Imported imported = load_scene_or_builtin(std::string(builtin.name));
    EXPECT_EQ(imported.scene.name, builtin.name);
    EXPECT_EQ(imported.scene.title, builtin.title);
    EXPECT_THAT(imported.account.guessed, IsEmpty());
    EXPECT_THAT(imported.account.ignored, IsEmpty());
    EXPECT_FALSE(imported.account.understood.empty());
    EXPECT_EQ(imported.scene.defaults.width, 512);
    EXPECT_EQ(imported.scene.defaults.height, 512);
  }
}

TEST(BuiltinScenes, UnknownNameSuggestsTheNearest) {
  try {
    load_scene_or_builtin("cornel");
    FAIL() << "loaded a scene that is not there";
  } catch (const ReadError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"cornell\"?"));
  }
}

/// The nth corner of a shape, by the shape's name.
glm::vec3 corner(const transport::Scene& scene, const std::string& name, std::size_t index) {
  const auto shape =
      std::find_if(scene.shapes.begin(), scene.shapes.end(), [&](const transport::Shape& s) { return s.name == name; });
  return std::get<transport::Mesh>(shape->geometry).positions.at(index);
}

float area(const transport::Mesh& mesh) {
  float sum = 0;
  for (const glm::uvec3 t : mesh.triangles) {
    const glm::vec3 a = mesh.positions[t.x];
    sum += glm::length(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a)) / 2;
  }
  return sum;
}

TEST(Cornell, HasTheMeasuredCornersAndALampThatFillsTheHole) {
  const transport::Scene scene = load_scene_or_builtin("cornell").scene;
  EXPECT_EQ(corner(scene, "back wall", 3), glm::vec3(556.0f, 548.8f, 559.2f));
  EXPECT_EQ(corner(scene, "short block", 3), glm::vec3(290, 165, 114));
  EXPECT_EQ(corner(scene, "tall block", 2), glm::vec3(314, 330, 456));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(corner(scene, "lamp", i), corner(scene, "ceiling", i + 4));
  }
  const auto& ceiling = std::get<transport::Mesh>(scene.shapes[1].geometry);
  EXPECT_FLOAT_EQ(area(ceiling), 556.0f * 559.2f - 130.0f * 105.0f);
}

}  // namespace
}  // namespace heckbert::import
