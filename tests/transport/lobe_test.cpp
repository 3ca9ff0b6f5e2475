// Each lobe by itself: its density is one and describes its samples, its value is reciprocal, its albedo is what it
// should be; and Fresnel's equations at the angles where their values are known.

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/sampler.h>

namespace heckbert::transport {
namespace {

struct NamedLobe {
  const char* name;
  Lobe lobe;
};
const std::vector<NamedLobe> kLobes{{"lambert", Lambert{Rgb(0.7f)}},
                                    {"ggx rough", Ggx{Rgb(0.9f), 0.6f}},
                                    {"ggx smooth", Ggx{Rgb(0.9f), 0.1f}},
                                    {"phong 5", Phong{Rgb(0.8f), 5}},
                                    {"phong 80", Phong{Rgb(0.8f), 80}}};

glm::vec3 direction(double cos_theta, double phi) {
  const double sin_theta = std::sqrt(1 - cos_theta * cos_theta);
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

/// Integral over the upper hemisphere by the midpoint rule on 512 x 1024 cells.
template <class F>
double over_hemisphere(F f) {
  constexpr int kRows = 512, kColumns = 1024;
  double sum = 0;
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j)
      sum += f(direction((i + 0.5) / kRows, 2 * std::numbers::pi * (j + 0.5) / kColumns));
  return sum * 2 * std::numbers::pi / (kRows * kColumns);
}

TEST(Lobe, SamplesFollowItsDensity) {
  // Pearson's chi-square on 16 x 32 cells of the hemisphere plus the draws below the horizon, 200 000 draws; cells that
  // expect fewer than five are pooled. 1 % over the fifteen cases after Sidak, by the normal approximation of
  // chi-square.
  constexpr int kRows = 16, kColumns = 32, kDraws = 200'000, kSub = 48;
  for (const NamedLobe& named : kLobes)
    for (const double cos_o : {0.95, 0.5, 0.15}) {
      const glm::vec3 wo = direction(cos_o, 0.4);
      std::vector<double> expected(kRows * kColumns), seen(kRows * kColumns);
      double inside = 0;
      for (int i = 0; i < kRows * kSub; ++i)
        for (int j = 0; j < kColumns * kSub; ++j) {
          const glm::vec3 wi =
              direction((i + 0.5) / (kRows * kSub), 2 * std::numbers::pi * (j + 0.5) / (kColumns * kSub));
          const double p =
              pdf_solid_angle(named.lobe, wo, wi) * 2 * std::numbers::pi / (kRows * kSub * kColumns * kSub);
          expected[static_cast<std::size_t>(i / kSub * kColumns + j / kSub)] += p * kDraws;
          inside += p;
        }
      EXPECT_LT(inside, 1.002) << named.name << " " << cos_o;
      double below = 0;
      for (int n = 0; n < kDraws; ++n) {
        Sampler sampler(7, n, 0, 0);
        const auto wi = sample_direction(named.lobe, wo, sampler.next2());
        if (!wi) {
          ++below;
          continue;
        }
        EXPECT_NEAR(glm::length(*wi), 1.0f, 1e-4f);
        const double phi = std::atan2(wi->y, wi->x);
        const int column =
            static_cast<int>((phi < 0 ? phi + 2 * std::numbers::pi : phi) / (2 * std::numbers::pi) * kColumns);
        const int row = static_cast<int>(wi->z * kRows);
        ++seen[static_cast<std::size_t>(std::min(row, kRows - 1) * kColumns + std::min(column, kColumns - 1))];
      }
      expected.push_back((1 - inside) * kDraws);
      seen.push_back(below);
      double statistic = 0, pool_expected = 0, pool_seen = 0;
      int cells = 0;
      const auto count = [&](double e, double s) {
        statistic += (s - e) * (s - e) / e;
        ++cells;
      };
      for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= 5) {
          count(expected[i], seen[i]);
        } else {
          pool_expected += expected[i];
          pool_seen += seen[i];
        }
      }
      if (pool_expected >= 5) count(pool_expected, pool_seen);
      const double degrees = cells - 1;
      EXPECT_LT((statistic - degrees) / std::sqrt(2 * degrees), 3.8) << named.name << " " << cos_o;
    }
}

