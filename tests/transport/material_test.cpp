// One scene for each trap where several lobes, transmission, textures with holes and normal maps meet the two ways of
// finding light: every class by itself, against a closed form, a quadrature of the lobe, or a brute-force estimator.

#include <numbers>

#include <gtest/gtest.h>

#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/transport/eye.h>
#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/lights.h>
#include <heckbert/transport/vertex.h>

#include "lobe_table.h"
#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

/// Student's test per expression, 1 % for the whole table after Sidak; noise below 5 % so that it says something.
void expect_classes(const record::Record& record, const std::map<std::string, double>& truth) {
  const double per_class = 1 - std::pow(0.99, 1.0 / static_cast<double>(truth.size()));
  const double bound =
      record::student_quantile(1 - per_class / 2, record::batch_count(record.info.samples_per_pixel) - 1);
  for (const auto& [expression, expected] : truth) {
    const record::Estimate e = record::energy(record, record::members(record, taxonomy::compile(expression)));
    EXPECT_NEAR(e.mean, expected, bound * e.standard_error + 2e-5 * expected)
        << expression << ": " << (e.mean - expected) / e.standard_error << " standard errors";
    EXPECT_LT(e.standard_error, 0.05 * expected + 1e-12) << expression;
  }
}

Material material_of(std::vector<Lobe> lobes) {
  return {.name = "m", .lobes = std::move(lobes)};
}

/// A sheet in the plane z = 0 under a sky of one, seen from above at this cosine.
Scene sheet_under_the_sky(Material material, double cosine) {
  Scene scene;
  add(scene, make_quad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}), std::move(material));
  scene.environment = Rgb(1);
  scene.camera = {.position = direction(cosine, kAzimuth),
                  .look_at = {0, 0, 0},
                  .up = {0.3f, 0.1f, 1},
                  .vertical_fov_degrees = 0.01f};
  return scene;
}

record::Record trace(const Scene& scene, int depth = 1, int side = 16, int samples = 256) {
  return render(scene, {.width = side, .height = side, .samples_per_pixel = samples, .max_depth = depth});
}

/// What a lobe sends to wo out of a sky of one, above and below.
struct Albedos {
  double reflected = 0, transmitted = 0;
};
Albedos sky_albedos(const Lobe& lobe, glm::vec3 wo) {
  const auto half = [&](bool below) {
    return over_directions(
        [&](glm::vec3 wi) {
          if (below) wi.z = -wi.z;
          return evaluate(lobe, wo, wi).r * std::abs(wi.z);
        },
        false, 512, 1024);
  };
  return {half(false), half(true)};
}

TEST(Traps, DiffuseLightOnBothSidesHasTwoLetters) {
  const Scene scene = sheet_under_the_sky(material_of({Lambert{Rgb(0.5f)}, DiffuseTransmission{Rgb(0.3f)}}), 0.6);
  expect_classes(trace(scene), {{"L Dr E", 0.5}, {"L Dt E", 0.3}});
}

TEST(Traps, ALampBehindPaperIsSeenByTransmissionOnly) {
  // A point light at distance 2 below the sheet, and one at distance 3 above it.
  Scene scene = sheet_under_the_sky(material_of({Lambert{Rgb(0.5f)}, DiffuseTransmission{Rgb(0.3f)}}), 0.6);
  scene.environment = Rgb(0);
  scene.point_lights = {{.position = {0, 0, -2}, .intensity = Rgb(8)}, {.position = {0, 0, 3}, .intensity = Rgb(9)}};
  for (const AlgorithmId algorithm : {AlgorithmId::Path, AlgorithmId::Whitted})
    expect_classes(render(scene, {.algorithm = algorithm, .width = 8, .height = 8, .samples_per_pixel = 64}),
                   {{"L Dt E", 0.3 / kPiD * 8 / 4}, {"L Dr E", 0.5 / kPiD * 9 / 9}});
}

TEST(Traps, RoughGlassSplitsIntoItsTwoLettersFromEitherSide) {
  const RoughDielectric glass{.ior = 1.5f, .facets = {0.3f, 0.3f}};
  const Albedos from_front = sky_albedos(glass, direction(0.6, kAzimuth));
  expect_classes(trace(sheet_under_the_sky(material_of({glass}), 0.6)),
                 {{"L Gr E", from_front.reflected}, {"L Gt E", from_front.transmitted}});
}

