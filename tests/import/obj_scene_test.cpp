// Wavefront files: the one mapping rule for materials, what is told about it, the camera, and files that are broken.

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/import.h>
#include <heckbert/import/obj_materials.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/transport/material.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

using namespace transport;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// A triangle of the one material "m" with these MTL lines.
Imported with_material(const std::string& mtl) {
  const TemporaryFolder folder;
  folder.write("m.mtl", "newmtl m\n" + mtl);
  return load_scene(folder.write("scene.obj", "mtllib m.mtl\n" + std::string(kTriangle) + "usemtl m\nf 1 2 3\n"));
}

/// One letter per lobe, in order: D Lambert, S mirror, T dielectric, P Phong, G GGX.
std::string letters(const Material& material) {
  std::string out;
  for (const Lobe& lobe : material.lobes) {
    out += "D...ST.G.P"[lobe.index()];
  }
  return out;
}

TEST(ObjMaterial, IllumDecidesTheLobes) {
  const struct {
    const char* mtl;
    const char* lobes;
  } kRows[] = {
      {"Kd .5 .5 .5\n", "D"},
      {"Kd .5 .5 .5\nKs .3 .3 .3\n", "D"},
      {"illum 0\nKd .5 .5 .5\nKs .3 .3 .3\n", "D"},
      {"illum 1\nKd .5 .5 .5\nKs .3 .3 .3\n", "D"},
      {"illum 2\nKd .5 .5 .5\nKs .3 .3 .3\nNs 20\n", "DP"},
      {"illum 2\nKd .5 .5 .5\nKs 0 0 0\nNs 20\n", "D"},
      {"illum 2\nKd 0 0 0\nKs .3 .3 .3\nNs 20\n", "P"},
      {"illum 3\nKd .1 .1 .1\nKs .8 .8 .8\n", "DS"},
      {"illum 5\nKd 0 0 0\nKs .8 .8 .8\n", "S"},
      {"illum 8\nKd 0 0 0\nKs .8 .8 .8\n", "S"},
      {"illum 4\nKd .1 .1 .1\nNi 1.5\n", "T"},
      {"illum 6\nNi 1.5\n", "T"},
      {"illum 7\nKs .3 .3 .3\nTf .1 .1 .1\nNi 1.33\n", "T"},
      {"illum 9\nNi 1.5\n", "T"},
      {"illum 42\nKd .5 .5 .5\nKs .3 .3 .3\nNs 20\n", "DP"},
      {"illum 2\nKd 0 0 0\n", ""},
  };
  for (const auto& row : kRows) {
    EXPECT_EQ(letters(with_material(row.mtl).scene.materials.at(0)), row.lobes) << row.mtl;
  }
}

TEST(ObjMaterial, LobesAreScaledTogetherWhenTheyAddUpToMoreThanOne) {
  const Imported imported = with_material("illum 2\nKd .4 .8 .6\nKs .8 .8 .8\nNs 32\n");
  const Material& m = imported.scene.materials[0];
  EXPECT_FLOAT_EQ(std::get<Lambert>(m.lobes[0]).albedo.r, 0.25f);
  EXPECT_FLOAT_EQ(std::get<Lambert>(m.lobes[0]).albedo.g, 0.5f);
  EXPECT_FLOAT_EQ(std::get<Phong>(m.lobes[1]).reflectance.b, 0.5f);
  EXPECT_FLOAT_EQ(std::get<Phong>(m.lobes[1]).exponent, 32);
  EXPECT_THAT(imported.account.guessed, Contains(HasSubstr("add up to 1.6, both scaled by 0.625")));
}

TEST(ObjMaterial, GlassKeepsOnlyTheHuesOfKsAndTf) {
  const Imported imported = with_material("illum 7\nKd .01 .01 .01\nKs .3 .3 .3\nTf .1 .2 .4\nNi 2.5\n");
  const auto glass = std::get<Dielectric>(imported.scene.materials[0].lobes.at(0));
  EXPECT_EQ(glass.ior, 2.5f);
  EXPECT_EQ(glass.reflection_tint, Rgb(1));
  EXPECT_FLOAT_EQ(glass.transmission_tint.r, 0.25f);
  EXPECT_FLOAT_EQ(glass.transmission_tint.b, 1);
}

