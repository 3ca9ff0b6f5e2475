// What a well-formed scene becomes.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/import.h>
#include <heckbert/taxonomy/error.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

using namespace transport;
using ::testing::ElementsAre;

constexpr std::string_view kHead = R"({ "camera": { "position": [0, 1, 4], "look_at": [0, 0, 0] }, "environment": 1,
  "materials": [ { "name": "a", "type": "lambert", "albedo": 0.5 } ], )";

Scene scene_with(const std::string& rest) {
  return read_json_scene(std::string(kHead) + rest + "}", "test", kSourceDir / "tests/import/data").scene;
}

Material material_of(const std::string& keys) {
  const std::string text = R"({ "camera": { "position": [0, 1, 4], "look_at": [0, 0, 0] }, "environment": 1,
    "materials": [ { "name": "m", )" +
                           keys + R"( } ],
    "shapes": [ { "type": "sphere", "material": "m", "center": [0, 0, 0], "radius": 1 } ] })";
  return read_json_scene(text, "test", ".").scene.materials.at(0);
}

const Mesh& mesh(const Shape& shape) {
  return std::get<Mesh>(shape.geometry);
}

void expect_near(glm::vec3 got, glm::vec3 expected) {
  EXPECT_LT(glm::length(got - expected), 1e-5f) << got.x << " " << got.y << " " << got.z;
}

glm::vec3 front(const Mesh& m, std::size_t triangle) {
  const glm::uvec3 t = m.triangles.at(triangle);
  return glm::normalize(glm::cross(m.positions[t.y] - m.positions[t.x], m.positions[t.z] - m.positions[t.x]));
}

TEST(JsonMaterial, EachTypeBecomesItsLobe) {
  EXPECT_EQ(std::get<Lambert>(material_of(R"("type": "lambert", "albedo": [0.1, 0.2, 0.3])").lobes.at(0)).albedo,
            Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(std::get<Rgb>(std::get<Mirror>(material_of(R"("type": "mirror", "reflectance": 0.9)").lobes.at(0)).fresnel),
            Rgb(0.9f));
  const auto glass = std::get<Dielectric>(material_of(R"("type": "dielectric", "transmission_tint": 0.8)").lobes.at(0));
  EXPECT_EQ(glass.ior, 1.5f);
  EXPECT_EQ(glass.reflection_tint, Rgb(1));
  EXPECT_EQ(glass.transmission_tint, Rgb(0.8f));
  EXPECT_FLOAT_EQ(
      std::get<MicrofacetReflection>(material_of(R"("type": "ggx", "f0": 0.9, "roughness": 0.5)").lobes.at(0))
          .facets.alpha_x,
      0.25f);
  EXPECT_FLOAT_EQ(std::get<MicrofacetReflection>(material_of(R"("type": "ggx", "f0": 0.9, "alpha": 0.5)").lobes.at(0))
                      .facets.alpha_y,
                  0.5f);
  EXPECT_EQ(std::get<Phong>(material_of(R"("type": "phong", "reflectance": 0.4, "exponent": 20)").lobes.at(0)).exponent,
            20);
}

/// A material whose scene has a checkerboard "board" and a picture "tiles".
Imported with_textures(const std::string& keys) {
  return read_json_scene(R"({ "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] }, "environment": 1,
    "textures": [ { "name": "board", "type": "checkerboard", "first": 1, "second": 0.5 },
                  { "name": "tiles", "type": "image", "file": "tiles.png", "scale": [2, 3], "offset": [0, 0.5] } ],
    "materials": [ { "name": "m", )" +
                             keys +
                             R"( } ],
    "shapes": [ { "type": "mesh", "material": "m", "positions": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]],
                  "texcoords": [[0,0],[1,0],[0,2]] } ] })",
                         "test", kSourceDir / "tests/import/data");
}

