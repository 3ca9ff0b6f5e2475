// Media and nested bodies against closed forms: Beer's law, single scattering, the furnace of albedo one (A13 of
// docs/anchors.md), Fresnel through a stack of bodies. Statistical tests: Student's or z, 1 % after Sidak over the
// table at hand, fixed seeds.

#include <numeric>

#include <gtest/gtest.h>

#include <heckbert/transport/bodies.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/medium.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = 3.14159265358979323846;

Material boundary(std::uint32_t medium, int priority = 0) {
  return {.name = "boundary", .interior = Interior{medium, priority}, .is_index_matched = true};
}

Material glass(float ior, std::optional<std::uint32_t> medium = {}, int priority = 0) {
  return {.name = "glass", .lobes = {Dielectric{.ior = ior}}, .interior = Interior{medium, priority}};
}

/// An eye at z = 5 that looks down the z axis, nearly a single ray, at a lamp of radiance 1 at z = -5.
Scene lamp_behind() {
  Scene scene;
  add(scene, make_quad({-1, -1, -5}, {2, 0, 0}, {0, 2, 0}), emitter(1));
  scene.camera = {.position = {0, 0, 5}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 1e-3f};
  return scene;
}

RenderSettings small(int samples, int max_depth) {
  return {.width = 8, .height = 8, .samples_per_pixel = samples, .max_depth = max_depth};
}

double luminance_of(double r, double g, double b) {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

double transmitted(double n1, double n2) {
  const double r = (n1 - n2) / (n1 + n2);
  return 1 - r * r;
}

// ---- the medium itself ----------------------------------------------------------------------------------------------

TEST(Phase, IntegratesToOneAndHasItsMeanCosine) {
  for (const float g : {-0.7f, -0.1f, 0.0f, 1e-4f, 0.3f, 0.9f}) {
    double sum = 0, cosine = 0;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
      const double c = -1 + 2 * (i + 0.5) / kSteps;
      const double p = phase(g, static_cast<float>(c)) * 2 * kPiD * 2 / kSteps;
      sum += p;
      cosine += p * c;
    }
    EXPECT_NEAR(sum, 1, 1e-4) << g;
    EXPECT_NEAR(cosine, static_cast<double>(g), 1e-4) << g;
  }
}

TEST(Phase, IsSampledByItsDensity) {
  // Chi-square over 20 cosines times 4 azimuths with equal probabilities, 10^6 samples; 1 % over five rows after Sidak.
  constexpr int kCosines = 20, kAzimuths = 4, kBins = kCosines * kAzimuths, kSamples = 1000000;
  constexpr double kBound = 121.1;  // quantile 0.998 of chi-square with 79 degrees of freedom
  const glm::vec3 forward = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
  const Frame frame = Frame::around(forward);
  for (const float g : {-0.7f, 0.0f, 0.1f, 0.6f, 0.9f}) {
    const auto cumulative = [&](double c) {
      if (g == 0) return (c + 1) / 2;
      const double gd = static_cast<double>(g);
      return (1 - gd * gd) / (2 * gd) * (1 / std::sqrt(1 + gd * gd - 2 * gd * c) - 1 / (1 + gd));
    };
    std::array<double, kBins> counts{};
    for (int i = 0; i < kSamples; ++i) {
      Sampler sampler(7, 0, 0, i);
      const glm::vec3 local = frame.to_local(sample_phase(g, forward, sampler.next2()));
      const int cosine = std::min(static_cast<int>(cumulative(static_cast<double>(local.z)) * kCosines), kCosines - 1);
      const double turn = std::atan2(local.y, local.x) / (2 * kPiD) + 0.5;
      counts[static_cast<std::size_t>(cosine * kAzimuths +
                                      std::min(static_cast<int>(turn * kAzimuths), kAzimuths - 1))] += 1;
    }
    constexpr double kExpected = double{kSamples} / kBins;
    const double chi2 = std::accumulate(counts.begin(), counts.end(), 0.0, [](double sum, double n) {
      return sum + (n - kExpected) * (n - kExpected) / kExpected;
    });
    EXPECT_LT(chi2, kBound) << g;
  }
}