TEST(ObjMaterial, WhatIsGuessedOrIgnoredIsTold) {
  const struct {
    const char* mtl;
    const char* guessed;
    const char* ignored;
  } kRows[] = {
      {"illum 7\n", "Ni 1 or missing: index 1.5", ""},
      {"illum 7\nNi 77\n", "Ni 77 is no index of refraction", ""},
      {"illum 7\nNi 1.5\nKd .5 .5 .5\n", "", "Kd 0.5: smooth glass"},
      {"illum 2\nKs .5 .5 .5\nNs 0\n", "Ns 0 or missing", ""},
      {"illum 11\n", "illum 11 is unknown", ""},
      {"Kd 1.5 .5 -1\n", "Kd 1.5 0.5 -1 is not from 0 to 1, read as 1 0.5 0", ""},
      {"Ke 1 2 3\n", "Ke 1 2 3 emits on both sides", ""},
      {"illum 1\nKs .5 .5 .5\n", "", "Ks 0.5: illum 1 has no highlight"},
      {"Kd 1 1 1\nd .5\n", "", "opacity 0.5"},
      {"Kd 1 1 1\nmap_Kd wood.png\n", "", "map_Kd wood.png: textures are not read"},
      {"Kd 1 1 1\nPm 1\n", "", "PBR extension"},
      {"Kd 1 1 1\nKa 1 1 1\n", "", "Ka of 1 material"},
      {"Kd 1 1 1\nsparkle 3\n", "", "sparkle"},
  };
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.mtl);
    const Account account = with_material(row.mtl).account;
    EXPECT_THAT(account.guessed, Contains(HasSubstr(row.guessed)));
    EXPECT_THAT(row.ignored, ::testing::AnyOf(std::string(), ::testing::Truly([&](const std::string& part) {
                                                return std::any_of(account.ignored.begin(), account.ignored.end(),
                                                                   [&](const std::string& line) {
                                                                     return line.find(part) != std::string::npos;
                                                                   });
                                              })))
        << ::testing::PrintToString(account.ignored);
  }
}

TEST(ObjMaterial, EmissionIsALightAndReplacesTheGuessedEnvironment) {
  EXPECT_EQ(with_material("Kd .5 .5 .5\n").scene.environment, Rgb(1));
  const Imported lamp = with_material("Kd .5 .5 .5\nKe 4 4 4\n");
  EXPECT_EQ(lamp.scene.environment, Rgb(0));
  EXPECT_EQ(lamp.scene.materials[0].emission, Rgb(4));
}

TEST(ObjLamp, FlatOnesShineIntoTheSceneAndOthersOnBothSides) {
  const struct {
    const char* faces;
    bool both;
  } kRows[] = {
      {"f 5 6 7 8\n", false},                       // under the ceiling, facing up
      {"f 8 7 6 5\n", false},                       // facing down
      {"f 5 6 7\nf 8 7 5\n", false},                // one triangle each way
      {"f 5 6 7 8\nf 5 6 2 1\n", true},             // a corner of two planes
      {"g a\nf 5 6 7 8\ng b\nf 5 6 2 1\n", false},  // two lamps, each flat
  };
  const TemporaryFolder folder;
  folder.write("m.mtl", "newmtl wall\nKd .5 .5 .5\nnewmtl lamp\nKd .5 .5 .5\nKe 4 4 4\n");
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.faces);
    const Scene scene =
        load_scene(folder.write("room.obj",
                                "mtllib m.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\n"
                                "v -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\nusemtl wall\nf 1 4 3 2\nusemtl lamp\n" +
                                    std::string(row.faces)))
            .scene;
    EXPECT_EQ(scene.materials[1].emission_sides, row.both ? Sides::Both : Sides::Front);
    std::size_t lamps = 0;
    for (const Shape& shape : scene.shapes) {
      const auto& mesh = std::get<Mesh>(shape.geometry);
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 normal = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
        if (mesh.face_materials[i] == 1) {
          ++lamps;
          EXPECT_TRUE(row.both || glm::dot(normal, glm::vec3(0, 1, 0) - a) > 0) << i;
        }
      }
    }
    EXPECT_GE(lamps, 2u);
  }
}

