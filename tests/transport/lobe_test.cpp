// Each lobe by itself: its density is one and describes its samples, its value is reciprocal, its albedo is what it
// should be; and the Dirac lobes, whose branches are known in closed form.

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/microfacet.h>
#include <heckbert/transport/sampler.h>

#include "lobe_table.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

glm::vec3 draw3(Sampler& sampler) {
  const glm::vec2 u = sampler.next2();
  return {u, sampler.next()};
}

/// Pearson's statistic with cells that expect fewer than five pooled.
struct ChiSquare {
  double statistic = 0;
  int cells = 0;
  ChiSquare(const std::vector<double>& expected, const std::vector<double>& seen) {
    double pool_expected = 0, pool_seen = 0;
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
  }
  /// Chance of a statistic this large when the density is right (Wilson and Hilferty 1931).
  double p_value() const {
    const double degrees = cells - 1, spread = 2 / (9 * degrees);
    return 0.5 * std::erfc((std::cbrt(statistic / degrees) - (1 - spread)) / std::sqrt(2 * spread));
  }
};

TEST(Lobe, SamplesFollowItsDensity) {
  // Chi-square on 16 x 32 cells per hemisphere plus the draws that go to the wrong side, 1 000 000 draws for each lobe
  // and angle; 1 % over all of them after Sidak.
  constexpr int kRows = 16, kColumns = 32, kDraws = 1'000'000, kSub = 32;
  const double significance = 1 - std::pow(0.99, 1.0 / static_cast<double>(lobe_table().size() * std::size(kCosines)));
  for (const NamedLobe& named : lobe_table())
    for (const double cos_o : kCosines) {
      SCOPED_TRACE(std::string(named.name) + " at " + std::to_string(cos_o));
      const glm::vec3 wo = direction(cos_o, kAzimuth);
      const bool whole = transmits(named.lobe);
      const int rows = whole ? 2 * kRows : kRows;
      const double low = whole ? -1 : 0, height = (1 - low) / rows;
      std::vector<double> expected(static_cast<std::size_t>(rows * kColumns)), seen(expected.size());
      double inside = 0;
      for (int i = 0; i < rows; ++i) {
        // Within a row by the polar angle, which resolves narrow lobes near the poles.
        const double top = std::acos(low + (i + 1) * height), step = (std::acos(low + i * height) - top) / kSub;
        for (int k = 0; k < kSub; ++k) {
          const double theta = top + (k + 0.5) * step;
          for (int j = 0; j < kColumns * kSub; ++j) {
            const glm::vec3 wi = direction(std::cos(theta), 2 * kPiD * (j + 0.5) / (kColumns * kSub));
            const double p = static_cast<double>(pdf_solid_angle(named.lobe, wo, wi, named.front)) * std::sin(theta) *
                             step * 2 * kPiD / (kColumns * kSub);
            expected[static_cast<std::size_t>(i * kColumns + j / kSub)] += p * kDraws;
            inside += p;
          }
        }
      }
      EXPECT_LT(inside, 1.001);
      double outside = 0;
      for (int n = 0; n < kDraws; ++n) {
        Sampler sampler(7, n, 0, 0);
        const auto wi = sample_direction(named.lobe, wo, draw3(sampler), named.front);
        if (wi.z == 0) {
          ++outside;
          continue;
        }
        ASSERT_NEAR(glm::length(wi), 1.0f, 1e-4f);
        const float phi = std::atan2(wi.y, wi.x);
        const int column = static_cast<int>((phi < 0 ? phi + 2 * kPi : phi) / (2 * kPi) * kColumns);
        const int row = static_cast<int>((static_cast<double>(wi.z) - low) / height);
        ++seen[static_cast<std::size_t>(std::min(row, rows - 1) * kColumns + std::min(column, kColumns - 1))];
      }
      expected.push_back((1 - inside) * kDraws);
      seen.push_back(outside);
      EXPECT_GT(ChiSquare(expected, seen).p_value(), significance);
    }
}

