// Mitsuba's XML: what each element becomes, both spellings of names, and what is told about the rest.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/import.h>
#include <heckbert/import/mitsuba_reader.h>
#include <heckbert/import/spectrum_colour.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/transport/texture.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

using namespace transport;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Imported scene_of(const std::string& body, const std::string& version = "3.0.0") {
  const TemporaryFolder folder;
  return load_scene(folder.write("room.xml", "<scene version=\"" + version + "\">\n" + body + "\n</scene>\n"));
}

const std::string kSphere = "<shape type=\"sphere\"/>";

Material material_of(const std::string& bsdf, const std::string& version = "3.0.0") {
  const Imported imported = scene_of("<shape type=\"sphere\">" + bsdf + "</shape>", version);
  return imported.scene.materials.at(imported.scene.shapes.at(0).material);
}

template <class LobeType>
LobeType only_lobe(const std::string& bsdf, const std::string& version = "3.0.0") {
  const Material material = material_of(bsdf, version);
  EXPECT_EQ(material.lobes.size(), 1u) << bsdf;
  return std::get<LobeType>(material.lobes.at(0));
}

Shape shape_of(const std::string& shape) {
  return scene_of(shape).scene.shapes.at(0);
}

void expect_near(glm::vec3 a, glm::vec3 b, const std::string& what = {}) {
  EXPECT_LT(glm::length(a - b), 1e-5f) << what << ": " << a.x << " " << a.y << " " << a.z << ", expected " << b.x << " "
                                       << b.y << " " << b.z;
}

