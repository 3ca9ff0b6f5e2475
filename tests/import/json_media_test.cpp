// Media and bodies in the native format.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/import/import.h>
#include <heckbert/taxonomy/error.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

using namespace transport;

Scene read(const std::string& keys, const std::string& material) {
  return read_json_scene(R"({ "camera": { "position": [0, 1, 4], "look_at": [0, 0, 0] }, "environment": 1, )" + keys +
                             R"( "materials": [ { "name": "m", )" + material + R"( } ],
    "shapes": [ { "type": "sphere", "material": "m", "center": [0, 0, 0], "radius": 1 } ] })",
                         "test", ".")
      .scene;
}

constexpr const char* kMedia = R"("media": [ { "name": "ink", "absorption": [1, 2, 3] },
  { "name": "fog", "scattering": 0.5, "anisotropy": -0.25 } ],)";

TEST(JsonMedia, FillBodiesAndTheScene) {
  const Scene scene = read(std::string(kMedia) + R"("medium": "fog",)",
                           R"("type": "dielectric", "ior": 1.33, "medium": "ink", "priority": 3)");
  ASSERT_EQ(scene.media.size(), 2u);
  EXPECT_EQ(scene.media[0].absorption, Rgb(1, 2, 3));
  EXPECT_EQ(scene.media[0].scattering, Rgb(0));
  EXPECT_EQ(scene.media[1].scattering, Rgb(0.5f));
  EXPECT_EQ(scene.media[1].anisotropy, -0.25f);
  EXPECT_EQ(scene.medium, std::optional<std::uint32_t>(1));
  const Material& material = scene.materials.at(0);
  ASSERT_TRUE(material.interior);
  EXPECT_EQ(material.interior->medium, std::optional<std::uint32_t>(0));
  EXPECT_EQ(material.interior->priority, 3);
  EXPECT_FALSE(material.is_index_matched);
}

TEST(JsonMedia, ABoundaryNeedsNoLobesAndAPriorityAloneMakesABody) {
  const Material boundary = read(kMedia, R"("index_matched": true, "medium": "fog")").materials.at(0);
  EXPECT_TRUE(boundary.is_index_matched);
  EXPECT_TRUE(boundary.lobes.empty());
  const Material body = read("", R"("type": "dielectric", "priority": 2)").materials.at(0);
  ASSERT_TRUE(body.interior);
  EXPECT_FALSE(body.interior->medium);
  EXPECT_FALSE(read("", R"("type": "dielectric")").materials.at(0).interior);
}

TEST(JsonMedia, ErrorsPointAtTheCulprit) {
  const struct {
    std::string keys, material, message;
  } rows[] = {
      {kMedia, R"("type": "dielectric", "medium": "imk")", "there is no medium \"imk\""},
      {std::string(kMedia) + R"("medium": "snow",)", R"("type": "dielectric")", "there is no medium \"snow\""},
      {kMedia, R"("type": "mirror", "reflectance": 1, "index_matched": true)",
       "an index-matched boundary has no lobes"},
      {R"("media": [ { "name": "fog", "scattering": -1 } ],)", R"("type": "dielectric")", "found -1"},
      {R"("media": [ { "name": "fog", "anisotropy": 1 } ],)", R"("type": "dielectric")", "from -0.999 to 0.999"},
      {R"("media": [ { "name": "a" }, { "name": "a" } ],)", R"("type": "dielectric")", "two mediums"},
  };
  for (const auto& row : rows) {
    try {
      read(row.keys, row.material);
      ADD_FAILURE() << "accepted: " << row.keys << row.material;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(row.message));
    }
  }
}

}  // namespace
}  // namespace heckbert::import