TEST(Lobe, IsReciprocalUpToTheSquareOfTheIndex) {
  // Seen from the other side, z is turned round. Between media, f / n^2 of the side that light goes to is symmetric
  // (Veach 1997, 5.14).
  const auto turned = [](glm::vec3 w) { return glm::vec3(w.x, w.y, -w.z); };
  for (const NamedLobe& named : lobe_table()) {
    int compared = 0;
    for (int n = 0; n < 400; ++n) {
      Sampler sampler(3, n, 0, 0);
      const glm::vec3 a = cosine_hemisphere(sampler.next2());
      glm::vec3 b = cosine_hemisphere(sampler.next2());
      const bool transmitted = transmits(named.lobe) && n % 2 == 0;
      if (transmitted) b.z = -b.z;
      const float ab = evaluate(named.lobe, a, b, named.front).r;
      const float ba = transmitted ? evaluate(named.lobe, turned(b), turned(a), !named.front).r *
                                         radiance_compression(named.lobe, named.front)
                                   : evaluate(named.lobe, b, a, named.front).r;
      EXPECT_NEAR(ab, ba, 2e-3f * ab + 1e-6f) << named.name;
      compared += ab > 0;
    }
    EXPECT_GT(compared, 100) << named.name;
  }
}

TEST(Lobe, ReflectsNoMoreThanItReceives) {
  for (const NamedLobe& named : lobe_table())
    for (const double cos_o : kCosines)
      EXPECT_LT(energy_albedo(named.lobe, direction(cos_o, kAzimuth), named.front, 256, 512), 1.0)
          << named.name << " " << cos_o;
}

TEST(Lobe, SelectionWeightVanishesOnlyWithTheLobe) {
  for (NamedLobe named : lobe_table()) {
    EXPECT_GT(selection_weight(named.lobe, direction(0.3, 0)), 0.0f) << named.name;
    scale(named.lobe, Rgb(0.0f));
    EXPECT_EQ(selection_weight(named.lobe, direction(0.3, 0)), 0.0f) << named.name;
    EXPECT_TRUE(is_black(evaluate(named.lobe, direction(0.3, 0), direction(0.3, kPiD)))) << named.name;
  }
}

TEST(Lobe, ScalingItScalesItsValue) {
  const Rgb factor(0.25f, 0.5f, 0.75f);
  for (const NamedLobe& named : lobe_table())
    for (const double z : {0.6, -0.6}) {
      const glm::vec3 wo = direction(0.8, kAzimuth), wi = direction(z, kAzimuth + 2.5);
      Lobe scaled = named.lobe;
      scale(scaled, factor);
      const Rgb expected = evaluate(named.lobe, wo, wi, named.front) * factor;
      const Rgb value = evaluate(scaled, wo, wi, named.front);
      EXPECT_NEAR(value.r, expected.r, 1e-5f * expected.r) << named.name;
      EXPECT_NEAR(value.b, expected.b, 1e-5f * expected.b) << named.name;
    }
}

TEST(Lobe, TransmissionGoesToTheOtherSideOnly) {
  const glm::vec3 wo = direction(0.8, kAzimuth), above = direction(0.7, kAzimuth + 3.0), below = direction(-0.7, 3.4);
  for (const NamedLobe& named : lobe_table()) {
    const bool diffuse_transmission = std::holds_alternative<DiffuseTransmission>(named.lobe);
    EXPECT_EQ(is_black(evaluate(named.lobe, wo, above, named.front)), diffuse_transmission) << named.name;
    EXPECT_EQ(is_black(evaluate(named.lobe, wo, below, named.front)), !transmits(named.lobe)) << named.name;
  }
  EXPECT_EQ(letter(DiffuseTransmission{}, true), taxonomy::Symbol::Dt);
  EXPECT_EQ(letter(RoughDielectric{}, true), taxonomy::Symbol::Gt);
  EXPECT_EQ(letter(RoughDielectric{}, false), taxonomy::Symbol::Gr);
  EXPECT_EQ(letter(CoatedDiffuse{}), taxonomy::Symbol::Dr);
  EXPECT_EQ(letter(Phong{}), taxonomy::Symbol::Gr);
}