glm::vec3 face_normal(const Mesh& mesh, std::size_t triangle = 0) {
  const glm::uvec3 t = mesh.triangles.at(triangle);
  const glm::vec3 a = mesh.positions[t.x];
  return glm::normalize(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
}

// ---- the document ---------------------------------------------------------------------------------------------------

TEST(MitsubaDocument, DefaultsReplaceParametersAndFilesOverruleThoseTheyInclude) {
  const TemporaryFolder folder;
  folder.write("part.xml",
               "<scene version=\"3.0.0\"><default name=\"r\" value=\"7\"/>"
               "<shape type=\"sphere\"><float name=\"radius\" value=\"$r\"/></shape></scene>");
  const Imported imported = load_scene(
      folder.write("room.xml",
                   "<scene version=\"3.0.0\"><default name=\"r\" value=\"2\"/><default name=\"kind\" value=\"sphere\"/>"
                   "<shape type=\"$kind\"><float name=\"radius\" value=\"1$r.5\"/></shape>"
                   "<include filename=\"part.xml\"/></scene>"));
  ASSERT_EQ(imported.scene.shapes.size(), 2u);
  EXPECT_EQ(std::get<Sphere>(imported.scene.shapes[0].geometry).radius, 12.5f);
  EXPECT_EQ(std::get<Sphere>(imported.scene.shapes[1].geometry).radius, 2);
}

TEST(MitsubaDocument, NamesOfEitherSpellingAreTheSame) {
  EXPECT_EQ(snake_case("toWorld"), "to_world");
  EXPECT_EQ(snake_case("intIOR"), "int_ior");
  EXPECT_EQ(snake_case("int_ior"), "int_ior");
  EXPECT_EQ(snake_case("rrDepth"), "rr_depth");
  EXPECT_EQ(snake_case("lookAt"), "look_at");
}

TEST(MitsubaDocument, WhatIsNotUnderstoodIsToldWithFileAndLine) {
  const struct {
    const char* body;
    const char* ignored;
  } kRows[] = {
      {"\n<shape type=\"hair\"/>", "room.xml:3: shape \"hair\" is not known: left out"},
      {"<shape type=\"spere\"/>", "shape \"spere\" is not known (did you mean \"sphere\"?): left out"},
      {"<shape type=\"sphere\">\n\n<bsdf type=\"irawan\"/></shape>",
       "room.xml:4: bsdf \"irawan\" is not known: read as grey"},
      {"<emitter type=\"sky\"/>", "emitter \"sky\" is not known: left out"},
      {"<mode type=\"final\"/>", "<mode> is not read"},
      {"<shape type=\"cube\"><float name=\"raduis\" value=\"2\"/></shape>", "shape \"cube\": \"raduis\" is not read"},
      {"<shape type=\"sphere\"><float name=\"raduis\" value=\"2\"/></shape>", "did you mean \"radius\"?"},
      {"<shape type=\"sphere\"><hide id=\"x\"/></shape>", "shape \"sphere\": <hide> is not read"},
      {"<integrator type=\"path\"><integer name=\"rrDepth\" value=\"5\"/></integrator>", "\"rr_depth\" is not read"},
      {"<sensor type=\"perspective\"/><sensor type=\"perspective\"/>", "<sensor>: only the first is read"},
  };
  for (const auto& row : kRows) {
    EXPECT_THAT(scene_of(kSphere + row.body).account.ignored, Contains(HasSubstr(row.ignored))) << row.body;
  }
}

TEST(MitsubaDocument, AWholeSceneOfKnownThingsIgnoresNothing) {
  const Imported imported = scene_of(R"(
    <integrator type="path"><integer name="max_depth" value="6"/></integrator>
    <sensor type="perspective"><float name="fov" value="30"/>
      <sampler type="independent"><integer name="sample_count" value="7"/></sampler>
      <film type="hdrfilm"><integer name="width" value="30"/><integer name="height" value="20"/>
        <string name="pixel_format" value="rgb"/><rfilter type="tent"/></film></sensor>
    <bsdf type="twosided" id="wall"><bsdf type="diffuse"/></bsdf>
    <shape type="sphere"><ref id="wall"/><emitter type="area"><rgb name="radiance" value="1, 2, 3"/></emitter></shape>)");
  EXPECT_THAT(imported.account.ignored, IsEmpty());
  EXPECT_THAT(imported.account.guessed, IsEmpty());
  EXPECT_EQ(imported.scene.defaults.max_depth, 5) << "segments are one more than scatterings";
  EXPECT_EQ(imported.scene.defaults.samples_per_pixel, 7);
  EXPECT_EQ(imported.scene.defaults.width, 30);
  EXPECT_EQ(imported.scene.defaults.height, 20);
  EXPECT_EQ(imported.scene.defaults.filter->kind, FilterKind::Tent);
  EXPECT_EQ(imported.scene.defaults.filter->radius, 1);
  EXPECT_EQ(imported.scene.materials.at(imported.scene.shapes.at(0).material).emission, Rgb(1, 2, 3));
}

TEST(MitsubaIntegrator, CountsSegmentsAndWeScatterings) {
  const auto depth = [](const std::string& body) { return scene_of(kSphere + body).scene.defaults.max_depth; };
  EXPECT_EQ(depth("<integrator type=\"path\"><integer name=\"maxDepth\" value=\"1\"/></integrator>"), 0);
  EXPECT_EQ(depth("<integrator type=\"path\"><integer name=\"max_depth\" value=\"65\"/></integrator>"), 64);
  EXPECT_EQ(depth("<integrator type=\"path\"/>"), 1000);
  EXPECT_EQ(depth("<integrator type=\"direct\"/>"), 1);
  EXPECT_EQ(depth("<integrator type=\"aov\"><integrator type=\"path\"><integer name=\"max_depth\" value=\"3\"/>"
                  "</integrator></integrator>"),
            2);
}

// ---- colours --------------------------------------------------------------------------------------------------------

TEST(MitsubaColour, IsReadFromEveryNotation) {
  const struct {
    const char* node;
    Rgb expected;
  } kRows[] = {
      {"<rgb name=\"reflectance\" value=\"0.1, 0.2, 0.3\"/>", {0.1f, 0.2f, 0.3f}},
      {"<rgb name=\"reflectance\" value=\"0.1 0.2 0.3\"/>", {0.1f, 0.2f, 0.3f}},
      {"<rgb name=\"reflectance\" value=\"0.25\"/>", Rgb(0.25f)},
      {"<rgb name=\"reflectance\" value=\"#ff0033\"/>", {1, 0, 0.2f}},
      {"<srgb name=\"reflectance\" value=\"0.5, 1, 0\"/>", {0.21404f, 1, 0}},
      {"<srgb name=\"reflectance\" value=\"#8000ff\"/>", {0.21586f, 0, 1}},
      {"<spectrum name=\"reflectance\" value=\"0.7\"/>", Rgb(0.7f)},
      {"<spectrum name=\"reflectance\" value=\"300:0.7, 900:0.7\"/>", Rgb(0.7f)},
      {"<float name=\"reflectance\" value=\"0.7\"/>", Rgb(0.7f)},
  };
  for (const auto& row : kRows) {
    const auto lobe = only_lobe<Lambert>(std::string("<bsdf type=\"diffuse\">") + row.node + "</bsdf>");
    EXPECT_NEAR(lobe.albedo.r, row.expected.r, 1e-5) << row.node;
    EXPECT_NEAR(lobe.albedo.g, row.expected.g, 1e-5) << row.node;
    EXPECT_NEAR(lobe.albedo.b, row.expected.b, 1e-5) << row.node;
  }
}

// Black bodies run from red to blue, halves of white add up to white, and Planck's law at 5000 K and 560 nm, where
// green is seen, gives 1.276e4 W sr^-1 m^-2 nm^-1.
TEST(SpectrumColour, FollowsTheObserver) {
  const Rgb warm = blackbody_colour(2856), cold = blackbody_colour(9000);
  EXPECT_GT(warm.r, 2 * warm.b);
  EXPECT_GT(cold.b, 1.2f * cold.r);
  const Rgb falling = colour_of({{360, 1}, {830, 0}}), rising = colour_of({{360, 0}, {830, 1}});
  EXPECT_NEAR(falling.r + rising.r, 1, 1e-5);
  EXPECT_NEAR(falling.g + rising.g, 1, 1e-5);
  EXPECT_NEAR(falling.b + rising.b, 1, 1e-5);
  EXPECT_GT(rising.r, 1.2f * rising.g);
  EXPECT_GT(rising.g, 1.2f * rising.b);
  EXPECT_NEAR(blackbody_colour(5000).g, 1.276e4, 0.02e4);
}

// ---- BSDFs ----------------------------------------------------------------------------------------------------------

TEST(MitsubaBsdf, ReflectsOnBothSidesAndSaysWhereMitsubaDoesNot) {
  for (const char* bsdf : {"<bsdf type=\"diffuse\"/>", "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/></bsdf>",
                           "<bsdf type=\"dielectric\"/>"}) {
    const Imported imported = scene_of(std::string("<shape type=\"sphere\">") + bsdf + "</shape>");
    EXPECT_EQ(imported.scene.materials.at(0).lobe_sides, Sides::Both) << bsdf;
    const auto told = Contains(HasSubstr("1 bsdf outside \"twosided\""));
    if (std::string_view(bsdf).starts_with("<bsdf type=\"diffuse\"")) {
      EXPECT_THAT(imported.account.guessed, told);
    } else {
      EXPECT_THAT(imported.account.guessed, Not(told)) << bsdf;
    }
  }
}

TEST(MitsubaBsdf, GlassHasTheIndexOfItsTwoMedia) {
  EXPECT_FLOAT_EQ(only_lobe<Dielectric>("<bsdf type=\"dielectric\"/>").ior, 1.5046f / 1.000277f);
  EXPECT_FLOAT_EQ(only_lobe<Dielectric>("<bsdf type=\"dielectric\"><float name=\"intIOR\" value=\"1.8\"/>"
                                        "<float name=\"extIOR\" value=\"1.2\"/></bsdf>")
                      .ior,
                  1.5f);
  EXPECT_FLOAT_EQ(only_lobe<Dielectric>("<bsdf type=\"dielectric\"><string name=\"int_ior\" value=\"water\"/>"
                                        "<string name=\"ext_ior\" value=\"vacuum\"/></bsdf>")
                      .ior,
                  1.333f);
  EXPECT_FLOAT_EQ(only_lobe<ThinDielectric>("<bsdf type=\"thindielectric\"><float name=\"int_ior\" value=\"1.7\"/>"
                                            "<float name=\"ext_ior\" value=\"1\"/></bsdf>")
                      .ior,
                  1.7f);
}

TEST(MitsubaBsdf, MetalsHaveTheirFresnelAndFacets) {
  const auto lobe = only_lobe<MicrofacetReflection>(
      "<bsdf type=\"roughconductor\"><float name=\"alpha\" value=\"0.25\"/><rgb name=\"eta\" value=\"1, 2, 3\"/>"
      "<rgb name=\"k\" value=\"4, 5, 6\"/><rgb name=\"specular_reflectance\" value=\"0.3\"/></bsdf>");
  EXPECT_EQ(lobe.facets.distribution, Microfacets::Distribution::Beckmann) << "Mitsuba's default";
  EXPECT_EQ(lobe.facets.alpha_x, 0.25f);
  EXPECT_EQ(lobe.facets.alpha_y, 0.25f);
  EXPECT_EQ(lobe.tint, Rgb(0.3f));
  EXPECT_EQ(std::get<ConductorFresnel>(lobe.fresnel).eta, Rgb(1, 2, 3));
  EXPECT_EQ(std::get<ConductorFresnel>(lobe.fresnel).k, Rgb(4, 5, 6));
  const auto brushed = only_lobe<MicrofacetReflection>(
      "<bsdf type=\"roughconductor\"><string name=\"distribution\" value=\"ggx\"/><float name=\"alphaU\" "
      "value=\"0.1\"/>"
      "<float name=\"alphaV\" value=\"0.3\"/><string name=\"material\" value=\"Au\"/></bsdf>",
      "0.5.0");
  EXPECT_EQ(brushed.facets.distribution, Microfacets::Distribution::Ggx);
  EXPECT_EQ(brushed.facets.alpha_x, 0.1f);
  EXPECT_EQ(brushed.facets.alpha_y, 0.3f);
  EXPECT_LT(std::get<ConductorFresnel>(brushed.fresnel).eta.r, 0.2f) << "gold";
  EXPECT_EQ(
      std::get<Rgb>(
          only_lobe<Mirror>("<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/></bsdf>").fresnel),
      Rgb(1));
}

TEST(MitsubaBsdf, PlasticIsACoatOverABase) {
  const Material m = material_of(
      "<bsdf type=\"roughplastic\"><rgb name=\"diffuse_reflectance\" value=\"0.1, 0.2, 0.3\"/>"
      "<float name=\"int_ior\" value=\"1.9\"/><float name=\"ext_ior\" value=\"1\"/><float name=\"alpha\" "
      "value=\"0.2\"/>"
      "<boolean name=\"nonlinear\" value=\"true\"/></bsdf>");
  const auto base = std::find_if(m.lobes.begin(), m.lobes.end(),
                                 [](const Lobe& lobe) { return std::holds_alternative<CoatedDiffuse>(lobe); });
  ASSERT_NE(base, m.lobes.end());
  const auto& coated = std::get<CoatedDiffuse>(*base);
  EXPECT_EQ(coated.albedo, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(coated.coat.ior, 1.9f);
  EXPECT_EQ(coated.coat.alpha, 0.2f);
  EXPECT_FALSE(coated.linear);
  EXPECT_TRUE(std::any_of(m.lobes.begin(), m.lobes.end(),
                          [](const Lobe& lobe) { return std::holds_alternative<MicrofacetReflection>(lobe); }));
}

TEST(MitsubaBsdf, MixturesWeighTheirParts) {
  const Material m = material_of(
      "<bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"0.25\"/>"
      "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.8\"/></bsdf>"
      "<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/></bsdf></bsdf>");
  ASSERT_EQ(m.lobes.size(), 2u);
  EXPECT_FLOAT_EQ(std::get<Lambert>(m.lobes[0]).albedo.r, 0.6f);
  EXPECT_FLOAT_EQ(std::get<Mirror>(m.lobes[1]).tint.r, 0.25f);
  const Imported masked = scene_of(
      "<shape type=\"sphere\"><bsdf type=\"mask\"><float name=\"opacity\" value=\"0.3\"/><bsdf "
      "type=\"diffuse\"/></bsdf>"
      "</shape>");
  const Material& mask = masked.scene.materials.at(masked.scene.shapes.at(0).material);
  ASSERT_TRUE(mask.opacity);
  EXPECT_EQ(std::get<Checkerboard>(masked.scene.textures.at(mask.opacity->texture).source).second, Rgb(0.3f));
}

TEST(MitsubaBsdf, IsSharedByTheShapesThatReferToIt) {
  const Imported imported = scene_of(
      "<bsdf type=\"diffuse\" id=\"a\"/><shape type=\"cube\"><ref id=\"a\"/></shape>"
      "<shape type=\"sphere\"><ref id=\"a\"/></shape>");
  EXPECT_EQ(imported.scene.materials.size(), 1u);
  EXPECT_EQ(imported.scene.materials[0].name, "a");
}

TEST(MitsubaTexture, ChecksAreScaledAndMultiplyTheLobe) {
  const Imported imported = scene_of(
      "<shape type=\"rectangle\"><bsdf type=\"diffuse\"><texture type=\"checkerboard\" name=\"reflectance\">"
      "<rgb name=\"color0\" value=\"0.1\"/><rgb name=\"color1\" value=\"0.9\"/>"
      "<transform name=\"to_uv\"><scale x=\"4\" y=\"2\"/></transform></texture></bsdf></shape>");
  ASSERT_EQ(imported.scene.textures.size(), 1u);
  EXPECT_EQ(imported.scene.textures[0].scale, glm::vec2(4, 2));
  EXPECT_EQ(std::get<Checkerboard>(imported.scene.textures[0].source).first, Rgb(0.1f));
  const Material& m = imported.scene.materials.at(0);
  ASSERT_EQ(m.textures.size(), 1u);
  EXPECT_EQ(m.textures[0].parameter, LobeTexture::Parameter::Colour);
  EXPECT_EQ(std::get<Lambert>(m.lobes[0]).albedo, Rgb(1));
}

// v runs downwards in Mitsuba's pictures; OBJ files, whose v runs upwards, are turned round when they are read.
TEST(MitsubaTexture, PicturesStandUpright) {
  const TemporaryFolder folder;
  // Two rows of one pixel, TGA without compression, from the top: red above blue.
  folder.write("two.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\2\0\x18\x20\0\0\xff\xff\0\0", 24));
  const Imported imported = load_scene(folder.write(
      "room.xml",
      "<scene version=\"3.0.0\"><shape type=\"rectangle\"><bsdf type=\"diffuse\"><texture type=\"bitmap\" "
      "name=\"reflectance\"><string name=\"filename\" value=\"two.tga\"/></texture></bsdf></shape></scene>"));
  const Texture& texture = imported.scene.textures.at(0);
  const auto at = [&](float v) { return look_up(texture, glm::vec2(0.5f, v)); };
  EXPECT_GT(at(0.25f).r, at(0.25f).b) << "the top";
  EXPECT_GT(at(0.75f).b, at(0.75f).r) << "the bottom";
}

TEST(MitsubaTexture, LampsMayHaveOne) {
  const std::string body = R"(<shape type="disk"><emitter type="area"><texture type="checkerboard" name="radiance">
      <rgb name="color0" value="3"/><rgb name="color1" value="1"/></texture></emitter></shape>)";
  const Imported imported = scene_of(body);
  const Material& lamp = imported.scene.materials.at(imported.scene.shapes.at(0).material);
  EXPECT_EQ(lamp.emission, Rgb(1));
  ASSERT_TRUE(lamp.emission_texture);
  EXPECT_EQ(std::get<Checkerboard>(imported.scene.textures.at(*lamp.emission_texture).source).first, Rgb(3));
  EXPECT_THAT(imported.account.ignored, IsEmpty());
  EXPECT_THAT(imported.account.understood, Contains(HasSubstr("shape \"disk\" emits a texture")));
}

