// Walks from the light through media: against walks from the eye, word by word, and against closed forms. Which
// techniques they use there: bidirectional_test.cpp; their weights: vertex_merging_test.cpp; light and eye swapped:
// reciprocity_test.cpp.

#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/transport/medium.h>

#include "corner.h"
#include "test_scenes.h"
#include "word_comparison.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = 3.14159265358979323846;

/// Words of at most this many scatterings are compared.
constexpr int kLongest = 3;
constexpr int kMostComparisons = 1200;

/// Fog in which light goes on rather straight, everywhere.
void fill_with_fog(Scene& scene) {
  scene.media.push_back(
      {.name = "fog", .absorption = {0.02f, 0.05f, 0.1f}, .scattering = {0.2f, 0.25f, 0.3f}, .anisotropy = 0.6f});
  scene.medium = static_cast<std::uint32_t>(scene.media.size() - 1);
}

/// A ball of smoke that cuts through lamps, walls and other balls, and tea in the ball of glass.
void put_smoke_and_tea(Scene& scene) {
  const auto smoke = static_cast<std::uint32_t>(scene.media.size()), tea = smoke + 1;
  scene.media.push_back({.name = "smoke", .absorption = {0.3f, 0.1f, 0.0f}, .scattering = {0.5f, 0.9f, 0.7f}});
  scene.media.push_back({.name = "tea", .absorption = {0.2f, 0.6f, 1.5f}});
  add(scene, Sphere{{-0.4f, 0.7f, 0}, 1.3f},
      {.name = "boundary", .interior = Interior{smoke, 0}, .is_index_matched = true});
  for (Material& material : scene.materials)
    if (material.name == "glass") material.interior = Interior{tea, 1};
}

struct Filling {
  const char* name;
  void (*put)(Scene&);
  std::vector<std::string> lights, eyes;
};

/// The words that an algorithm finds, less those of which a particle may come as near as it likes to a point that it is
/// joined to, of the light or of the eye: that has no variance, and no test on means. Bidirectional weights avoid it.
taxonomy::Language testable(AlgorithmId algorithm) {
  const taxonomy::Language found = claimed_by(facts(algorithm));
  if (algorithm == AlgorithmId::Path) return found - taxonomy::compile("Lp V .* E");
  if (algorithm == AlgorithmId::Light) return found - taxonomy::compile("L .* V Ep");
  return found;
}

TEST(WalksFromTheLight, AgreeWithWalksFromTheEyeInMedia) {
  const auto among = [](const std::vector<std::string>& names, const char* name) {
    return std::ranges::find(names, name) != names.end();
  };
  const Filling fillings[] = {
      // It lets nothing in from infinitely far away.
      {"fog", fill_with_fog, {"area", "point"}, {"pinhole", "lens", "orthographic", "panoramic"}},
      {"smoke", put_smoke_and_tea, {"area", "point", "distant", "sky"}, {"pinhole", "lens"}}};
  int compared = 0;
  for (const Filling& filling : fillings)
    for (const LightKind& light : kLights) {
      if (!among(filling.lights, light.name)) continue;
      for (const EyeKind& eye : kEyes) {
        if (!among(filling.eyes, eye.name)) continue;
        Scene scene = corner();
        light.put(scene);
        filling.put(scene);
        eye.make(scene.camera);
        const std::string where = std::string(filling.name) + ", " + light.name + ", " + eye.name + ", ";
        RenderSettings settings{.width = 16, .height = 12, .samples_per_pixel = 192, .max_depth = kLongest, .seed = 3};
        const record::Record reference = render(scene, settings);
        std::map<AlgorithmId, record::Record> others;
        ASSERT_GT(energy_of(reference, "LVE").mean, 0);
        for (const AlgorithmId algorithm : {AlgorithmId::Light, AlgorithmId::Bidirectional,
                                            AlgorithmId::ConnectionAndMerging, AlgorithmId::FinalGathering}) {
          if (facts(algorithm).passes && eye.name != std::string("lens")) continue;
          settings.algorithm = algorithm;
          settings.seed = 4;
          const record::Record& other = others[algorithm] = render(scene, settings);
          compared += Comparison(reference, other, testable(AlgorithmId::Path) & testable(algorithm),
                                 algorithm == AlgorithmId::Light ? 0.25 : 0.15, kMostComparisons,
                                 where + std::string(facts(algorithm).name))
                          .count();
        }
        if (!scene.point_lights.empty() || !scene.spot_lights.empty())
          compared += Comparison(others[AlgorithmId::Bidirectional], others[AlgorithmId::Light],
                                 testable(AlgorithmId::Light) & taxonomy::compile("Lp V .* E"), 0.25, kMostComparisons,
                                 where + "light, a particle next to the point")
                          .count();
      }
    }
  EXPECT_GT(compared, 800);
  EXPECT_LE(compared, kMostComparisons);
}

TEST(WalksFromTheLight, ThroughMediaGiveTheSameBytesForAnyNumberOfThreads) {
  Scene scene = corner();
  scene.point_lights.push_back({.position = {-0.5f, 1.5f, 0.3f}, .intensity = Rgb(4)});
  put_smoke_and_tea(scene);
  for (const AlgorithmFacts& algorithm : kAlgorithms) {
    if (!algorithm.from_light) continue;
    RenderSettings settings{.algorithm = algorithm.id, .width = 36, .height = 20, .samples_per_pixel = 2, .threads = 1};
    const record::Record one = render(scene, settings);
    for (const int threads : {2, 4}) {
      settings.threads = threads;
      EXPECT_TRUE(render(scene, settings) == one) << algorithm.name << " with " << threads;
    }
  }
}