TEST(Diffuse, AlbedosHaveTheirClosedForms) {
  // Fujii's: A (pi + roughness G), where G(theta) = sin (theta - sin cos) + 2/3 (tan (1 - sin^3) - sin) is the integral
  // of s/t and pi of the constant term.
  for (const double cos_o : {1.0, 0.95, 0.5, 0.15, 0.02}) {
    const glm::vec3 wo = direction(cos_o, kAzimuth);
    EXPECT_NEAR(energy_albedo(Lambert{Rgb(0.7f)}, wo), 0.7, 1e-5);
    EXPECT_NEAR(energy_albedo(DiffuseTransmission{Rgb(0.6f)}, wo), 0.6, 1e-5);
    const double roughness = 0.8, theta = std::acos(cos_o), s = std::sin(theta);
    const double g = s * (theta - s * cos_o) + 2.0 / 3.0 * (s / cos_o * (1 - s * s * s) - s);
    const double a = 1 / (kPiD + (kPiD / 2 - 2.0 / 3.0) * roughness);
    EXPECT_NEAR(energy_albedo(OrenNayar{Rgb(1.0f), 0.8f}, wo, true), a * (kPiD + roughness * g), 1e-4) << cos_o;
    EXPECT_LE(a * (kPiD + roughness * g), 1.0);
  }
}

TEST(Phong, ReflectsItsReflectanceHeadOn) {
  EXPECT_NEAR(energy_albedo(Phong{Rgb(0.8f), 5}, {0, 0, 1}, true), 0.8, 1e-4);
}

/// What a facet model scatters, as an integral over the normals of its facets in double precision instead of over
/// directions: the formulas of D and Lambda are written anew, and no Jacobian is needed.
double facet_albedo(const Microfacets& facets, glm::dvec3 o, double eta, bool conductor_of_one) {
  const bool ggx = facets.distribution == Microfacets::Distribution::Ggx;
  const double ax = static_cast<double>(facets.alpha_x), ay = static_cast<double>(facets.alpha_y);
  const auto lambda = [&](glm::dvec3 w) {
    const double t2 = (ax * ax * w.x * w.x + ay * ay * w.y * w.y) / (w.z * w.z);
    if (ggx) return (std::sqrt(1 + t2) - 1) / 2;
    const double a = 1 / std::sqrt(t2);
    return (std::erf(a) - 1) / 2 + std::exp(-a * a) / (2 * a * std::sqrt(kPiD));
  };
  // Over the slopes of the facets in units of alpha, in polar coordinates with the radius r = x / (1 - x).
  double sum = 0;
  constexpr int kRadii = 600, kAngles = 600;
  for (int i = 0; i < kRadii; ++i)
    for (int j = 0; j < kAngles; ++j) {
      const double x = (i + 0.5) / kRadii, phi = 2 * kPiD * (j + 0.5) / kAngles;
      const double r = x / (1 - x), dr = 1 / ((1 - x) * (1 - x));
      const double density = 2 * r * dr * (ggx ? 1 / ((1 + r * r) * (1 + r * r)) : std::exp(-r * r));
      const glm::dvec3 h = glm::normalize(glm::dvec3(ax * r * std::cos(phi), ay * r * std::sin(phi), 1));
      const double oh = glm::dot(o, h);
      if (oh <= 0) continue;
      const double seen = density * oh / (h.z * o.z);  // area of facets seen per area of surface seen
      const double f = conductor_of_one
                           ? 1.0
                           : static_cast<double>(fresnel_dielectric(static_cast<float>(oh), static_cast<float>(eta)));
      const glm::dvec3 reflected = 2 * oh * h - o;
      if (reflected.z > 0) sum += seen * f / (1 + lambda(o) + lambda(reflected));
      const double sin2 = (1 - oh * oh) / (eta * eta);
      if (f < 1 && sin2 < 1) {
        const glm::dvec3 refracted = (oh / eta - std::sqrt(1 - sin2)) * h - o / eta;
        if (refracted.z < 0) sum += seen * (1 - f) / ((1 + lambda(o)) * (1 + lambda(refracted)));
      }
    }
  return sum / (kRadii * kAngles);
}

// White furnace. Light that meets a second facet is lost, more of it the rougher the surface (a hundredth at alpha 0.1
// head on, two fifths at 0.6); what is left must be just what single scattering leaves.
TEST(Microfacets, LoseInTheFurnaceWhatSingleScatteringLoses) {
  using enum Microfacets::Distribution;
  for (const Microfacets facets : {Microfacets{0.6f, 0.6f}, {0.1f, 0.1f}, {0.5f, 0.1f}, {0.5f, 0.2f, Beckmann}})
    for (const double cos_o : kCosines) {
      const glm::vec3 wo = direction(cos_o, kAzimuth);
      const double albedo = energy_albedo(MicrofacetReflection{Rgb(1.0f), facets}, wo, true);
      EXPECT_NEAR(albedo, facet_albedo(facets, wo, 1.5, true), 2e-3) << facets.alpha_x << " " << cos_o;
      EXPECT_LT(albedo, 1.0005);
      if (facets.alpha_x < 0.2f && cos_o > 0.4) {
        EXPECT_GT(albedo, 0.95);
      }
    }
}

