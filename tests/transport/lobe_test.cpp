// Each lobe by itself: its density is one and describes its samples, its value is reciprocal, its albedo is what it
// should be; and Fresnel's equations at the angles where their values are known.

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/material.h>
#include <heckbert/transport/sampler.h>

namespace heckbert::transport {
namespace {

struct NamedLobe {
  const char* name;
  Lobe lobe;
};
const std::vector<NamedLobe> kLobes{{"lambert", Lambert{Rgb(0.7f)}},      {"ggx rough", ggx(Rgb(0.9f), 0.6f)},
                                    {"ggx smooth", ggx(Rgb(0.9f), 0.1f)}, {"phong 0", Phong{Rgb(0.8f), 0}},
                                    {"phong 5", Phong{Rgb(0.8f), 5}},     {"phong 80", Phong{Rgb(0.8f), 80}}};

glm::vec3 direction(double cos_theta, double phi) {
  const double sin_theta = std::sqrt(1 - cos_theta * cos_theta);
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

glm::vec3 mirror_of(glm::vec3 w) {
  return {-w.x, -w.y, w.z};
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
  // expect fewer than five are pooled. 1 % over the eighteen cases after Sidak, by the normal approximation of
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
        const auto wi = sample_direction(named.lobe, wo, glm::vec3(sampler.next2(), 0));
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
  const double smooth = over_hemisphere([&](glm::vec3 wi) { return evaluate(ggx(Rgb(1), 0.1f), wo, wi).r * wi.z; });
  EXPECT_GT(smooth, 0.98);
  EXPECT_LT(smooth, 1.0 + 1e-3);
}

TEST(Ggx, EqualsItsFormulaInDoublePrecisionDownToTheSmoothestLobe) {
  // In the shape of Lagarde and de Rousiers 2014, where masking and both cosines make one term.
  constexpr double kF0 = 0.3;
  for (const float alpha : {0.001f, 0.1f, 0.6f}) {
    const Lobe lobe = ggx(Rgb(static_cast<float>(kF0)), alpha);
    const double a2 = static_cast<double>(alpha) * static_cast<double>(alpha);
    for (const double cos_o : {0.95, 0.5, 0.05})
      for (int n = 0; n < 200; ++n) {
        const glm::vec3 wo = direction(cos_o, 0.4);
        const auto wi = sample_direction(lobe, wo, glm::vec3(Sampler(5, n, 0, 0).next2(), 0));
        if (!wi) continue;
        const glm::dvec3 o(wo), i(*wi), h = glm::normalize(o + i);
        const double spread = h.x * h.x + h.y * h.y + a2 * h.z * h.z;
        const double density = a2 / (std::numbers::pi * spread * spread);
        const double seen_from_o = std::sqrt(a2 + (1 - a2) * o.z * o.z),
                     seen_from_i = std::sqrt(a2 + (1 - a2) * i.z * i.z);
        const double fresnel = kF0 + (1 - kF0) * std::pow(1 - glm::dot(i, h), 5.0);
        const double value = density * fresnel * 0.5 / (i.z * seen_from_o + o.z * seen_from_i);
        const double pdf = density / (2 * (o.z + seen_from_o));
        EXPECT_NEAR(evaluate(lobe, wo, *wi).r / value, 1.0, 2e-3) << alpha << " " << cos_o << " " << n;
        EXPECT_NEAR(pdf_solid_angle(lobe, wo, *wi) / pdf, 1.0, 2e-3) << alpha << " " << cos_o << " " << n;
      }
  }
}

TEST(Lobe, KeepsTheColourOfItsMaterial) {
  const Rgb colour(0.2f, 0.5f, 0.8f), tint(0.9f, 0.3f, 0.6f);
  const auto share = [](Rgb c) { return Rgb(c.r / c.g, 1, c.b / c.g); };
  const auto expect_same = [&](Rgb a, Rgb b, const char* what) {
    EXPECT_NEAR(share(a).r, share(b).r, 1e-5f) << what;
    EXPECT_NEAR(share(a).b, share(b).b, 1e-5f) << what;
  };
  const glm::vec3 wo = direction(0.99, 0), wi = mirror_of(wo);
  expect_same(evaluate(Lambert{colour}, wo, wi), colour, "lambert");
  expect_same(evaluate(Phong{colour, 5}, wo, wi), colour, "phong");
  expect_same(evaluate(ggx(colour, 0.2f), direction(1, 0), direction(1, 0)), colour, "ggx");
  expect_same(delta_branches(Mirror{colour}, wo, true).reflected.weight, colour, "mirror");
  const auto glass = delta_branches(Dielectric{1.5f, colour, tint}, wo, true);
  expect_same(glass.reflected.weight, colour, "reflection");
  expect_same(glass.transmitted->weight, tint, "transmission");
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