TEST(JsonMaterial, ReadsTheRestOfTheLobes) {
  const auto only = [](const std::string& keys) { return material_of(keys).lobes.at(0); };
  EXPECT_EQ(std::get<OrenNayar>(only(R"("type": "oren-nayar", "albedo": 0.4, "roughness": 0.7)")).roughness, 0.7f);
  EXPECT_EQ(
      std::get<DiffuseTransmission>(only(R"("type": "diffuse-transmission", "transmittance": 0.4)")).transmittance,
      Rgb(0.4f));
  EXPECT_EQ(std::get<ThinDielectric>(only(R"("type": "thin-dielectric", "ior": 1.4)")).ior, 1.4f);
  const auto copper = std::get<MicrofacetReflection>(
      only(R"("type": "beckmann", "metal": "cu", "alpha": 0.2, "alpha_across": 0.1, "weight": 0.5)"));
  EXPECT_EQ(copper.facets.distribution, Microfacets::Distribution::Beckmann);
  EXPECT_EQ(copper.facets.alpha_x, 0.2f);
  EXPECT_EQ(copper.facets.alpha_y, 0.1f);
  EXPECT_EQ(copper.tint, Rgb(0.5f));
  EXPECT_NEAR(std::get<ConductorFresnel>(copper.fresnel).k.r, 3.913f, 1e-3f);
  const auto measured = std::get<Mirror>(only(R"("type": "mirror", "eta": [1, 2, 3], "k": 4)"));
  EXPECT_EQ(std::get<ConductorFresnel>(measured.fresnel).eta, Rgb(1, 2, 3));
  const auto frosted = std::get<RoughDielectric>(
      only(R"("type": "rough-dielectric", "ior": 1.3, "roughness": 0.5, "distribution": "beckmann")"));
  EXPECT_EQ(frosted.ior, 1.3f);
  EXPECT_FLOAT_EQ(frosted.facets.alpha_x, 0.25f);
  EXPECT_EQ(frosted.facets.distribution, Microfacets::Distribution::Beckmann);
}

TEST(JsonMaterial, PlasticAndMetallicRoughnessAreSums) {
  const Material smooth = material_of(R"("type": "plastic", "albedo": 0.5, "ior": 1.6)");
  EXPECT_EQ(std::get<DielectricFresnel>(std::get<Mirror>(smooth.lobes.at(0)).fresnel).ior, 1.6f);
  EXPECT_EQ(std::get<CoatedDiffuse>(smooth.lobes.at(1)).coat.ior, 1.6f);
  EXPECT_TRUE(std::get<CoatedDiffuse>(smooth.lobes.at(1)).linear);
  const Material rough = material_of(R"("type": "plastic", "albedo": 0.5, "alpha": 0.3, "saturates": true)");
  EXPECT_EQ(std::get<MicrofacetReflection>(rough.lobes.at(0)).facets.alpha_x, 0.3f);
  EXPECT_EQ(std::get<CoatedDiffuse>(rough.lobes.at(1)).coat.alpha, 0.3f);
  EXPECT_FALSE(std::get<CoatedDiffuse>(rough.lobes.at(1)).linear);
  EXPECT_EQ(material_of(R"("type": "metallic-roughness", "base": 0.5, "roughness": 0.4)").lobes.size(), 3u);
}