TEST(Flight, HasTheProbabilitiesOfBeerInEveryChannel) {
  // The expected weight of flights that get through is the transmittance; of those that end, the rest times the albedo.
  const Medium medium{.name = "m", .absorption = {0.2f, 0.1f, 0.0f}, .scattering = {0.3f, 1.0f, 2.5f}, .anisotropy = 0};
  constexpr int kSamples = 400000;
  constexpr float kFar = 1.3f;
  double passed[3] = {}, ended[3] = {}, squares[2][3] = {};
  for (int i = 0; i < kSamples; ++i) {
    Sampler sampler(3, 1, 0, i);
    const Flight flight = fly(medium, kFar, sampler);
    const float w[3] = {flight.weight.r, flight.weight.g, flight.weight.b};
    for (int c = 0; c < 3; ++c) {
      const double value = static_cast<double>(w[c]) / kSamples;
      (flight.scattered ? ended : passed)[c] += value;
      squares[flight.scattered ? 1 : 0][c] += value * value;
    }
  }
  const double a[3] = {0.2, 0.1, 0.0}, s[3] = {0.3, 1.0, 2.5};
  for (int c = 0; c < 3; ++c) {
    const double through = std::exp(-(a[c] + s[c]) * static_cast<double>(kFar));
    EXPECT_NEAR(passed[c], through, 3.15 * std::sqrt(squares[0][c])) << c;
    EXPECT_NEAR(ended[c], (1 - through) * s[c] / (a[c] + s[c]), 3.15 * std::sqrt(squares[1][c])) << c;
  }
}

// ---- Beer ---------------------------------------------------------------------------------------------------------

TEST(Absorption, OfASlabFollowsBeerAndLeavesNoLetter) {
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LaEp")) {
    Scene scene = lamp_behind();
    scene.media = {{.name = "ink", .absorption = {0.5f, 1.0f, 2.0f}}};
    add(scene, make_box({-1, -1, 0}, {1, 1, 0.75f}), boundary(0));
    RenderSettings settings = small(4, 4);
    settings.algorithm = algorithm.id;
    const record::Record record = render(scene, settings);
    ASSERT_EQ(record.words.size(), 1u) << algorithm.name;
    EXPECT_EQ(taxonomy::plain(record.words[0]), "LE");
    const Rgb seen = record::mean_colour(record, {true});
    EXPECT_NEAR(seen.r, std::exp(-0.375f), 1e-5f);
    EXPECT_NEAR(seen.g, std::exp(-0.75f), 1e-5f);
    EXPECT_NEAR(seen.b, std::exp(-1.5f), 1e-5f);
  }
}

TEST(Absorption, OfColouredGlassActsBetweenItsTwoSurfaces) {
  Scene scene = lamp_behind();
  scene.media = {{.name = "green", .absorption = Rgb(0.3f)}};
  add(scene, make_box({-1, -1, -0.5f}, {1, 1, 0.5f}), glass(3, 0));
  const double t = transmitted(1, 3), r = 1 - t, a = std::exp(-0.3);
  expect_energies(render(scene, small(2048, 6)), {{"LSSE", t * t * a}, {"LSSSSE", t * t * r * r * a * a * a}});
}

TEST(Absorption, DimsShadowRaysThroughBoundariesToo) {
  // A point light in the middle of a ball of ink above a floor.
  Scene scene;
  scene.media = {{.name = "ink", .absorption = Rgb(0.9f)}};
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  add(scene, Sphere{{0, 2, 0}, 0.5f}, boundary(0));
  scene.point_lights.push_back({.position = {0, 2, 0}, .intensity = Rgb(1)});
  scene.camera = {.position = {3, 0.5f, 0}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 1e-3f};
  const double expected = 0.5 / kPiD / 4 * std::exp(-0.45);
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LpDrEp")) {
    RenderSettings settings = small(4, 1);
    settings.algorithm = algorithm.id;
    const record::Record record = render(scene, settings);
    EXPECT_NEAR(energy_of(record, "LDE").mean, expected, 1e-4 * expected) << algorithm.name;
  }
}

// ---- scattering -----------------------------------------------------------------------------------------------------

