// Looking up textures, what they do to lobes, and the recipes that make sums of lobes.

#include <numbers>

#include <gtest/gtest.h>

#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/texture.h>
#include <heckbert/transport/tracer.h>

#include "lobe_table.h"
#include "test_scenes.h"

namespace heckbert::transport {
namespace {

/// Two by two: red and green above blue and white, the last half opaque.
Image four_pixels(bool srgb) {
  return {.width = 2,
          .height = 2,
          .bytes = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 128},
          .srgb = srgb};
}

TEST(Texture, HasItsFirstRowOnTop) {
  const Texture texture{.source = four_pixels(true)};
  EXPECT_EQ(look_up(texture, {0.25f, 0.75f}), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(look_up(texture, {0.75f, 0.75f}), glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(look_up(texture, {0.25f, 0.25f}), glm::vec4(0, 0, 1, 1));
  EXPECT_FLOAT_EQ(look_up(texture, {0.75f, 0.25f}).a, 128.0f / 255.0f);
}

TEST(Texture, MixesNeighboursAcrossItsBorders) {
  const Texture texture{.source = four_pixels(true)};
  EXPECT_EQ(look_up(texture, {0.5f, 0.75f}), glm::vec4(0.5f, 0.5f, 0, 1));
  EXPECT_EQ(look_up(texture, {0.0f, 0.75f}), glm::vec4(0.5f, 0.5f, 0, 1));
  EXPECT_EQ(look_up(texture, {0.25f, 0.0f}), glm::vec4(0.5f, 0, 0.5f, 1));
  EXPECT_EQ(look_up(texture, {-2.75f, 7.75f}), look_up(texture, {0.25f, 0.75f}));
}

TEST(Texture, AveragesToTheMeanOfItsPixels) {
  const Texture texture{.source = four_pixels(true)};
  glm::dvec4 sum(0);
  constexpr int kSteps = 100;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j)
      sum += glm::dvec4(look_up(texture, (glm::vec2(i, j) + 0.5f) / static_cast<float>(kSteps)));
  EXPECT_NEAR(sum.r / (kSteps * kSteps), 0.5, 1e-5);
  EXPECT_NEAR(sum.b / (kSteps * kSteps), 0.5, 1e-5);
}

TEST(Texture, OfAPictureIsDecodedToLinearLight) {
  Image grey{.width = 1, .height = 1, .bytes = {188, 188, 188, 188}, .srgb = true};
  EXPECT_NEAR(look_up(Texture{.source = grey}, {0, 0}).r, std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
  EXPECT_FLOAT_EQ(look_up(Texture{.source = grey}, {0, 0}).a, 188 / 255.0f);
  grey.srgb = false;
  EXPECT_FLOAT_EQ(look_up(Texture{.source = grey}, {0, 0}).r, 188 / 255.0f);
  const Image floats{.width = 1, .height = 1, .floats = {7, 8, 9, 1}};
  EXPECT_EQ(look_up(Texture{.source = floats}, {0.3f, 0.9f}), glm::vec4(7, 8, 9, 1));
}

TEST(Texture, OfACheckerboardChangesEveryHalfUnit) {
  const Texture board{.source = Checkerboard{Rgb(1), Rgb(0)}, .scale = {2, 1}, .offset = {0, 0.5f}};
  EXPECT_EQ(look_up(board, {0.1f, 0.6f}).r, 1.0f);
  EXPECT_EQ(look_up(board, {0.1f, 0.1f}).r, 0.0f);
  EXPECT_EQ(look_up(board, {0.3f, 0.6f}).r, 0.0f);
  EXPECT_EQ(look_up(board, {0.3f, 0.1f}).r, 1.0f);
  EXPECT_EQ(look_up(board, {-0.1f, 0.6f}).r, 0.0f);
}

Texture constant(Rgb value) {
  return {.source = Checkerboard{value, value}};
}

TEST(LobeTexture, MultipliesTheParameterItNames) {
  using Parameter = LobeTexture::Parameter;
  Scene scene;
  scene.textures = {constant(Rgb(0.5f, 0.25f, 1))};
  const auto textured = [&](Lobe lobe, Parameter parameter, Channel channel = Channel::R, float factor = 1) {
    apply_texture(scene, {.parameter = parameter, .texture = {0, channel}, .factor = factor}, {0, 0}, lobe);
    return lobe;
  };
  EXPECT_EQ(std::get<Lambert>(textured(Lambert{Rgb(0.8f)}, Parameter::Colour)).albedo, Rgb(0.4f, 0.2f, 0.8f));
  EXPECT_EQ(std::get<Lambert>(textured(Lambert{Rgb(0.8f)}, Parameter::Weight, Channel::G)).albedo, Rgb(0.2f));
  EXPECT_EQ(std::get<Lambert>(textured(Lambert{Rgb(0.8f)}, Parameter::OneMinusWeight, Channel::G, 2)).albedo,
            Rgb(0.4f));
  const auto metal = std::get<MicrofacetReflection>(textured(ggx(Rgb(1), 0.4f), Parameter::Colour));
  EXPECT_EQ(std::get<SchlickFresnel>(metal.fresnel).f0, Rgb(0.5f, 0.25f, 1)) << "white at grazing angles still";
  EXPECT_EQ(metal.tint, Rgb(1));
  EXPECT_EQ(std::get<MicrofacetReflection>(textured(ggx(Rgb(1), 0.4f), Parameter::Weight)).tint, Rgb(0.5f));
  EXPECT_FLOAT_EQ(std::get<MicrofacetReflection>(textured(ggx(Rgb(1), 0.4f), Parameter::Alpha)).facets.alpha_x, 0.2f);
  EXPECT_FLOAT_EQ(std::get<MicrofacetReflection>(textured(ggx(Rgb(1), 0.4f), Parameter::Roughness)).facets.alpha_y,
                  0.1f);
  const auto base = std::get<CoatedDiffuse>(textured(CoatedDiffuse{.albedo = Rgb(1)}, Parameter::Colour));
  EXPECT_EQ(base.albedo, Rgb(0.5f, 0.25f, 1));
  EXPECT_EQ(base.tint, Rgb(1));
}

TEST(MaxAlbedo, KnowsThatTexturesMixAndDoNotAddUp) {
  using Parameter = LobeTexture::Parameter;
  Material mixed{.lobes = {Lambert{Rgb(0.9f)}, Mirror{Rgb(0.8f)}}};
  EXPECT_FLOAT_EQ(max_albedo(mixed).r, 1.7f);
  mixed.textures = {{.lobe = 0, .parameter = Parameter::Weight}, {.lobe = 1, .parameter = Parameter::OneMinusWeight}};
  EXPECT_FLOAT_EQ(max_albedo(mixed).r, 0.9f);
}

TEST(MetallicRoughness, IsPlasticOrMetalOrBetween) {
  const MetallicRoughness model{.base = Rgb(0.5f, 0.3f, 0.1f), .metallic = 0.25f, .roughness = 0.6f};
  Material material;
  add_metallic_roughness(material, model);
  ASSERT_EQ(material.lobes.size(), 3u);
  const glm::vec3 wo = direction(0.7, kAzimuth), wi = direction(0.8, kAzimuth + 2.8);
  const float alpha = 0.6f * 0.6f;
  const std::vector<Lobe> coated = plastic(model.base, {.ior = 1.5f, .alpha = alpha});
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_FLOAT_EQ(evaluate(material.lobes[i], wo, wi).g, 0.75f * evaluate(coated[i], wo, wi).g);
  EXPECT_FLOAT_EQ(evaluate(material.lobes[2], wo, wi).g, 0.25f * evaluate(ggx(model.base, alpha), wo, wi).g);
  // The same by texture, with factors beside it.
  Scene scene;
  scene.textures = {constant(Rgb(1, 0.5f, 0.25f)), constant(Rgb(0.5f, 0.3f, 0.1f))};
  Material textured;
  add_metallic_roughness(textured, {.base = Rgb(1),
                                    .metallic = 1,
                                    .roughness = 1.2f,
                                    .base_texture = 1,
                                    .metallic_texture = ScalarTexture{0, Channel::B},
                                    .roughness_texture = ScalarTexture{0, Channel::G}});
  for (const LobeTexture& use : textured.textures) apply_texture(scene, use, {0, 0}, textured.lobes[use.lobe]);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(evaluate(textured.lobes[i], wo, wi).g, evaluate(material.lobes[i], wo, wi).g,
                1e-5f * evaluate(material.lobes[i], wo, wi).g + 1e-7f)
        << i;
}

TEST(TextureCoordinates, FollowTheSurface) {
  Scene scene;
  scene.textures = {constant(Rgb(1))};
  const auto textured = [](const char* name) {
    return Material{.name = name, .lobes = {Lambert{}}, .textures = {LobeTexture{}}};
  };
  add(scene, make_quad({0, 0, 0}, {2, 0, 0}, {0, 4, 0}), textured("quad"));
  add(scene, Sphere{{10, 0, 0}, 2}, textured("sphere"));
  add(scene, Disk{{20, 0, 0}, {0, 0, 3}, 2}, textured("disk"));
  const Tracer tracer(scene);
  const auto hit_from_above = [&](float x, float y) { return *tracer.intersect({{x, y, 9}, {0, 0, -1}}); };
  const auto expect_near = [](auto a, auto b) { EXPECT_LT(glm::length(a - b), 1e-4f); };

  const Hit quad = hit_from_above(0.5f, 3);
  expect_near(quad.uv, glm::vec2(0.25f, 0.75f));
  expect_near(quad.along_u, glm::vec3(2, 0, 0));
  expect_near(quad.along_v, glm::vec3(0, 4, 0));

  const Hit sphere = hit_from_above(10, 1);  // towards +y, 30 degrees from the pole
  expect_near(sphere.uv, glm::vec2(0.25f, 5.0f / 6.0f));
  expect_near(glm::normalize(sphere.along_u), glm::vec3(-1, 0, 0));
  expect_near(glm::normalize(sphere.along_v), glm::vec3(0, -0.8660254f, 0.5f));

  const Hit disk = hit_from_above(21, 0);
  EXPECT_NEAR(disk.uv.x, 0.5f, 1e-5f);
  expect_near(glm::normalize(disk.along_u), glm::vec3(1, 0, 0));
}

TEST(NormalMap, TiltsTheNormalAlongUAndV) {
  Scene scene;
  scene.textures = {constant(Rgb(0.8f, 0.5f, 1))};
  const glm::vec3 n = mapped_normal(scene, {.texture = 0}, {0, 0});
  EXPECT_NEAR(n.x / n.z, 0.6f, 1e-5f);
  EXPECT_NEAR(n.y, 0.0f, 1e-6f);
  EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
  EXPECT_NEAR(mapped_normal(scene, {.texture = 0, .strength = 0}, {0, 0}).z, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace heckbert::transport