// ---- shapes ---------------------------------------------------------------------------------------------------------

TEST(MitsubaShape, TransformsApplyInTheOrderOfTheText) {
  const auto sphere = std::get<Sphere>(
      shape_of(
          "<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"0\" z=\"0\"/><float name=\"radius\" value=\"2\"/>"
          "<transform name=\"to_world\"><rotate z=\"1\" angle=\"90\"/><scale value=\"3\"/>"
          "<translate x=\"10\"/></transform></shape>")
          .geometry);
  expect_near(sphere.center, {10, 3, 0});
  EXPECT_NEAR(sphere.radius, 6, 1e-5);
}

TEST(MitsubaShape, FrontsLieWhereMitsubaHasThem) {
  const auto mesh = [](const std::string& shape) { return std::get<Mesh>(shape_of(shape).geometry); };
  expect_near(face_normal(mesh("<shape type=\"rectangle\"/>")), {0, 0, 1}, "rectangle");
  expect_near(face_normal(mesh("<shape type=\"rectangle\"><boolean name=\"flip_normals\" value=\"true\"/></shape>")),
              {0, 0, -1}, "flipped");
  expect_near(face_normal(mesh("<shape type=\"rectangle\"><transform name=\"to_world\"><scale x=\"-1\"/></transform>"
                               "</shape>")),
              {0, 0, 1}, "mirrored");
  expect_near(std::get<Disk>(shape_of("<shape type=\"disk\"><transform name=\"to_world\"><rotate x=\"1\" angle=\"90\"/>"
                                      "</transform></shape>")
                                 .geometry)
                  .normal,
              {0, -1, 0}, "disk");
  for (const char* closed :
       {"<shape type=\"cube\"/>",
        "<shape type=\"sphere\"><transform name=\"to_world\"><scale x=\"2\"/></transform></shape>"}) {
    const Mesh m = mesh(closed);
    for (std::size_t i = 0; i < m.triangles.size(); ++i) {
      EXPECT_GT(glm::dot(face_normal(m, i),
                         m.positions[m.triangles[i].x] + m.positions[m.triangles[i].y] + m.positions[m.triangles[i].z]),
                0)
          << closed;
    }
  }
  const Mesh tube = mesh("<shape type=\"cylinder\"><point name=\"p1\" x=\"0\" y=\"2\" z=\"0\"/></shape>");
  for (std::size_t i = 0; i < tube.triangles.size(); ++i) {
    const glm::vec3 p = tube.positions[tube.triangles[i].x];
    EXPECT_GT(glm::dot(face_normal(tube, i), glm::vec3(p.x, 0, p.z)), 0);
  }
}