TEST(SingleScattering, OfAPointLightInAnInfiniteMediumIsItsIntegral) {
  for (const float g : {0.0f, 0.5f, -0.6f}) {
    Scene scene;
    scene.media = {
        {.name = "fog", .absorption = {0.1f, 0.05f, 0.0f}, .scattering = {0.2f, 0.3f, 0.6f}, .anisotropy = g}};
    scene.medium = 0;
    add(scene, Sphere{{0, 1000, 0}, 1}, diffuse(0.5f));  // a scene has some shape
    scene.point_lights.push_back({.position = {0, 1, -2}, .intensity = Rgb(10)});
    scene.camera = {.position = {0, 0, 0}, .look_at = {0, 0, -1}, .vertical_fov_degrees = 1e-3f};
    const double a[3] = {0.1, 0.05, 0.0}, s[3] = {0.2, 0.3, 0.6};
    double expected[3] = {};
    constexpr double kStep = 1e-3;
    for (double t = kStep / 2; t < 200; t += kStep) {
      const double d = std::hypot(1.0, t - 2.0);
      const double p = static_cast<double>(phase(g, static_cast<float>((2.0 - t) / d)));
      for (int c = 0; c < 3; ++c) expected[c] += kStep * s[c] * p * 10 / (d * d) * std::exp(-(a[c] + s[c]) * (t + d));
    }
    expect_energies(render(scene, small(4096, 1)), {{"LVE", luminance_of(expected[0], expected[1], expected[2])}},
                    1 - std::pow(0.99, 1.0 / 3));
  }
}

TEST(SingleScattering, OfABallLampInAnInfiniteMediumIsFoundByBothTechniques) {
  // A small ball far off is a point light of intensity pi R^2 L, which multiple importance weights must not change.
  Scene scene;
  scene.media = {{.name = "fog", .absorption = Rgb(0.1f), .scattering = Rgb(0.4f), .anisotropy = 0.9f}};
  scene.medium = 0;
  constexpr double kRadius = 0.2;
  add(scene, Sphere{{0, 0.7f, -3}, static_cast<float>(kRadius)}, emitter(100));
  scene.camera = {.position = {0, 0, 0}, .look_at = {0, 0, -1}, .vertical_fov_degrees = 1e-3f};
  // Slow twin: the lamp as a disk of points seen from every point of the ray.
  double expected = 0;
  constexpr double kStep = 5e-3;
  constexpr int kRings = 24, kSpokes = 48;
  for (double t = kStep / 2; t < 60; t += kStep) {
    const double dy = 0.7, dz = t - 3.0, d = std::hypot(dy, dz);
    const double cos_cone = std::sqrt(1 - kRadius * kRadius / (d * d));
    for (int i = 0; i < kRings; ++i)
      for (int j = 0; j < kSpokes; ++j) {
        const double c = 1 - (1 - cos_cone) * (i + 0.5) / kRings, sine = std::sqrt(1 - c * c);
        const double phi = 2 * kPiD * (j + 0.5) / kSpokes;
        // The direction to the lamp in the frame of its centre; the ray goes along -z.
        const double along_z = c * dz / d + sine * std::cos(phi) * dy / d;
        const double distance = d * c - std::sqrt(std::max(0.0, kRadius * kRadius - d * d * sine * sine));
        const double cone = 2 * kPiD * (1 - cos_cone) / (kRings * kSpokes);
        expected += kStep * 0.4 * static_cast<double>(phase(0.9f, static_cast<float>(-along_z))) * 100 * cone *
                    std::exp(-0.5 * (t + distance));
      }
  }
  const record::Record record = render(scene, small(8192, 1));
  EXPECT_GT(record.tally.hits, 0u);
  EXPECT_GT(record.tally.next_events, 0u);
  expect_energies(record, {{"LVE", expected}});
}

TEST(MediumFurnace, OfAlbedoOneIsInvisible) {
  for (const float g : {0.0f, 0.8f}) {
    Scene scene;
    scene.environment = Rgb(1);
    scene.media = {{.name = "milk", .scattering = {0.5f, 1.0f, 2.0f}, .anisotropy = g}};
    add(scene, Sphere{{0, 0, 0}, 1}, boundary(0));
    scene.camera = {.position = {0, 0, 5}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 1e-3f};
    const record::Record record = render(scene, small(4096, 200));
    const std::vector<bool> all(record.words.size(), true);
    const record::Estimate total = record::energy(record, all);
    EXPECT_NEAR(total.mean, 1, 3.0 * total.standard_error) << g;
    EXPECT_LT(total.standard_error, 0.005);
    expect_energies(record, {{"LE", luminance_of(std::exp(-1.0), std::exp(-2.0), std::exp(-4.0))}});
    for (const taxonomy::Word& word : record.words)
      for (const taxonomy::Symbol event : word.events) ASSERT_EQ(event, taxonomy::Symbol::V);
  }
}