TEST(RoughGlass, ReflectsAndTransmitsTogetherWhatSingleScatteringLeaves) {
  using enum Microfacets::Distribution;
  for (const Microfacets facets : {Microfacets{0.3f, 0.3f}, {0.1f, 0.1f}, {0.4f, 0.15f, Beckmann}})
    for (const bool front : {true, false})
      for (const double cos_o : kCosines) {
        const glm::vec3 wo = direction(cos_o, kAzimuth);
        const double albedo = energy_albedo(RoughDielectric{.ior = 1.5f, .facets = facets}, wo, front);
        EXPECT_NEAR(albedo, facet_albedo(facets, wo, front ? 1.5 : 1 / 1.5, false), 3e-3)
            << facets.alpha_x << " " << front << " " << cos_o;
        EXPECT_LT(albedo, 1.0005);
        if (facets.alpha_x < 0.2f && cos_o > 0.4) {
          EXPECT_GT(albedo, 0.95);
        }
      }
}

TEST(RoughGlass, BecomesSmoothGlassAsItsFacetsLevel) {
  const glm::vec3 wo = direction(0.8, kAzimuth);
  for (const bool front : {true, false}) {
    const RoughDielectric rough{.ior = 1.5f, .facets = {0.02f, 0.02f, Microfacets::Distribution::Beckmann}};
    const DeltaBranches smooth = delta_branches(Dielectric{}, wo, front);
    double reflected = 0, transmitted = 0;
    constexpr int kDraws = 20'000;
    for (int n = 0; n < kDraws; ++n) {
      Sampler sampler(11, n, 0, 0);
      const auto wi = sample_direction(rough, wo, draw3(sampler), front);
      if (wi.z == 0) continue;
      const double value = static_cast<double>(evaluate(rough, wo, wi, front).r * std::abs(wi.z) /
                                               pdf_solid_angle(rough, wo, wi, front));
      (wi.z > 0 ? reflected : transmitted) += value / kDraws;
      EXPECT_GT(glm::dot(wi, wi.z > 0 ? smooth.reflected.wi : smooth.transmitted->wi), 0.9f);
    }
    // Every draw has weight one or less, so the shares are counts: four standard deviations.
    EXPECT_NEAR(reflected, static_cast<double>(smooth.reflected.weight.r), 0.01);
    EXPECT_NEAR(transmitted / static_cast<double>(smooth.transmitted->weight.r), 1.0, 0.015);
  }
}

TEST(Ggx, EqualsItsFormulaInDoublePrecisionDownToTheSmoothestLobe) {
  // In the shape of Lagarde and de Rousiers 2014, where masking and both cosines make one term.
  constexpr double kF0 = 0.3;
  for (const float alpha : {0.001f, 0.1f, 0.6f}) {
    const Lobe lobe = ggx(Rgb(static_cast<float>(kF0)), alpha);
    const double a2 = static_cast<double>(alpha) * static_cast<double>(alpha);
    for (const double cos_o : {0.95, 0.5, 0.05})
      for (int n = 0; n < 200; ++n) {
        const glm::vec3 wo = direction(cos_o, kAzimuth);
        Sampler sampler(5, n, 0, 0);
        const auto wi = sample_direction(lobe, wo, draw3(sampler));
        if (wi.z == 0) continue;
        const glm::dvec3 o(wo), i(wi), h = glm::normalize(o + i);
        const double spread = h.x * h.x + h.y * h.y + a2 * h.z * h.z;
        const double density = a2 / (kPiD * spread * spread);
        const double seen_from_o = std::sqrt(a2 + (1 - a2) * o.z * o.z),
                     seen_from_i = std::sqrt(a2 + (1 - a2) * i.z * i.z);
        const double fresnel = kF0 + (1 - kF0) * std::pow(1 - glm::dot(i, h), 5.0);
        const double value = density * fresnel * 0.5 / (i.z * seen_from_o + o.z * seen_from_i);
        const double pdf = density / (2 * (o.z + seen_from_o));
        EXPECT_NEAR(static_cast<double>(evaluate(lobe, wo, wi).r) / value, 1.0, 2e-3) << alpha << " " << cos_o << n;
        EXPECT_NEAR(static_cast<double>(pdf_solid_angle(lobe, wo, wi)) / pdf, 1.0, 2e-3) << alpha << " " << cos_o << n;
      }
  }
}