TEST(MitsubaShape, FilesWithoutNormalsAreSmoothUnlessFacesAreAskedFor) {
  const TemporaryFolder folder;
  folder.write("roof.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\nf 1 2 3 4\nf 2 5 6 3\n");
  const auto mesh = [&](const std::string& extra) {
    return std::get<Mesh>(load_scene(folder.write("room.xml",
                                                  "<scene version=\"3.0.0\"><shape type=\"obj\">"
                                                  "<string name=\"filename\" value=\"roof.obj\"/>" +
                                                      extra + "</shape></scene>"))
                              .scene.shapes.at(0)
                              .geometry);
  };
  const Mesh smooth = mesh("");
  ASSERT_EQ(smooth.normals.size(), smooth.positions.size());
  for (std::size_t i = 0; i < smooth.positions.size(); ++i) {
    if (smooth.positions[i].x == 1 && smooth.positions[i].z == 0) {
      expect_near(smooth.normals[i], glm::normalize(glm::vec3(1, 0, 1)), "on the ridge");
    }
  }
  EXPECT_THAT(mesh("<boolean name=\"face_normals\" value=\"true\"/>").normals, IsEmpty());
}

TEST(MitsubaShape, NormalsThatAllPointOneWayAreTakenForNoneUnlessTheTrianglesDoToo) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& positions, const std::string& faces) {
    folder.write("mesh.obj", positions + "vn 0 0 1\n" + faces);
    return load_scene(folder.write("room.xml",
                                   "<scene version=\"3.0.0\">\n<shape type=\"obj\">"
                                   "<string name=\"filename\" value=\"mesh.obj\"/></shape></scene>"));
  };
  const Imported roof = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\n",
                             "f 1//1 2//1 3//1 4//1\nf 2//1 5//1 6//1 3//1\n");
  const Mesh& smooth = std::get<Mesh>(roof.scene.shapes.at(0).geometry);
  for (std::size_t i = 0; i < smooth.positions.size(); ++i) {
    if (smooth.positions[i].x == 1 && smooth.positions[i].z == 0) {
      expect_near(smooth.normals[i], glm::normalize(glm::vec3(1, 0, 1)), "on the ridge");
    }
  }
  EXPECT_THAT(roof.account.guessed, Contains(AllOf(HasSubstr("room.xml:2:"), HasSubstr("mesh.obj: all its normals"))));

  const Imported gentle = read("v 0 0 0\nv 1 0 0.1\nv 1 1 0.1\nv 0 1 0\n", "f 1//1 2//1 3//1 4//1\n");
  for (const glm::vec3 n : std::get<Mesh>(gentle.scene.shapes.at(0).geometry).normals) {
    expect_near(n, glm::vec3(0, 0, 1), "kept");
  }
  EXPECT_THAT(gentle.account.guessed, Not(Contains(HasSubstr("normals are the same"))));
}