TEST(MediumFurnace, OfAGreyMediumLosesItsAlbedoAtEveryParticle) {
  // In an endless medium inside a glowing shell the sum over words of k scatterings is at most albedo^k, and in the
  // limit of a thick medium of albedo one half the share of LVE over LVVE etc. shrinks at least so fast.
  Scene scene = inside_sphere(emitter(1, Sides::Both));
  scene.media = {{.name = "smoke", .absorption = Rgb(0.5f), .scattering = Rgb(0.5f)}};
  scene.medium = 0;
  scene.camera.position = {0, 0, 0};
  const record::Record record = render(scene, small(2048, 60));
  expect_energies(record, {{"LE", std::exp(-1.0)}});
  const double lve = energy_of(record, "LVE").mean, lvve = energy_of(record, "LVVE").mean;
  EXPECT_LT(lve, 0.5 * (1 - std::exp(-1.0)));
  EXPECT_LT(lvve, 0.5 * lve);
}

// ---- nested bodies
// ----------------------------------------------------------------------------------------------------

TEST(Bodies, TheOneOfHigherPriorityIsThere) {
  Scene scene;
  scene.media = {{.name = "water"}, {.name = "glass"}};
  scene.materials = {glass(1.33f, 0, 1), glass(1.5f, 1, 2), diffuse(0.5f)};
  Bodies bodies;
  EXPECT_EQ(bodies.medium(scene), nullptr);
  EXPECT_TRUE(bodies.shows(scene, 0, true));
  bodies.cross(scene, 1, true);
  EXPECT_FALSE(bodies.shows(scene, 0, true)) << "water within glass is not there";
  EXPECT_TRUE(bodies.shows(scene, 2, true)) << "a surface that encloses nothing always shows";
  bodies.cross(scene, 0, true);
  EXPECT_EQ(bodies.medium(scene), &scene.media[1]);
  EXPECT_TRUE(bodies.shows(scene, 1, false)) << "out of the glass, into the water";
  EXPECT_FALSE(bodies.shows(scene, 0, false));
  EXPECT_FLOAT_EQ(bodies.index_in_front(scene, 1), 1.33f);
  EXPECT_FLOAT_EQ(bodies.index_in_front(scene, 0), 1.5f);
  bodies.cross(scene, 1, false);
  EXPECT_EQ(bodies.medium(scene), &scene.media[0]);
  EXPECT_TRUE(bodies.shows(scene, 0, false));
  bodies.cross(scene, 0, false);
  EXPECT_EQ(bodies.medium(scene), nullptr);
  bodies.cross(scene, 0, false);
  EXPECT_EQ(bodies.medium(scene), nullptr) << "leaving what was never entered";
}

TEST(Bodies, OfOneMaterialMergeAndEqualsNest) {
  Scene scene;
  scene.media = {{.name = "outer"}, {.name = "inner"}};
  scene.materials = {glass(1.3f, 0), glass(1.5f, 1)};
  Bodies bodies;
  bodies.cross(scene, 0, true);
  EXPECT_FALSE(bodies.shows(scene, 0, true)) << "glass in the same glass";
  bodies.cross(scene, 0, true);
  EXPECT_FALSE(bodies.shows(scene, 0, false));
  bodies.cross(scene, 0, false);
  EXPECT_TRUE(bodies.shows(scene, 1, true));
  bodies.cross(scene, 1, true);
  EXPECT_EQ(bodies.medium(scene), &scene.media[1]);
  EXPECT_TRUE(bodies.shows(scene, 1, false));
}

TEST(NestedDielectrics, OverlappingBodiesHaveTheInterfacesThatPrioritiesSay) {
  // Along -z: air, water from 1 to -1, glass from 0 to -2: the far side of the water is inside the glass.
  const struct {
    int water, glass;
    std::vector<double> indices;  // from the eye to the lamp
  } rows[] = {{1, 2, {1, 1.33, 1.5, 1}}, {2, 1, {1, 1.33, 1.5, 1}}};
  for (const auto& row : rows) {
    Scene scene = lamp_behind();
    scene.media = {{.name = "water", .absorption = Rgb(0.3f)}, {.name = "glass", .absorption = Rgb(0.8f)}};
    add(scene, make_box({-1, -1, -1}, {1, 1, 1}), glass(1.33f, 0, row.water));
    add(scene, make_box({-2, -2, -2}, {2, 2, 0}), glass(1.5f, 1, row.glass));
    double expected = 1;
    for (std::size_t i = 1; i < row.indices.size(); ++i) expected *= transmitted(row.indices[i - 1], row.indices[i]);
    // The overlap, one unit long, belongs to the body of higher priority.
    expected *= row.glass > row.water ? std::exp(-0.3 * 1 - 0.8 * 2) : std::exp(-0.3 * 2 - 0.8 * 1);
    for (const AlgorithmId algorithm : {AlgorithmId::Path, AlgorithmId::Whitted}) {
      RenderSettings settings = small(1024, 3);
      settings.algorithm = algorithm;
      const record::Record record = render(scene, settings);
      expect_energies(record, {{"LSSSE", expected}}, 0.0025);
      EXPECT_EQ(record.words.size(), 1u);
    }
  }
}