TEST(ObjMaterial, MissingOnesBecomeGreyAndThatIsTold) {
  const TemporaryFolder folder;
  for (const std::string head : {"", "mtllib nowhere.mtl\nusemtl nothing\n"}) {
    const Imported imported = load_scene(folder.write("scene.obj", head + std::string(kTriangle) + "f 1 2 3\n"));
    ASSERT_EQ(imported.scene.materials.size(), 1u);
    EXPECT_EQ(std::get<Lambert>(imported.scene.materials[0].lobes.at(0)).albedo, Rgb(0.7f));
    EXPECT_THAT(imported.account.guessed, Contains(HasSubstr("faces without a known material")));
    EXPECT_EQ(imported.account.ignored.empty(), head.empty());
  }
}

TEST(ObjGeometry, PolygonsNegativeIndicesAndNormalsAreRead) {
  const TemporaryFolder folder;
  const Imported imported =
      load_scene(folder.write("scene.obj",
                              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 2\ng quad\nf -4//1 -3//1 -2//1 -1//-1\n"
                              "v 0 0 5\ng mixed\nf 1//1 2//1 5\ng degenerate\nf 1 1 2\n"));
  ASSERT_EQ(imported.scene.shapes.size(), 2u);
  const auto& quad = std::get<Mesh>(imported.scene.shapes[0].geometry);
  EXPECT_EQ(imported.scene.shapes[0].name, "quad");
  EXPECT_EQ(quad.triangles.size(), 2u);
  ASSERT_EQ(quad.normals.size(), 4u);
  EXPECT_EQ(quad.normals[0], glm::vec3(0, 0, 1));
  EXPECT_THAT(std::get<Mesh>(imported.scene.shapes[1].geometry).normals, IsEmpty());
  EXPECT_THAT(imported.account.ignored, Contains(HasSubstr("1 triangle without area")));
}

TEST(ObjGeometry, BrokenLinesAreErrorsWithTheirPlaces) {
  const struct {
    const char* text;
    std::size_t line, column;
    const char* message;
  } kRows[] = {
      {"v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 1, 1, "expected three numbers, found 2"},
      {"v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", 2, 5, "expected a number"},
      {"v 0 0 0\nv 1 inf 0\nv 0 1 0\nf 1 2 3\n", 2, 5, "expected a number"},
      {"v 0 0 0\nv 1 1e300 0\nv 0 1 0\nf 1 2 3\n", 2, 5, "expected a number"},
      {"v 0 0 0\nv 1 x 0\nv 0 1 0\nf 1 2 3\n", 2, 5, "expected a number"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", 4, 7, "there is no position 4: the file has 3"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", 4, 7, "there is no position 0"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", 4, 7, "there is no position -4"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3//9\n", 4, 7, "there is no normal 9: the file has 0"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 a\n", 4, 7, "expected a corner"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3/1/1/1\n", 4, 7, "expected a corner"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", 4, 7, "expected a corner"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\n  f 1 2\n", 4, 3, "at least three corners, found 2"},
      {"", 0, 0, "no triangles that have an area"},
      {"# only words\n", 0, 0, "no triangles that have an area"},
      {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", 0, 0, "no triangles that have an area"},
  };
  const TemporaryFolder folder;
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.text);
    try {
      load_scene(folder.write("broken.obj", row.text));
      ADD_FAILURE() << "was read";
    } catch (const InputError& error) {
      ASSERT_EQ(error.diagnostics().size(), 1u) << error.what();
      EXPECT_EQ(error.diagnostics()[0].line, row.line);
      EXPECT_EQ(error.diagnostics()[0].column, row.column);
      EXPECT_THAT(error.diagnostics()[0].message, HasSubstr(row.message));
    }
  }
}