TEST(MitsubaShape, GroupsArePlacedByInstances) {
  const Imported imported = scene_of(
      "<shape type=\"shapegroup\" id=\"pair\"><shape type=\"cube\"/><shape type=\"sphere\"/></shape>"
      "<shape type=\"instance\"><ref id=\"pair\"/><transform name=\"to_world\"><translate "
      "y=\"3\"/></transform></shape>");
  ASSERT_EQ(imported.scene.groups.size(), 1u);
  EXPECT_EQ(imported.scene.groups[0].shapes.size(), 2u);
  EXPECT_THAT(imported.scene.shapes, IsEmpty());
  ASSERT_EQ(imported.scene.instances.size(), 1u);
  expect_near(glm::vec3(imported.scene.instances[0].to_world[3]), {0, 3, 0});
}

// ---- lights and eyes ------------------------------------------------------------------------------------------------

TEST(MitsubaLight, OfEveryKindIsRead) {
  const Scene scene =
      scene_of(kSphere +
               "<emitter type=\"point\"><point name=\"position\" x=\"1\" y=\"2\" z=\"3\"/>"
               "<rgb name=\"intensity\" value=\"4\"/></emitter>"
               "<emitter type=\"spot\"><float name=\"cutoff_angle\" value=\"40\"/><transform name=\"to_world\">"
               "<lookat origin=\"0, 5, 0\" target=\"0, 0, 0\" up=\"1, 0, 0\"/></transform></emitter>"
               "<emitter type=\"directional\"><vector name=\"direction\" value=\"0, 0, -2\"/>"
               "<rgb name=\"irradiance\" value=\"3\"/></emitter>"
               "<emitter type=\"constant\"><rgb name=\"radiance\" value=\"0.5\"/></emitter>")
          .scene;
  ASSERT_EQ(scene.point_lights.size(), 1u);
  expect_near(scene.point_lights[0].position, {1, 2, 3});
  EXPECT_EQ(scene.point_lights[0].intensity, Rgb(4));
  ASSERT_EQ(scene.spot_lights.size(), 1u);
  expect_near(scene.spot_lights[0].position, {0, 5, 0});
  expect_near(glm::normalize(scene.spot_lights[0].direction), {0, -1, 0});
  EXPECT_EQ(scene.spot_lights[0].cutoff_degrees, 40);
  EXPECT_EQ(scene.spot_lights[0].falloff_degrees, 30) << "three quarters, when the file does not say";
  ASSERT_EQ(scene.distant_lights.size(), 1u);
  expect_near(glm::normalize(scene.distant_lights[0].direction), {0, 0, -1});
  EXPECT_EQ(scene.distant_lights[0].irradiance, Rgb(3));
  EXPECT_EQ(scene.environment, Rgb(0.5f));
}

