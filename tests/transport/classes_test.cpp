// Design decision 2: the letter belongs to the lobe that was evaluated. On surfaces with several lobes every class must
// be right by itself; the usual shortcut leaves the sum right and every class wrong.

#include <numbers>

#include <gtest/gtest.h>

#include <heckbert/transport/eye.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/tracer.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

// A floor with a Lambert and a Phong lobe under a small square lamp, seen from the mirror side: both classes by
// quadrature over the lamp, with formulas of the test's own.
TEST(TwoLobes, GiveUnbiasedClassesUnderASmallLight) {
  constexpr float kDiffuse = 0.4f, kGlossy = 0.5f, kExponent = 12, kRadiance = 30, kHalf = 0.2f;
  const glm::dvec3 eye(1.5, 1.6, 0), lamp(-1.2, 1.5, 0.3);
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}),
      {.name = "two lobes", .lobes = {Lambert{Rgb(kDiffuse)}, Phong{Rgb(kGlossy), kExponent}}});
  add(scene, make_quad(glm::vec3(lamp) - glm::vec3(kHalf, 0, kHalf), {2 * kHalf, 0, 0}, {0, 0, 2 * kHalf}),
      emitter(kRadiance));
  scene.camera = {.position = glm::vec3(eye), .look_at = {0, 0, 0}, .vertical_fov_degrees = 0.01f};

  double diffuse_sum = 0, glossy_sum = 0;
  constexpr int kCells = 400;
  const glm::dvec3 mirror = glm::normalize(glm::dvec3(-eye.x, eye.y, -eye.z));
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const glm::dvec3 p =
          lamp + glm::dvec3((2.0 * (i + 0.5) / kCells - 1) * kHalf, 0, (2.0 * (j + 0.5) / kCells - 1) * kHalf);
      const double d2 = glm::dot(p, p);
      const glm::dvec3 w = p / std::sqrt(d2);
      const double geometry = w.y * w.y / d2 * (4 * kHalf * kHalf) / (kCells * kCells);
      diffuse_sum += kDiffuse / kPiD * geometry * kRadiance;
      glossy_sum += kGlossy * (kExponent + 2) / (2 * kPiD) * std::pow(std::max(0.0, glm::dot(mirror, w)), kExponent) *
                    geometry * kRadiance;
    }
  for (const AlgorithmId algorithm : {AlgorithmId::Path, AlgorithmId::Whitted}) {
    const auto record =
        render(scene, {.algorithm = algorithm, .width = 8, .height = 8, .samples_per_pixel = 2048, .max_depth = 2});
    expect_energies(record, {{"LDE", diffuse_sum}, {"LGE", glossy_sum}});
  }
}

TEST(TwoLobes, GiveUnbiasedClassesUnderAConstantSky) {
  const Lobe glossy = ggx(Rgb(0.5f), 0.3f);
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}),
      {.name = "two lobes", .lobes = {Lambert{Rgb(0.4f)}, glossy}});
  scene.environment = Rgb(1);
  scene.camera = {.position = {1.5f, 1, 0}, .look_at = {0, 0, 0}, .vertical_fov_degrees = 0.01f};
  const auto record = render(scene, {.width = 16, .height = 16, .samples_per_pixel = 1024, .max_depth = 1});

  const glm::vec3 wo = glm::normalize(glm::vec3(1.5f, 0, 1));  // local: the normal along z
  double albedo = 0;
  constexpr int kRows = 800, kColumns = 1600;
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j) {
      const double z = (i + 0.5) / kRows, phi = 2 * kPiD * (j + 0.5) / kColumns, r = std::sqrt(1 - z * z);
      albedo += evaluate(glossy, wo, glm::vec3(r * std::cos(phi), r * std::sin(phi), z)).r * z;
    }
  albedo *= 2 * kPiD / (kRows * kColumns);
  expect_energies(record, {{"LDE", 0.4}, {"LGE", albedo}});
}

// Several bounces over two-lobe walls against a brute-force twin: directions uniform over the hemisphere, lobes chosen
// by a coin, lights found by hitting them only. It shares no density, weight or choice with the path tracer.
TEST(TwoLobes, AgreeWithABruteForceTwinOverSeveralBounces) {
  Scene scene;
  const std::vector<Lobe> lobes{Lambert{Rgb(0.5f)}, Phong{Rgb(0.4f), 3}};
  add(scene, make_box({-1, -1, -1}, {1, 1, 1}, true), {.name = "wall", .lobes = lobes});
  add(scene, make_quad({-0.9f, 0.9f, -0.9f}, {1.8f, 0, 0}, {0, 0, 1.8f}), emitter(1.0f));
  scene.camera = {.position = {0.1f, -0.2f, 0.7f}, .look_at = {-0.6f, -0.9f, -0.3f}, .vertical_fov_degrees = 50};

  const Tracer tracer(scene);
  const Eye eye(scene.camera, 1, 1);
  constexpr int kPaths = 4'000'000, kLongest = 3;
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
        if (hit->front && depth > 0) {
          const std::string word = "L" + std::string(letters.rbegin(), letters.rend()) + "E";
          sum[word] += throughput;
          sum2[word] += throughput * throughput;
        }
        break;  // the lamp itself is black
      }
      const float side = hit->front ? 1.0f : -1.0f;
      const Frame frame = Frame::around(side * hit->normal_geometric);
      const glm::vec3 wo = frame.to_local(-ray.direction);
      glm::vec3 wi = uniform_sphere(sampler.next2());
      wi.z = std::abs(wi.z);
      const std::size_t lobe = sampler.next() < 0.5f ? 0 : 1;
      throughput *= 2.0 * evaluate(lobes[lobe], wo, wi).r * wi.z * 2 * kPiD;
      letters += lobe == 0 ? 'D' : 'G';
      ray = {leave(*hit, hit->front), frame.to_world(wi)};
    }
  }
  const auto record = render(scene, {.width = 1, .height = 1, .samples_per_pixel = 1 << 18, .max_depth = kLongest});
  // Two-sample z-test per word, 1 % for all fourteen words after Sidak.
  int compared = 0;
  for (const auto& [word, s] : sum) {
    const double mean = s / kPaths;
    const double variance = (sum2[word] / kPaths - mean * mean) / kPaths;
    const auto e = energy_of(record, word);
    EXPECT_NEAR(e.mean, mean, 3.38 * std::sqrt(variance + e.standard_error * e.standard_error)) << word;
    EXPECT_LT(std::sqrt(variance), 0.025 * mean) << word;
    ++compared;
  }
  EXPECT_EQ(compared, 14);
}

}  // namespace
}  // namespace heckbert::transport