TEST(Traps, BrushedMetalFollowsItsTangent) {
  // The camera's azimuth is on no axis, so a frame that ignored the texture coordinates would be wrong.
  const Lobe brushed = MicrofacetReflection{Rgb(1), {0.6f, 0.1f}};
  Scene scene = sheet_under_the_sky(material_of({brushed}), 0.5);
  scene.environment = Rgb(0);
  const glm::vec3 lamp(-1.6f, -0.3f, 1.2f);
  scene.point_lights = {{.position = lamp, .intensity = Rgb(3)}};
  const glm::vec3 wo = direction(0.5, kAzimuth), wi = glm::normalize(lamp);
  const double value = static_cast<double>(evaluate(brushed, wo, wi).r * wi.z * 3 / glm::dot(lamp, lamp));
  const auto turned = [](glm::vec3 w) { return glm::vec3(-w.y, w.x, w.z); };
  ASSERT_LT(value,
            0.1 * static_cast<double>(evaluate(brushed, turned(wo), turned(wi)).r * wi.z * 3 / glm::dot(lamp, lamp)));
  expect_classes(trace(scene), {{"L G E", value}});
}

TEST(Traps, ACoatAndItsWhiteBaseShareTheSkyWithoutLoss) {
  for (const double cosine : {0.9, 0.2}) {
    const double coat = static_cast<double>(fresnel_dielectric(static_cast<float>(cosine), 1.5f));
    expect_classes(trace(sheet_under_the_sky(material_of(plastic(Rgb(1), {.ior = 1.5f})), cosine)),
                   {{"L S E", coat}, {"L D E", 1 - coat}});
  }
}

TEST(Traps, AMetallicRoughnessMixtureKeepsItsLobesApart) {
  Material material;
  add_metallic_roughness(material, {.base = Rgb(0.7f), .metallic = 0.3f, .roughness = 0.7f});
  const glm::vec3 wo = direction(0.6, kAzimuth);
  double glossy = 0, diffuse = 0;
  for (const Lobe& lobe : material.lobes)
    (letter(lobe) == taxonomy::Symbol::Dr ? diffuse : glossy) += sky_albedos(lobe, wo).reflected;
  EXPECT_LT(glossy + diffuse, 1.0);
  expect_classes(trace(sheet_under_the_sky(material, 0.6)), {{"L D E", diffuse}, {"L G E", glossy}});
}

TEST(Traps, OneSidedLobesAreBlackFromBehind) {
  Material material = material_of({Lambert{Rgb(0.5f)}});
  material.lobe_sides = Sides::Front;
  Scene scene = sheet_under_the_sky(material, 0.6);
  expect_classes(trace(scene), {{"L D E", 0.5}});
  scene.camera.position.z = -scene.camera.position.z;
  EXPECT_TRUE(trace(scene).words.empty());
}

// ---- textures -------------------------------------------------------------------------------------------------------

/// Seen straight from above, a view of one by one tile of the texture: pixels are spread evenly over it.
Scene one_tile(Material material) {
  Scene scene = sheet_under_the_sky(std::move(material), 1);
  scene.shapes.front().geometry = make_quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  scene.camera = {.position = {0.5f, 0.5f, 2},
                  .look_at = {0.5f, 0.5f, 0},
                  .vertical_fov_degrees = static_cast<float>(2 * std::atan(0.25) * 180 / kPiD)};
  return scene;
}

TEST(Traps, ATextureMixesTwoLobesWithoutLosingAny) {
  using Parameter = LobeTexture::Parameter;
  Material material = material_of({Lambert{Rgb(0.8f)}, Mirror{Rgb(0.6f)}});
  material.textures = {{.lobe = 0, .parameter = Parameter::Weight},
                       {.lobe = 1, .parameter = Parameter::OneMinusWeight}};
  Scene scene = one_tile(material);
  scene.textures = {{.source = Image{.width = 2, .height = 1, .floats = {0.9f, 0, 0, 1, 0.3f, 0, 0, 1}}}};
  expect_classes(trace(scene), {{"L D E", 0.8 * 0.6}, {"L S E", 0.6 * 0.4}});
}

TEST(Traps, ColourIsAveragedInLinearLight) {
  Material material = material_of({Lambert{Rgb(0.8f)}});
  material.textures = {{.lobe = 0, .parameter = LobeTexture::Parameter::Colour}};
  Scene scene = one_tile(material);
  scene.textures = {{.source = Checkerboard{Rgb(1), Rgb(0.25f)}, .scale = {2, 2}}};
  expect_classes(trace(scene), {{"L D E", 0.8 * 0.625}});
}