TEST(JsonTexture, FindsItsWayIntoTheMaterial) {
  const Imported imported = with_textures(
      R"("lobes": [ { "type": "lambert", "albedo": 0.5, "albedo_texture": "tiles", "weight_texture": "board" },
                    { "type": "ggx", "f0": 1, "roughness": 1, "roughness_texture": {"name": "tiles", "channel": "g"},
                      "weight_texture": "board", "weight_inverted": true } ],
         "opacity_texture": {"name": "tiles", "channel": "a"}, "normal_map": "tiles", "normal_strength": 2,
         "lobe_sides": "front")");
  const Scene& scene = imported.scene;
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(std::get<Checkerboard>(scene.textures[0].source).second, Rgb(0.5f));
  const auto& picture = std::get<Image>(scene.textures[1].source);
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.bytes.at(0), 255) << "red in the upper left";
  EXPECT_EQ(picture.bytes.at(15), 128) << "half transparent in the lower right";
  EXPECT_TRUE(picture.srgb);
  EXPECT_EQ(scene.textures[1].scale, glm::vec2(2, 3));
  EXPECT_EQ(scene.textures[1].offset, glm::vec2(0, 0.5f));
  const Material& m = scene.materials.at(0);
  using Parameter = LobeTexture::Parameter;
  const struct {
    std::uint32_t lobe;
    Parameter parameter;
    std::uint32_t texture;
    Channel channel;
  } kExpected[] = {{0, Parameter::Colour, 1, Channel::R},
                   {0, Parameter::Weight, 0, Channel::R},
                   {1, Parameter::Roughness, 1, Channel::G},
                   {1, Parameter::OneMinusWeight, 0, Channel::R}};
  ASSERT_EQ(m.textures.size(), std::size(kExpected));
  for (std::size_t i = 0; i < m.textures.size(); ++i) {
    EXPECT_EQ(m.textures[i].lobe, kExpected[i].lobe) << i;
    EXPECT_EQ(m.textures[i].parameter, kExpected[i].parameter) << i;
    EXPECT_EQ(m.textures[i].texture.texture, kExpected[i].texture) << i;
    EXPECT_EQ(m.textures[i].texture.channel, kExpected[i].channel) << i;
  }
  EXPECT_EQ(m.opacity->channel, Channel::A);
  EXPECT_EQ(m.normal_map->strength, 2);
  EXPECT_EQ(m.lobe_sides, Sides::Front);
  EXPECT_EQ(mesh(scene.shapes.at(0)).texcoords.at(2), glm::vec2(0, 2));
}

TEST(JsonMaterial, KeepsEmissionAndTheTermsThatAreNoPaths) {
  const Material lamp = material_of(R"("type": "lambert", "albedo": 0.5, "emission": [3, 2, 1])");
  EXPECT_EQ(lamp.emission, Rgb(3, 2, 1));
  EXPECT_EQ(lamp.emission_sides, Sides::Front);
  EXPECT_EQ(lamp.ambient_reflectance, std::nullopt);
  const Material panel = material_of(R"("emission": { "radiance": 2, "sides": "both" }, "phantom_reflectance": 0.2,
                                        "ambient_reflectance": 0)");
  EXPECT_EQ(panel.emission, Rgb(2));
  EXPECT_EQ(panel.emission_sides, Sides::Both);
  EXPECT_EQ(panel.phantom_reflectance, Rgb(0.2f));
  EXPECT_EQ(panel.ambient_reflectance, Rgb(0));
  EXPECT_TRUE(panel.lobes.empty());
  const Imported screen = with_textures(R"("emission": { "radiance": 2, "texture": "tiles" })");
  EXPECT_EQ(screen.scene.materials.at(0).emission_texture, 1u);
}

TEST(JsonMaterial, LobesMayAddUpToExactlyOne) {
  const Material m =
      material_of(R"("lobes": [ { "type": "lambert", "albedo": 0.7 }, { "type": "mirror", "reflectance": 0.2 },
                                              { "type": "phong", "reflectance": 0.1, "exponent": 5 } ])");
  EXPECT_EQ(m.lobes.size(), 3u);
}

TEST(JsonShape, QuadAndBoxFaceTheirFronts) {
  const Scene scene = scene_with(R"("shapes": [
    { "type": "quad", "material": "a", "corner": [0, 0, 0], "edge_u": [2, 0, 0], "edge_v": [0, 3, 0] },
    { "type": "box", "material": "a", "low": [-1, -2, -3], "high": [1, 2, 3] },
    { "type": "box", "material": "a", "low": [-1, -2, -3], "high": [1, 2, 3], "inward": true } ])");
  expect_near(front(mesh(scene.shapes[0]), 0), {0, 0, 1});
  for (const std::size_t box : {1u, 2u}) {
    const Mesh& m = mesh(scene.shapes[box]);
    ASSERT_EQ(m.triangles.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
      const float outward = glm::dot(front(m, i), m.positions[m.triangles[i].x]);
      EXPECT_EQ(outward > 0, box == 1u) << i;
    }
  }
}