TEST(NestedDielectrics, AnEyeUnderWaterKnowsIt) {
  Scene scene = lamp_behind();
  scene.media = {{.name = "water", .absorption = Rgb(0.2f)}};
  add(scene, make_box({-9, -9, -1}, {9, 9, 9}), glass(1.33f, 0));
  const double expected = transmitted(1.33, 1) * 1.33 * 1.33 * std::exp(-0.2 * 6);
  // Of Sobol's points every batch may reflect the same whole number, and a spread of nothing bounds nothing.
  RenderSettings settings = small(1024, 1);
  settings.sampler = SamplerKind::Random;
  expect_energies(render(scene, settings), {{"LSE", expected}});
}

TEST(NestedDielectrics, GlassInWaterBendsByTheRatioOfTheirIndices) {
  // A glass ball in water of the same index is not there: all light goes straight through.
  Scene scene;
  add(scene, make_quad({-20, -20, -9}, {40, 0, 0}, {0, 40, 0}), emitter(1));
  add(scene, make_box({-30, -30, -5}, {30, 30, 8}), glass(1.4f, {}, 0));
  add(scene, Sphere{{0, 0, 0}, 1}, glass(1.4f, {}, 1));
  scene.camera = {.position = {0, 0, 5}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 30};
  const record::Record record = render(scene, small(256, 3));
  const double direct = energy_of(record, "LSE").mean + energy_of(record, "LSSSE").mean;
  Scene without = scene;
  without.shapes.pop_back();
  const record::Record plain = render(without, small(256, 3));
  const record::Estimate expected = energy_of(plain, "LSE");
  EXPECT_NEAR(direct, expected.mean, 0.01 * expected.mean);
}

// ---- everything together
// ----------------------------------------------------------------------------------------------

TEST(Media, GiveTheSameBytesForAnyNumberOfThreads) {
  Scene scene;
  scene.media = {{.name = "fog", .scattering = Rgb(0.2f), .anisotropy = 0.3f},
                 {.name = "tea", .absorption = {0.1f, 0.5f, 1}}};
  scene.medium = 0;
  add(scene, make_box({-2, -1, -2}, {2, 2, 2}, true), diffuse(0.6f));
  add(scene, make_quad({-1, 1.99f, -1}, {2, 0, 0}, {0, 0, 2}), emitter(3));
  add(scene, Sphere{{0.3f, 0, 0}, 0.7f}, glass(1.33f, 1));
  scene.camera = {.position = {0, 0.2f, 1.8f}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 70};
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LaStStEp")) {
    RenderSettings settings{.algorithm = algorithm.id, .width = 70, .height = 40, .samples_per_pixel = 4, .threads = 1};
    const record::Record one = render(scene, settings);
    ASSERT_GT(one.words.size(), 3u);
    for (const int threads : {2, 4}) {
      settings.threads = threads;
      EXPECT_TRUE(render(scene, settings) == one) << algorithm.name << " with " << threads;
    }
  }
}

TEST(Media, ThatBreakTheRulesAreRefused) {
  const auto refused = [](const Scene& scene) { EXPECT_THROW(render(scene, small(1, 1)), std::invalid_argument); };
  Scene good = lamp_behind();
  good.media = {{.name = "m", .scattering = Rgb(1)}};
  Scene scene = good;
  scene.medium = 1;
  refused(scene);
  scene = good;
  scene.materials[0].interior = Interior{7, 0};
  refused(scene);
  scene = good;
  scene.materials[0].is_index_matched = true;  // it emits
  refused(scene);
  scene = good;
  scene.media[0].anisotropy = 1;
  refused(scene);
  scene = good;
  scene.media[0].absorption = Rgb(-1);
  refused(scene);
}

}  // namespace
}  // namespace heckbert::transport