TEST(Lobe, IsReciprocal) {
  for (const NamedLobe& named : kLobes)
    for (int n = 0; n < 200; ++n) {
      Sampler sampler(3, n, 0, 0);
      const glm::vec3 a = cosine_hemisphere(sampler.next2()), b = cosine_hemisphere(sampler.next2());
      const float ab = evaluate(named.lobe, a, b).r, ba = evaluate(named.lobe, b, a).r;
      EXPECT_NEAR(ab, ba, 1e-3f * (ab + ba) + 1e-7f) << named.name;
    }
}

TEST(Lobe, ReflectsNoMoreThanItReceives) {
  for (const NamedLobe& named : kLobes)
    for (const double cos_o : {0.95, 0.5, 0.15}) {
      const glm::vec3 wo = direction(cos_o, 0.4);
      EXPECT_LT(over_hemisphere([&](glm::vec3 wi) { return evaluate(named.lobe, wo, wi).r * wi.z; }), 1.0)
          << named.name << " " << cos_o;
    }
}

TEST(Lobe, LambertReflectsItsAlbedoAndPhongItsReflectanceHeadOn) {
  const glm::vec3 up(0, 0, 1);
  EXPECT_NEAR(over_hemisphere([&](glm::vec3 wi) { return evaluate(Lambert{Rgb(0.7f)}, up, wi).r * wi.z; }), 0.7, 1e-4);
  EXPECT_NEAR(over_hemisphere([&](glm::vec3 wi) { return evaluate(Phong{Rgb(0.8f), 5}, up, wi).r * wi.z; }), 0.8, 1e-4);
}

TEST(Lobe, AWhiteMicrofacetLosesLittleWhenSmooth) {
  const glm::vec3 wo = direction(0.8, 0);
  const double smooth = over_hemisphere([&](glm::vec3 wi) { return evaluate(Ggx{Rgb(1), 0.1f}, wo, wi).r * wi.z; });
  EXPECT_GT(smooth, 0.98);
  EXPECT_LT(smooth, 1.0 + 1e-3);
}

TEST(Fresnel, HasItsKnownValues) {
  EXPECT_NEAR(fresnel_dielectric(1.0f, 1.5f), 0.04, 1e-6);      // ((n-1)/(n+1))^2
  EXPECT_NEAR(fresnel_dielectric(1.0f, 1 / 1.5f), 0.04, 1e-6);  // the same from inside
  EXPECT_NEAR(fresnel_dielectric(0.0f, 1.5f), 1.0, 1e-6);       // grazing
  EXPECT_EQ(fresnel_dielectric(0.5f, 1 / 1.5f), 1.0f);          // beyond the critical angle
  const double brewster = std::cos(std::atan(1.5));             // there the parallel part vanishes
  const double t = (1.5 * 1.5 - 1) / (1.5 * 1.5 + 1);
  EXPECT_NEAR(fresnel_dielectric(static_cast<float>(brewster), 1.5f), 0.5 * t * t, 1e-5);
}

TEST(Dielectric, SplitsEnergyAndObeysSnell) {
  for (const bool entering : {true, false})
    for (const double cos_o : {0.99, 0.8}) {
      const glm::vec3 wo = direction(cos_o, 1.0);
      const auto branches = delta_branches(Dielectric{1.5f, Rgb(1), Rgb(1)}, wo, entering);
      ASSERT_TRUE(branches.transmitted);
      const float eta = entering ? 1.5f : 1 / 1.5f;
      EXPECT_NEAR(branches.reflected.weight.r + branches.transmitted->weight.r * eta * eta, 1.0, 1e-6);
      EXPECT_NEAR(branches.transmitted->radiance_scale, 1 / (eta * eta), 1e-6);
      EXPECT_LT(branches.transmitted->wi.z, 0);
      const double sin_o = std::sqrt(1 - cos_o * cos_o);
      const double sin_t = std::hypot(branches.transmitted->wi.x, branches.transmitted->wi.y);
      EXPECT_NEAR(sin_o, eta * sin_t, 1e-6);
      EXPECT_EQ(branches.transmitted->event, taxonomy::Symbol::St);
      EXPECT_EQ(branches.reflected.event, taxonomy::Symbol::Sr);
    }
}

TEST(Dielectric, ReflectsAllBeyondTheCriticalAngle) {
  EXPECT_FALSE(delta_branches(Dielectric{}, direction(0.5, 0), false).transmitted);
}

}  // namespace
}  // namespace heckbert::transport