// ---- holes ----------------------------------------------------------------------------------------------------------

Material with_opacity(std::vector<Lobe> lobes, Scene& scene, float opacity) {
  scene.textures.push_back({.source = Checkerboard{Rgb(opacity), Rgb(opacity)}});
  Material material = material_of(std::move(lobes));
  material.opacity = ScalarTexture{static_cast<std::uint32_t>(scene.textures.size() - 1)};
  return material;
}

TEST(Traps, HolesLetLightThroughWithoutALetter) {
  // Looking down through two veils at a floor that a point light above and the sky illuminate through them: each veil
  // passes 1 - a on the way of the light and again on the way of the eye.
  constexpr float kVeil = 0.3f, kFloor = 0.5f, kVeilAlbedo = 0.6f;
  Scene scene;
  add(scene, make_quad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}), diffuse(kFloor));
  for (const float height : {0.5f, 1.0f})
    add(scene, make_quad({-50, -50, height}, {100, 0, 0}, {0, 100, 0}),
        with_opacity({Lambert{Rgb(kVeilAlbedo)}}, scene, kVeil));
  scene.point_lights = {{.position = {0, 0, 3}, .intensity = Rgb(9)}};
  scene.camera = {.position = {0.02f, 0.01f, 4}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 0.5f};
  const double pass = 1 - double{kVeil};
  const double floor = pass * pass * pass * pass * kFloor / kPiD;
  const double upper = kVeil * kVeilAlbedo / kPiD * 9 / 4;
  const double lower = pass * kVeil * pass * kVeilAlbedo / kPiD * 9 / 6.25;
  expect_classes(trace(scene, 1, 16, 1024), {{"Lp D E", floor + upper + lower}});
  EXPECT_EQ(trace(scene).words.size(), 1u) << "nothing but LDE: no letter for a hole";
}

TEST(Traps, ABinaryHoleIsExact) {
  Scene scene;
  add(scene, make_quad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}), diffuse(0.5f));
  scene.textures = {{.source = Checkerboard{Rgb(1), Rgb(0)}}};
  Material veil = material_of({});
  veil.opacity = ScalarTexture{0};
  add(scene, make_quad({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}), veil);  // lower left and upper right quarters are there
  scene.point_lights = {{.position = {0, 0, 2}, .intensity = Rgb(4)}};
  const auto energy_at = [&](glm::vec3 look_at) {
    scene.camera = {.position = {0, 0, 0.5f}, .look_at = look_at, .up = {0, 0, 1}, .vertical_fov_degrees = 0.1f};
    return energy_of(trace(scene, 1, 4, 16), "LDE").mean;
  };
  EXPECT_EQ(energy_at({1, 1, 0}), 0.0);
  EXPECT_EQ(energy_at({-1, -1, 0}), 0.0);
  EXPECT_NEAR(energy_at({1, -1, 0}), 0.5 / kPiD * 4 / 6 * 2 / std::sqrt(6), 2e-3);
}

TEST(Traps, ALampWithHolesGivesJustItsShare) {
  // Seen itself, lighting a floor by both techniques, and covered by a second lamp with holes.
  constexpr float kShare = 0.4f, kRadiance = 5, kFloor = 0.5f;
  Scene scene;
  add(scene, make_quad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}), diffuse(kFloor));
  for (const float height : {2.0f, 2.5f}) {
    Material lamp = with_opacity({}, scene, kShare);
    lamp.emission = Rgb(kRadiance);
    lamp.emission_sides = Sides::Both;
    add(scene, make_quad({-0.5f, -0.5f, height}, {1, 0, 0}, {0, 1, 0}), lamp);
  }
  const auto irradiance = [&](double height) {  // of a unit square below its middle, per radiance
    const double a = 0.5 / height, root = std::sqrt(1 + a * a);
    return 4 * a / root * std::atan(a / root);
  };
  const double behind = (1 - double{kShare}) * kShare;
  scene.camera = {.position = {0, 0, 1}, .look_at = {0, 0, 0}, .up = {0, 1, 0}, .vertical_fov_degrees = 0.1f};
  // Lines from the point below the middle to the upper lamp all pass the lower one.
  expect_classes(trace(scene, 1, 16, 512),
                 {{"La D E", kFloor / kPiD * kRadiance * (kShare * irradiance(2) + behind * irradiance(2.5))}});
  scene.camera.look_at = {0, 0, 5};
  expect_classes(trace(scene, 0, 16, 512), {{"La E", kRadiance * (kShare + behind)}});
}

