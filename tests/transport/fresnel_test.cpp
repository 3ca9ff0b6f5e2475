// Fresnel's equations at the angles where their values are known, and against complex arithmetic.

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include <heckbert/transport/coat.h>
#include <heckbert/transport/fresnel.h>

#include "lobe_table.h"

namespace heckbert::transport {
namespace {

TEST(Fresnel, HasItsKnownValues) {
  EXPECT_NEAR(fresnel_dielectric(1.0f, 1.5f), 0.04, 1e-6);      // ((n-1)/(n+1))^2
  EXPECT_NEAR(fresnel_dielectric(1.0f, 1 / 1.5f), 0.04, 1e-6);  // the same from inside
  EXPECT_NEAR(fresnel_dielectric(0.0f, 1.5f), 1.0, 1e-6);       // grazing
  EXPECT_EQ(fresnel_dielectric(0.5f, 1 / 1.5f), 1.0f);          // beyond the critical angle
  const double brewster = std::cos(std::atan(1.5));             // there the parallel part vanishes
  const double t = (1.5 * 1.5 - 1) / (1.5 * 1.5 + 1);
  EXPECT_NEAR(fresnel_dielectric(static_cast<float>(brewster), 1.5f), 0.5 * t * t, 1e-5);
}

TEST(Fresnel, OfMetalsEqualsTheComplexEquations) {
  for (const Metal& metal : metals())
    for (const double cos_i : {1.0, 0.8, 0.5, 0.2, 0.05}) {
      const std::complex<double> n(static_cast<double>(metal.fresnel.eta.g), static_cast<double>(metal.fresnel.k.g));
      const std::complex<double> cos_t = std::sqrt(1.0 - (1 - cos_i * cos_i) / (n * n));
      const double s = std::norm((cos_i - n * cos_t) / (cos_i + n * cos_t));
      const double p = std::norm((n * cos_i - cos_t) / (n * cos_i + cos_t));
      EXPECT_NEAR(fresnel(metal.fresnel, static_cast<float>(cos_i)).g, 0.5 * (s + p), 2e-5) << metal.name << cos_i;
    }
}

TEST(Fresnel, OfAMetalWithoutAbsorptionIsThatOfGlassAndWithoutIndexIsOne) {
  for (const float cos_i : {1.0f, 0.7f, 0.2f}) {
    EXPECT_NEAR(fresnel_conductor(cos_i, 1.5f, 0.0f), fresnel_dielectric(cos_i, 1.5f), 1e-5f);
    EXPECT_NEAR(fresnel_conductor(cos_i, 0.0f, 3.0f), 1.0f, 1e-5f);
  }
}

TEST(Fresnel, MetalsHaveTheirColours) {
  const auto at_normal = [](const char* name) { return fresnel(*find_metal(name), 1); };
  EXPECT_GT(at_normal("cu").r, 1.5f * at_normal("Cu").b);
  EXPECT_GT(at_normal("Au").g, 1.5f * at_normal("Au").b);
  EXPECT_NEAR(at_normal("Ag").r, at_normal("Ag").b, 0.1f);
  EXPECT_FALSE(find_metal("Unobtainium"));
}

TEST(Fresnel, MeanEqualsItsQuadrature) {
  for (const float ior : {1.0f, 1.05f, 1.33f, 1.5f, 2.4f}) {
    double sum = 0;
    constexpr int kSteps = 20'000;
    for (int i = 0; i < kSteps; ++i) {
      const double z = (i + 0.5) / kSteps;
      sum += static_cast<double>(fresnel_dielectric(static_cast<float>(z), ior)) * 2 * z / kSteps;
    }
    EXPECT_NEAR(mean_fresnel_dielectric(ior), sum, 2e-5) << ior;
  }
}

// A coat and a white base below it reflect all that they receive when the coat is smooth; a rough one loses what its
// table is off by, which coat.h bounds. A darker base reflects in proportion, or less where colour saturates.
TEST(Coat, AndBaseTogetherConserveEnergy) {
  using enum Microfacets::Distribution;
  for (const Coat coat : {Coat{1.5f, 0}, Coat{1.9f, 0}, Coat{1.5f, 0.05f}, Coat{1.5f, 0.3f}, Coat{1.37f, 0.83f},
                          Coat{2.2f, 0.23f}, Coat{1.5f, 0.3f, Beckmann}})
    for (const double cos_o : {1.0, 0.95, 0.5, 0.15, 0.06}) {
      SCOPED_TRACE(std::to_string(coat.ior) + " " + std::to_string(coat.alpha) + " " + std::to_string(cos_o));
      const glm::vec3 wo = direction(cos_o, kAzimuth);
      const Lobe coat_alone = coat_lobe(coat);
      const double above = is_delta(coat_alone)
                               ? static_cast<double>(delta_branches(coat_alone, wo, true).reflected.weight.r)
                               : energy_albedo(coat_alone, wo, true);
      const auto base = [&](float albedo, bool linear) {
        return energy_albedo(CoatedDiffuse{.albedo = Rgb(albedo), .coat = coat, .linear = linear}, wo, true, 512, 4);
      };
      const double error = coat.alpha > 0 ? 4e-3 : 2e-4;
      EXPECT_NEAR(above + base(1, true), 1.0, error);
      EXPECT_NEAR(base(1, false), base(1, true), 1e-5);
      EXPECT_NEAR(base(0.5f, true), 0.5 * base(1, true), 1e-5);
      EXPECT_LT(base(0.5f, false), base(0.5f, true));
    }
}

}  // namespace
}  // namespace heckbert::transport