Camera camera_of(const std::string& inside, const std::string& type = "perspective") {
  return scene_of(
             kSphere + "<sensor type=\"" + type + "\">" + inside +
             "<film type=\"hdrfilm\"><integer name=\"width\" value=\"200\"/><integer name=\"height\" value=\"100\"/>"
             "</film></sensor>")
      .scene.camera;
}

TEST(MitsubaSensor, LooksAlongPlusZWithXToTheLeft) {
  const Camera straight = camera_of("");
  expect_near(straight.look_at - straight.position, {0, 0, 1});
  expect_near(straight.up, {0, 1, 0});
  EXPECT_FALSE(straight.mirrored);
  const Camera looking = camera_of(
      "<transform name=\"to_world\"><lookat origin=\"1, 2, 3\" target=\"1, 2, -7\" up=\"0, 1, 0\"/></transform>");
  expect_near(looking.position, {1, 2, 3});
  expect_near(looking.look_at - looking.position, {0, 0, -1});
  EXPECT_FALSE(looking.mirrored);
  EXPECT_TRUE(camera_of("<transform name=\"to_world\"><scale x=\"-1\"/></transform>").mirrored);
}

TEST(MitsubaSensor, TakesTheFieldOfViewAlongItsAxis) {
  const auto fov = [](const std::string& inside) {
    return std::tan(0.5 * double(camera_of("<float name=\"fov\" value=\"90\"/>" + inside).vertical_fov_degrees) * M_PI /
                    180);
  };
  const auto axis = [&](const char* name) {
    return fov(std::string("<string name=\"fov_axis\" value=\"") + name + "\"/>");
  };
  EXPECT_NEAR(fov(""), 0.5, 1e-5);
  EXPECT_NEAR(axis("x"), 0.5, 1e-5);
  EXPECT_NEAR(axis("larger"), 0.5, 1e-5);
  EXPECT_NEAR(axis("y"), 1, 1e-5);
  EXPECT_NEAR(axis("smaller"), 1, 1e-5);
  EXPECT_NEAR(axis("diagonal"), 1 / std::sqrt(5.0), 1e-5);
}

TEST(MitsubaSensor, LensAndParallelRays) {
  const Camera lens = camera_of(
      "<float name=\"aperture_radius\" value=\"0.2\"/><float name=\"focus_distance\" value=\"7\"/>", "thinlens");
  EXPECT_EQ(lens.lens_radius, 0.2f);
  EXPECT_EQ(lens.focus_distance, 7);
  const Camera parallel =
      camera_of("<transform name=\"to_world\"><scale x=\"3\" y=\"3\"/></transform>", "orthographic");
  EXPECT_EQ(parallel.projection, Projection::Orthographic);
  EXPECT_NEAR(parallel.height, 3, 1e-5) << "six wide, half as high";
}

}  // namespace
}  // namespace heckbert::import