// ---- lamps with a texture -------------------------------------------------------------------------------------------

TEST(Traps, ALampWithATextureGivesWhatItShows) {
  // A unit square, one half of it black: the floor below its dividing line gets half of what the whole square would
  // give, and below the middle of the bright half more by the form factors of A8. Next-event estimation and hitting,
  // with and without bodies on the way.
  constexpr float kRadiance = 5, kFloor = 0.5f;
  Scene scene;
  add(scene, make_quad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}), diffuse(kFloor));
  Material lamp = emitter(kRadiance);
  lamp.emission_texture = 0;
  const Mesh square = make_quad({-0.5f, 0.5f, 1}, {1, 0, 0}, {0, -1, 0});  // shines down
  add(scene, square, lamp);
  scene.textures = {{.source = Checkerboard{Rgb(1), Rgb(0)}, .scale = {1, 0.5f}}};  // the half of lower u is bright
  const auto corner = [](double a, double b) {  // of a rectangle a x b at distance 1, below one of its corners
    const double x = std::sqrt(1 + a * a), y = std::sqrt(1 + b * b);
    return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2 * kPiD);
  };
  for (const bool foggy : {false, true}) {
    if (foggy) {
      scene.media = {{.name = "nothing"}};
      scene.medium = 0;
    }
    for (const AlgorithmId algorithm : {AlgorithmId::Path, AlgorithmId::Whitted}) {
      const auto energies_at = [&](float x) {
        scene.camera = {.position = {x, 0, 0.5f}, .look_at = {x, 0, 0}, .up = {0, 1, 0}, .vertical_fov_degrees = 0.01f};
        return render(scene,
                      {.algorithm = algorithm, .width = 8, .height = 8, .samples_per_pixel = 1024, .max_depth = 1});
      };
      expect_classes(energies_at(0), {{"La D E", kFloor * kRadiance * 2 * corner(0.5, 0.5)}});
      expect_classes(energies_at(-0.25f), {{"La D E", kFloor * kRadiance * 4 * corner(0.25, 0.5)}});
    }
  }
  // Itself it is seen as it is: the middle of either half.
  const auto seen = [&](float x) {
    scene.camera = {.position = {x, 0, 0.5f}, .look_at = {x, 0, 1}, .up = {0, 1, 0}, .vertical_fov_degrees = 0.1f};
    return energy_of(trace(scene, 0, 4, 16), "LE").mean;
  };
  EXPECT_NEAR(seen(-0.25f), kRadiance, 1e-5);
  EXPECT_EQ(seen(0.25f), 0.0);
}

// ---- normal maps ----------------------------------------------------------------------------------------------------

TEST(Traps, AMappedNormalLightsByItsOwnCosine) {
  Material material = material_of({Lambert{Rgb(0.5f)}});
  material.normal_map = NormalMap{.texture = 0};
  Scene scene = sheet_under_the_sky(material, 0.9);
  scene.environment = Rgb(0);
  const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, -0.2, 1));
  scene.textures = {{.source = Image{.width = 1, .height = 1, .floats = {0.65f, 0.4f, 1, 1}}}};
  const glm::dvec3 lamp(1, -0.5, 2);
  scene.point_lights = {{.position = glm::vec3(lamp), .intensity = Rgb(4)}};
  const double value = 0.5 / kPiD * glm::dot(n, glm::normalize(lamp)) * 4 / glm::dot(lamp, lamp);
  expect_classes(trace(scene, 1, 8, 64), {{"L D E", value}});
  // From behind, the map is the same surface seen from the other side.
  scene.point_lights.front().position.z *= -1;
  scene.camera.position.z *= -1;
  const glm::dvec3 below(lamp.x, lamp.y, -lamp.z);
  const double behind = 0.5 / kPiD * glm::dot(-n, glm::normalize(below)) * 4 / glm::dot(lamp, lamp);
  expect_classes(trace(scene, 1, 8, 64), {{"L D E", behind}});
}

