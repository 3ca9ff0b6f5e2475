#include <heckbert/transport/coat.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/microfacet.h>

namespace heckbert::transport {

namespace {

// Nodes are closer where the albedo bends: the square root of the cosine and of the width, and the reflection
// coefficient (n - 1) / (n + 1) of the index, are spaced evenly.
constexpr int kCosines = 32, kWidths = 24, kIndices = 12;
constexpr float kHighestCoefficient = (kHighestCoatIor - 1) / (kHighestCoatIor + 1);
constexpr float kNarrowest = 0.001f;  ///< narrower coats are tabulated like this one

float node(int i, int count) {
  return static_cast<float>(i) / static_cast<float>(count - 1);
}

/// Where a coordinate from 0 to 1 falls among `count` nodes.
struct Place {
  std::size_t below;
  float fraction;
  Place(float coordinate, int count) {
    const float at = std::clamp(coordinate, 0.0f, 1.0f) * static_cast<float>(count - 1);
    below = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(count - 2));
    fraction = at - static_cast<float>(below);
  }
};

float mix(float a, float b, float t) {
  return a + t * (b - a);
}

class CoatTable {
 public:
  explicit CoatTable(Microfacets::Distribution distribution) {
    for (int w = 0; w < kWidths; ++w) {
      const float alpha = std::max(kNarrowest, node(w, kWidths) * node(w, kWidths));
      for (int c = 0; c < kCosines; ++c) tabulate({alpha, alpha, distribution}, w, c);
      for (int i = 0; i < kIndices; ++i) mean_[at(i)][at(w)] = mean(i, w);
    }
  }

  float albedo(const Coat& coat, float cosine) const {
    const Place c(std::sqrt(std::max(0.0f, cosine)), kCosines);
    return interpolate(coat, [&](std::size_t i, std::size_t w) {
      return mix(albedo_[i][w][c.below], albedo_[i][w][c.below + 1], c.fraction);
    });
  }

  float mean_albedo(const Coat& coat) const {
    return interpolate(coat, [&](std::size_t i, std::size_t w) { return mean_[i][w]; });
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  template <class Value>
  static float interpolate(const Coat& coat, Value value) {
    const Place i((coat.ior - 1) / (coat.ior + 1) / kHighestCoefficient, kIndices);
    const Place w(std::sqrt(coat.alpha), kWidths);
    const auto over_widths = [&](std::size_t index) {
      return mix(value(index, w.below), value(index, w.below + 1), w.fraction);
    };
    return mix(over_widths(i.below), over_widths(i.below + 1), i.fraction);
  }

  /// All indices at once, which see the same facets: the average of Fresnel times weight over a regular grid of draws.
  void tabulate(const Microfacets& facets, int width, int cosine) {
    constexpr int kGrid = 32;
    const float z = std::max(1e-4f, node(cosine, kCosines) * node(cosine, kCosines));
    const glm::vec3 wo(std::sqrt(1 - z * z), 0, z);
    std::array<double, kIndices> sum{};
    for (int a = 0; a < kGrid; ++a)
      for (int b = 0; b < kGrid; ++b) {
        const glm::vec3 h = sample_facet(facets, wo, (glm::vec2(a, b) + 0.5f) / static_cast<float>(kGrid));
        const float cos_h = glm::dot(wo, h);
        const glm::vec3 wi = 2.0f * cos_h * h - wo;
        if (cos_h <= 0 || wi.z <= 0) continue;
        const float weight =
            facet_density(facets, h) * masking(facets, wo, wi) * cos_h / (z * pdf_facet(facets, wo, h));
        for (int i = 0; i < kIndices; ++i) {
          const float coefficient = kHighestCoefficient * node(i, kIndices);
          sum[at(i)] += static_cast<double>(weight * fresnel_dielectric(cos_h, (1 + coefficient) / (1 - coefficient)));
        }
      }
    for (int i = 0; i < kIndices; ++i)
      albedo_[at(i)][at(width)][at(cosine)] = std::min(1.0f, static_cast<float>(sum[at(i)] / (kGrid * kGrid)));
  }

  /// Of the interpolated albedo, exactly, so that base and coat add up: with t the square root of the cosine, the
  /// integral of 4 t^3 times a function that is linear between nodes.
  float mean(int index, int width) const {
    double sum = 0;
    for (int c = 0; c + 1 < kCosines; ++c) {
      const double t0 = static_cast<double>(node(c, kCosines)), t1 = static_cast<double>(node(c + 1, kCosines));
      const auto& row = albedo_[at(index)][at(width)];
      const double e0 = static_cast<double>(row[at(c)]), e1 = static_cast<double>(row[at(c + 1)]);
      const double slope = (e1 - e0) / (t1 - t0);
      sum +=
          (e0 - slope * t0) * (std::pow(t1, 4) - std::pow(t0, 4)) + slope * 0.8 * (std::pow(t1, 5) - std::pow(t0, 5));
    }
    return static_cast<float>(sum);
  }

  std::array<std::array<std::array<float, kCosines>, kWidths>, kIndices> albedo_{};
  std::array<std::array<float, kWidths>, kIndices> mean_{};
};

const CoatTable& table(Microfacets::Distribution distribution) {
  if (distribution == Microfacets::Distribution::Ggx) {
    static const CoatTable ggx(Microfacets::Distribution::Ggx);
    return ggx;
  }
  static const CoatTable beckmann(Microfacets::Distribution::Beckmann);
  return beckmann;
}

}  // namespace

float coat_albedo(const Coat& coat, float cosine) {
  if (coat.alpha <= 0) return fresnel_dielectric(cosine, coat.ior);
  return table(coat.distribution).albedo(coat, cosine);
}

float mean_coat_albedo(const Coat& coat) {
  if (coat.alpha <= 0) return mean_fresnel_dielectric(coat.ior);
  return table(coat.distribution).mean_albedo(coat);
}

}  // namespace heckbert::transport