// ---- closed forms ---------------------------------------------------------------------------------------------------

/// The mean over the square picture of an eye at the origin that looks along -z, of 60 degrees; of what
/// `radiance(direction)` says, luminance.
template <class Radiance>
double mean_over_picture(const Radiance& radiance) {
  constexpr int kSide = 96;
  const double half = std::tan(kPiD / 6);
  double sum = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec3 film(half * (2 * (x + 0.5) / kSide - 1), half * (2 * (y + 0.5) / kSide - 1), -1);
      sum += radiance(glm::normalize(film)) / (kSide * kSide);
    }
  return sum;
}

Camera wide_eye() {
  return {.position = {0, 0, 0}, .look_at = {0, 0, -1}, .vertical_fov_degrees = 60};
}

RenderSettings square(AlgorithmId algorithm, int samples) {
  return {.algorithm = algorithm, .width = 16, .height = 16, .samples_per_pixel = samples, .max_depth = 3, .seed = 5};
}

// Fog between two planes in front of the eye, and a light behind it.
TEST(SingleScattering, OfAPointBehindTheEyeIsItsIntegralFromEitherEnd) {
  const glm::dvec3 point(0.4, 0.9, 1.5), absorption(0.1, 0.05, 0), scattering(0.2, 0.3, 0.6);
  constexpr double kNear = 1, kFar = 6;
  for (const float g : {0.0f, 0.5f, -0.6f}) {
    Scene scene;
    scene.media = {
        {.name = "fog", .absorption = {0.1f, 0.05f, 0.0f}, .scattering = {0.2f, 0.3f, 0.6f}, .anisotropy = g}};
    add(scene, make_box({-4, -4, -6}, {4, 4, -1}),
        {.name = "boundary", .interior = Interior{0, 0}, .is_index_matched = true});
    scene.point_lights.push_back({.position = glm::vec3(point), .intensity = Rgb(10)});
    scene.camera = wide_eye();
    const double expected = mean_over_picture([&](glm::dvec3 direction) {
      constexpr double kStep = 0.01;
      const double before = kNear / -direction.z;
      double sum = 0;
      for (double t = before + kStep / 2; t < kFar / -direction.z; t += kStep) {
        const glm::dvec3 edge = t * direction - point;  // as light goes
        const double d = glm::length(edge), in_fog = (t - before) + d * (edge.z + point.z + kNear) / edge.z;
        const auto p = static_cast<double>(phase(g, static_cast<float>(glm::dot(edge, -direction) / d)));
        const glm::dvec3 passed = glm::exp(-(absorption + scattering) * in_fog);
        sum += kStep * p * 10 / (d * d) * glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), scattering * passed);
      }
      return sum;
    });
    for (const AlgorithmId algorithm :
         {AlgorithmId::Path, AlgorithmId::Light, AlgorithmId::Bidirectional, AlgorithmId::ConnectionAndMerging})
      expect_energies(render(scene, square(algorithm, 256)), {{"LVE", expected}}, 0.01 / 12);
  }
}

// A slab of ink whose surfaces do not bend light, between a point and a floor: Beer dims what comes to the floor, and
// each surface of the slab is an S.
TEST(Absorption, InGlassDimsLightOnItsWayToTheFloor) {
  const glm::dvec3 point(0.8, 0.2, 4), absorption(0.3, 0.6, 1.2);
  Scene scene;
  scene.media = {{.name = "ink", .absorption = {0.3f, 0.6f, 1.2f}}};
  add(scene, make_quad({-4, -4, -3}, {8, 0, 0}, {0, 8, 0}), diffuse(0.5f));
  add(scene, make_box({-8, -8, 1}, {8, 8, 1.5f}),
      {.name = "glass", .lobes = {Dielectric{.ior = 1.0f}}, .interior = Interior{0, 0}});
  scene.spot_lights.push_back({.position = glm::vec3(point),
                               .direction = {0, 0, -1},
                               .intensity = Rgb(10),
                               .cutoff_degrees = 30,
                               .falloff_degrees = 30});
  scene.camera = wide_eye();
  const double expected = mean_over_picture([&](glm::dvec3 direction) {
    const glm::dvec3 edge = direction * (3 / -direction.z) - point;
    const double d = glm::length(edge), cosine = -edge.z / d;
    const glm::dvec3 passed = glm::exp(-absorption * 0.5 / cosine);
    return 0.5 / kPiD * 10 * cosine / (d * d) * glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), passed);
  });
  for (const AlgorithmId algorithm : {AlgorithmId::Light, AlgorithmId::Bidirectional, AlgorithmId::PhotonMap,
                                      AlgorithmId::FinalGathering, AlgorithmId::ConnectionAndMerging})
    expect_energies(render(scene, square(algorithm, 256)), {{"LSSDE", expected}}, 0.01 / 5);
}

}  // namespace
}  // namespace heckbert::transport