// All of it at once over two bounces: a floor of two lobes with a normal map and a texture that mixes them, a veil with
// holes that also transmits, a lamp that shines to both sides and reflects, and a lens. The brute-force twin draws
// directions evenly over the sphere, chooses lobes by a coin and finds light by running into it: it shares with the
// path tracer the surfaces and the lobes' values, but no density, weight or choice.
TEST(Traps, AllTogetherAgreeWithABruteForceTwin) {
  using Parameter = LobeTexture::Parameter;
  Scene scene;
  scene.textures = {{.source = Image{.width = 2,
                                     .height = 2,
                                     .floats = {0.6f, 0.5f, 1, 1, 0.4f, 0.5f, 1, 1,  //
                                                0.5f, 0.65f, 1, 1, 0.5f, 0.4f, 1, 1}},
                     .scale = {3, 3}},
                    {.source = Checkerboard{Rgb(0.8f), Rgb(0.3f)}, .scale = {2, 2}}};
  Material floor = material_of({Lambert{Rgb(0.7f)}, MicrofacetReflection{Rgb(0.8f), {0.7f, 0.4f}}});
  floor.normal_map = NormalMap{.texture = 0};
  floor.textures = {{.lobe = 0, .parameter = Parameter::Weight, .texture = {1}},
                    {.lobe = 1, .parameter = Parameter::OneMinusWeight, .texture = {1}}};
  add(scene, make_quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), floor);
  Material veil = material_of({Lambert{Rgb(0.4f)}, DiffuseTransmission{Rgb(0.4f)}});
  veil.opacity = ScalarTexture{1};
  add(scene, make_quad({-0.8f, -0.8f, 0.8f}, {1.6f, 0, 0.2f}, {0, 1.6f, 0}), veil);
  Material lamp = material_of({Lambert{Rgb(0.5f)}});
  lamp.emission = Rgb(1);
  lamp.emission_sides = Sides::Both;
  add(scene, make_quad({-0.7f, -0.7f, 1.4f}, {1.4f, 0, 0}, {0, 1.4f, 0}), lamp);
  scene.camera = {.position = {1.5f, -1.2f, 0.6f},
                  .look_at = {0, 0, 0.3f},
                  .up = {0, 0, 1},
                  .vertical_fov_degrees = 45,
                  .lens_radius = 0.1f,
                  .focus_distance = 1.9f};

  const Tracer tracer(scene);
  const Eye eye(scene.camera, 1, 1);
  constexpr int kPaths = 3'000'000, kLongest = 2;
  std::map<std::string, double> sum, sum2;
  for (int n = 0; n < kPaths; ++n) {
    Sampler sampler(99, n, 0, 0);
    Ray ray = eye.ray(0, 0, sampler);
    std::string letters;
    double throughput = 1;
    for (int depth = 0; depth <= kLongest; ++depth) {
      const auto hit = tracer.intersect(ray);
      if (!hit) break;
      if (hit->emitter != kNoEmitter) {
        std::string word = "El";
        for (const char c : letters) word = (c == 'D' ? "Dr " : c == 'T' ? "Dt " : "Gr ") + word;
        word = "La " + word;
        sum[word] += throughput;
        sum2[word] += throughput * throughput;
      }
      const Vertex vertex(scene, *hit, ray.direction);
      const auto wi = vertex.local(uniform_sphere(sampler.next2()));
      if (wi.z == 0) break;
      const std::size_t lobe = sampler.next() < 0.5f ? 0 : 1;
      if (lobe >= vertex.lobes().size()) break;
      const bool below = wi.z < 0;
      throughput *=
          static_cast<double>(2.0f * evaluate(vertex.lobes()[lobe], vertex.wo, wi).r * std::abs(wi.z)) * 4 * kPiD;
      if (!(throughput > 0)) break;
      letters += below ? 'T' : letter(vertex.lobes()[lobe]) == taxonomy::Symbol::Dr ? 'D' : 'G';
      ray = vertex.leave(wi, below);
    }
  }
  const auto record = render(scene, {.width = 1, .height = 1, .samples_per_pixel = 1 << 18, .max_depth = kLongest});
  // Two-sample z-test per word, 1 % for all of them after Sidak.
  const double bound = record::student_quantile(1 - (1 - std::pow(0.99, 1.0 / static_cast<double>(sum.size()))) / 2,
                                                record::batch_count(1 << 18) - 1);
  int precise = 0;
  for (const auto& [word, s] : sum) {
    const double mean = s / kPaths;
    const double variance = (sum2[word] / kPaths - mean * mean) / kPaths;
    const auto e = record::energy(record, record::members(record, taxonomy::compile(word)));
    EXPECT_NEAR(e.mean, mean, bound * std::sqrt(variance + e.standard_error * e.standard_error)) << word;
    precise += std::sqrt(variance) < 0.02 * mean;
  }
  EXPECT_EQ(sum.size(), 7u) << "the geometry has no other";
  EXPECT_GE(precise, 4);
}

}  // namespace
}  // namespace heckbert::transport