TEST(Microfacets, AreSpreadAlongTheirTangent) {
  // Wide along x: a light off to the side is reflected to the viewer above by facets tilted along x only.
  const Lobe brushed = MicrofacetReflection{Rgb(1.0f), {0.5f, 0.05f}};
  const glm::vec3 up(0, 0, 1), along(0.5f, 0, std::sqrt(0.75f)), across(0, 0.5f, std::sqrt(0.75f));
  EXPECT_GT(evaluate(brushed, up, along).r, 20 * evaluate(brushed, up, across).r);
}

TEST(Lobe, KeepsTheColourOfItsMaterial) {
  const Rgb colour(0.2f, 0.5f, 0.8f), tint(0.9f, 0.3f, 0.6f);
  const auto share = [](Rgb c) { return Rgb(c.r / c.g, 1, c.b / c.g); };
  const auto expect_same = [&](Rgb a, Rgb b, const char* what) {
    EXPECT_NEAR(share(a).r, share(b).r, 1e-5f) << what;
    EXPECT_NEAR(share(a).b, share(b).b, 1e-5f) << what;
  };
  const glm::vec3 wo = direction(0.99, 0), wi = mirrored(wo), through = -wo;
  expect_same(evaluate(Lambert{colour}, wo, wi), colour, "lambert");
  expect_same(evaluate(OrenNayar{colour}, wo, wi), colour, "oren-nayar");
  expect_same(evaluate(DiffuseTransmission{colour}, wo, through), colour, "diffuse transmission");
  expect_same(evaluate(CoatedDiffuse{.albedo = colour}, wo, wi), colour, "base");
  expect_same(evaluate(Phong{colour, 5}, wo, wi), colour, "phong");
  expect_same(evaluate(ggx(colour, 0.2f), direction(1, 0), direction(1, 0)), colour, "ggx");
  expect_same(delta_branches(Mirror{colour}, wo, true).reflected.weight, colour, "mirror");
  const RoughDielectric rough{1.5f, {0.3f, 0.3f}, colour, tint};
  expect_same(evaluate(rough, wo, wi), colour, "rough reflection");
  expect_same(evaluate(rough, wo, through), tint, "rough transmission");
  for (const Lobe& glass : {Lobe(Dielectric{1.5f, colour, tint}), Lobe(ThinDielectric{1.5f, colour, tint})}) {
    const auto branches = delta_branches(glass, wo, true);
    expect_same(branches.reflected.weight, colour, "reflection");
    expect_same(branches.transmitted->weight, tint, "transmission");
  }
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
      EXPECT_NEAR(sin_o, static_cast<double>(eta) * sin_t, 1e-6);
      EXPECT_EQ(branches.transmitted->event, taxonomy::Symbol::St);
      EXPECT_EQ(branches.reflected.event, taxonomy::Symbol::Sr);
    }
}

TEST(Dielectric, ReflectsAllBeyondTheCriticalAngle) {
  EXPECT_FALSE(delta_branches(Dielectric{}, direction(0.5, 0), false).transmitted);
}

TEST(ThinDielectric, SumsTheReflectionsBetweenItsFacesAndGoesStraight) {
  for (const double cos_o : {1.0, 0.6, 0.1}) {
    const glm::vec3 wo = direction(cos_o, 1.0);
    const auto branches = delta_branches(ThinDielectric{}, wo, true);
    const double face = static_cast<double>(fresnel_dielectric(wo.z, 1.5f));
    double series = face;
    for (int k = 0; k < 60; ++k) series += (1 - face) * face * std::pow(face, 2 * k) * (1 - face);
    EXPECT_NEAR(branches.reflected.weight.r, series, 1e-6);
    EXPECT_NEAR(branches.reflected.weight.r + branches.transmitted->weight.r, 1.0, 1e-6);
    EXPECT_EQ(branches.transmitted->radiance_scale, 1.0f);
    EXPECT_EQ(branches.transmitted->wi, -wo);
  }
}

}  // namespace
}  // namespace heckbert::transport