TEST(JsonShape, TransformStepsActInTheirOrder) {
  const Scene scene = scene_with(R"("shapes": [
    { "type": "mesh", "material": "a", "positions": [[1,0,0],[2,0,0],[1,1,0]], "triangles": [[0,1,2]],
      "normals": [[0,0,1],[0,0,1],[0,0,1]],
      "transform": [ {"scale": 2}, {"rotate": {"axis": [0, 3, 0], "degrees": 90}}, {"translate": [0, 0, 10]} ] },
    { "type": "sphere", "material": "a", "center": [1, 0, 0], "radius": 0.5,
      "transform": [ {"translate": [1, 0, 0]}, {"matrix": [[0,-3,0,0],[3,0,0,0],[0,0,3,1],[0,0,0,1]]} ] } ])");
  const Mesh& m = mesh(scene.shapes[0]);
  expect_near(m.positions[0], {0, 0, 8});
  expect_near(m.positions[2], {0, 2, 8});
  expect_near(m.normals[0], {1, 0, 0});
  expect_near(front(m, 0), {1, 0, 0});
  const auto& sphere = std::get<Sphere>(scene.shapes[1].geometry);
  expect_near(sphere.center, {0, 6, 1});
  EXPECT_FLOAT_EQ(sphere.radius, 1.5f);
}

TEST(JsonShape, MirroringKeepsTheFrontOutside) {
  const Scene scene =
      scene_with(R"("shapes": [ { "type": "box", "material": "a", "low": [-1, -1, -1], "high": [1, 1, 1],
                                                  "transform": [ { "scale": [-1, 1, 1] } ] } ])");
  const Mesh& m = mesh(scene.shapes[0]);
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    EXPECT_GT(glm::dot(front(m, i), m.positions[m.triangles[i].x]), 0) << i;
  }
}

TEST(JsonShape, ObjBringsItsTriangles) {
  const Scene scene = scene_with(R"("shapes": [ { "type": "obj", "material": "a", "file": "tetrahedron.obj" } ])");
  EXPECT_EQ(mesh(scene.shapes[0]).triangles.size(), 4u);
  EXPECT_EQ(scene.shapes[0].material, 0u);
}

TEST(JsonShape, ErrorsOfAnObjFileComeWithTheirOwnPlaces) {
  const TemporaryFolder folder;
  const auto obj = folder.write("broken.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
  try {
    scene_with(R"("shapes": [ { "type": "obj", "material": "a", "file": ")" + obj.string() + "\" } ]");
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 2u);
    EXPECT_EQ(error.diagnostics()[0].pointer, "/shapes/0/file");
    EXPECT_EQ(error.diagnostics()[1].source, obj.string());
    EXPECT_EQ(error.diagnostics()[1].line, 2u);
    EXPECT_EQ(error.diagnostics()[1].column, 7u);
  }
}

TEST(JsonScene, GroupsArePlacedByInstances) {
  const Scene scene = scene_with(R"(
    "instances": [ { "group": "g" }, { "group": "g", "transform": [ { "translate": [1, 2, 3] } ] } ],
    "groups": [ { "name": "g", "shapes": [ { "type": "sphere", "material": "a", "center": [0, 0, 0], "radius": 1 } ] } ])");
  ASSERT_EQ(scene.groups.size(), 1u);
  EXPECT_EQ(scene.groups[0].shapes.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[0].to_world, glm::mat4(1));
  expect_near(glm::vec3(scene.instances[1].to_world[3]), {1, 2, 3});
}

TEST(JsonScene, ReadsCameraLightsAndRenderDefaults) {
  const Scene scene = read_json_scene(R"({
    "camera": { "position": [1, 2, 3], "look_at": [0, 0, 0], "up": [0, 0, 1], "fov": 50, "lens_radius": 0.1, "focus_distance": 2.5 },
    "render": { "width": 320, "height": 200, "spp": 9, "max_depth": 5, "seed": 18446744073709551615 },
    "ambient": 0.25, "environment": [1, 2, 3],
    "lights": [ { "type": "point", "position": [0, 5, 0], "intensity": [4, 5, 6] } ],
    "materials": [ { "name": "a", "lobes": [] } ],
    "shapes": [ { "type": "sphere", "name": "ball", "material": "a", "center": [0, 0, 0], "radius": 1 } ] })",
                                      "test", ".")
                          .scene;
  EXPECT_EQ(scene.camera.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.camera.up, glm::vec3(0, 0, 1));
  EXPECT_EQ(scene.camera.vertical_fov_degrees, 50);
  EXPECT_EQ(scene.camera.lens_radius, 0.1f);
  EXPECT_EQ(scene.camera.focus_distance, 2.5f);
  EXPECT_EQ(scene.defaults.width, 320);
  EXPECT_EQ(scene.defaults.height, 200);
  EXPECT_EQ(scene.defaults.samples_per_pixel, 9);
  EXPECT_EQ(scene.defaults.max_depth, 5);
  EXPECT_EQ(scene.defaults.seed, 18446744073709551615u);
  EXPECT_EQ(scene.ambient, Rgb(0.25f));
  EXPECT_EQ(scene.environment, Rgb(1, 2, 3));
  ASSERT_EQ(scene.point_lights.size(), 1u);
  EXPECT_EQ(scene.point_lights[0].intensity, Rgb(4, 5, 6));
  EXPECT_EQ(scene.shapes[0].name, "ball");
}