TEST(ObjGeometry, EveryTruncationIsReadOrRefusedButNeverACrash) {
  const std::string text =
      "mtllib m.mtl\ng a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nusemtl m\nf 1/1/1 2/1/1 3/1/1\nf -1 -2 -3\n";
  const TemporaryFolder folder;
  folder.write("m.mtl", "newmtl m\nKd .5 .5");
  std::size_t read = 0;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    try {
      load_scene(folder.write("cut.obj", text.substr(0, length)));
      ++read;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(read, 0u);
}

TEST(ObjCamera, LooksIntoTheOpenEnd) {
  // A room of five walls; `open` is the z of the missing one.
  for (const float open : {-1.0f, 1.0f}) {
    const std::string wall = open > 0 ? "f 1 2 3 4\n" : "f 5 6 7 8\n";
    const TemporaryFolder folder;
    const Scene scene =
        load_scene(folder.write("room.obj",
                                "v -1 0 -1\nv 1 0 -1\nv 1 2 -1\nv -1 2 -1\nv -1 0 1\nv 1 0 1\nv 1 2 1\nv -1 2 1\n"
                                "f 1 2 6 5\nf 4 3 7 8\nf 1 4 8 5\nf 2 3 7 6\n" +
                                    wall))
            .scene;
    EXPECT_EQ(scene.camera.look_at, glm::vec3(0, 1, 0));
    EXPECT_GT(scene.camera.position.z * open, 1);
    // The near face just fills the height: half of it over the distance is the tangent of half the angle, and a margin.
    const float distance = std::abs(scene.camera.position.z) - 1;
    EXPECT_NEAR(1.02f / distance, std::tan(scene.camera.vertical_fov_degrees * 3.14159265f / 360), 1e-4f);
  }
}

// ---- real files
// --------------------------------------------------------------------------------------------------------

const std::filesystem::path kBoxes = kSourceDir.parent_path() / "shared/scenes/mcguire-cornell";

/// The letters of all materials that a triangle is made of, each letter once.
std::string used_letters(const Scene& scene) {
  std::set<char> out;
  for (const Shape& shape : scene.shapes) {
    for (const std::uint32_t material : std::get<Mesh>(shape.geometry).face_materials) {
      for (const char letter : letters(scene.materials.at(material))) {
        out.insert(letter);
      }
    }
  }
  return {out.begin(), out.end()};
}

TEST(McGuireBoxes, HaveTheLobesThatTheirNamesPromise) {
  if (!std::filesystem::exists(kBoxes)) {
    GTEST_SKIP() << "NOT TESTED: there is no " << kBoxes;
  }
  const struct {
    const char* name;
    const char* letters;
    Rgb lamp;
  } kRows[] = {{"Original", "D", {17, 12, 4}}, {"Mirror", "DS", {17, 12, 4}}, {"Glossy", "DP", Rgb(10)},
               {"Sphere", "DST", Rgb(10)},     {"Water", "DST", Rgb(10)},     {"Empty-CO", "D", Rgb(10)},
               {"Empty-RG", "D", {17, 12, 4}}, {"Empty-White", "D", Rgb(10)}, {"Empty-Squashed", "D", Rgb(10)}};
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kBoxes)) {
    files += entry.path().extension() == ".obj" ? 1 : 0;
  }
  EXPECT_EQ(files, std::size(kRows)) << "a box that the table does not name";
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.name);
    const Imported imported = load_scene(kBoxes / ("CornellBox-" + std::string(row.name) + ".obj"));
    const Scene& scene = imported.scene;
    EXPECT_EQ(used_letters(scene), row.letters);
    const auto lamp = std::find_if(scene.materials.begin(), scene.materials.end(),
                                   [](const Material& m) { return !is_black(m.emission); });
    ASSERT_NE(lamp, scene.materials.end());
    EXPECT_EQ(lamp->name, "light");
    EXPECT_EQ(lamp->emission, row.lamp);
    EXPECT_EQ(lamp->emission_sides, Sides::Front);
    EXPECT_EQ(scene.environment, Rgb(0));
    EXPECT_GT(scene.camera.position.z, 3) << "the boxes are open towards +z";
    EXPECT_THAT(imported.account.guessed, Contains(HasSubstr("no camera")));
    for (const Material& material : scene.materials) {
      EXPECT_LE(max_channel(max_albedo(material)), 1.0001f) << material.name;
    }
  }
}

}  // namespace
}  // namespace heckbert::import