TEST(JsonScene, ReadsLightsSkyProjectionAndFilter) {
  const Scene scene = read_json_scene(R"({
    "camera": { "position": [1, 2, 3], "look_at": [0, 0, 0], "projection": "orthographic", "height": 7 },
    "render": { "filter": "blackman-harris" },
    "environment_image": { "file": "sky.hdr", "scale": [2, 1, 1], "interpolation": "nearest",
                           "transform": [ { "rotate": { "axis": [0, 0, 1], "degrees": 90 } } ] },
    "lights": [ { "type": "distant", "direction": [0, -2, 0], "irradiance": [1, 2, 3] },
                { "type": "spot", "position": [0, 5, 0], "direction": [1, 0, 0], "intensity": 4, "cutoff": 50, "falloff": 40 } ],
    "materials": [ { "name": "a", "lobes": [] } ],
    "shapes": [ { "type": "disk", "material": "a", "center": [1, 0, 0], "normal": [0, 0, 2], "radius": 1,
                  "transform": [ { "scale": 2 }, { "rotate": { "axis": [0, 1, 0], "degrees": 90 } } ] } ] })",
                                      "test", kSourceDir / "tests/import/data")
                          .scene;
  EXPECT_EQ(scene.camera.projection, Projection::Orthographic);
  EXPECT_EQ(scene.camera.height, 7);
  ASSERT_TRUE(scene.defaults.filter);
  EXPECT_EQ(scene.defaults.filter->kind, FilterKind::BlackmanHarris);
  EXPECT_EQ(scene.defaults.filter->radius, 1.5f);
  ASSERT_EQ(scene.distant_lights.size(), 1u);
  EXPECT_EQ(scene.distant_lights[0].irradiance, Rgb(1, 2, 3));
  ASSERT_EQ(scene.spot_lights.size(), 1u);
  EXPECT_EQ(scene.spot_lights[0].direction, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene.spot_lights[0].cutoff_degrees, 50);
  EXPECT_EQ(scene.spot_lights[0].falloff_degrees, 40);
  ASSERT_TRUE(scene.environment_image);
  const EnvironmentImage& sky = *scene.environment_image;
  EXPECT_EQ(sky.width, 4);
  EXPECT_EQ(sky.height, 2);
  EXPECT_EQ(sky.interpolation, Interpolation::Nearest);
  EXPECT_EQ(sky.pixels[0], Rgb(2, 1, 1));
  EXPECT_NEAR((sky.to_world * glm::vec3(1, 0, 0)).y, 1, 1e-6);
  const auto& disk = std::get<Disk>(scene.shapes[0].geometry);
  EXPECT_EQ(disk.radius, 2);
  EXPECT_NEAR(disk.center.z, -2, 1e-6);
  EXPECT_NEAR(disk.normal.x, 4, 1e-5);
}

TEST(JsonScene, TheFileNamesASceneThatDoesNotNameItself) {
  const TemporaryFolder folder;
  const auto path = folder.write("my room.json", std::string(kHead) + R"("shapes": [
    { "type": "sphere", "material": "a", "center": [0, 0, 0], "radius": 1 } ] })");
  EXPECT_EQ(load_scene(path).scene.name, "my room");
}

}  // namespace
}  // namespace heckbert::import
