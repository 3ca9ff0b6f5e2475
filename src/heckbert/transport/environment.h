#pragma once
// The light that comes from infinitely far away in every direction: a constant, an equirectangular image, or both.
//
// Directions are drawn by a density that is constant per solid angle within each pixel of the image and proportional to
// the pixel's mean brightness (Pharr, Jakob and Humphreys, "Physically Based Rendering", 12.6, with exact solid angles
// in place of a sine at the pixel's centre). Where the image is interpolated between pixels, the mean is that of the
// interpolated image, so the density is nowhere zero where the radiance is not.

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/discrete_distribution.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

struct EnvironmentSample {
  glm::vec3 direction;  ///< unit, towards the light
  Rgb radiance;
  float pdf_solid_angle = 0;
};

class Environment {
 public:
  /// Keeps a reference. Errors: std::invalid_argument for an image whose size does not fit its pixels.
  explicit Environment(const Scene& scene);

  bool is_black() const { return mean_radiance_ <= 0; }
  /// Largest channel, averaged over the sphere of directions.
  double mean_radiance() const { return mean_radiance_; }

  /// `direction` is unit.
  Rgb radiance(glm::vec3 direction) const;
  /// Ask only when it is not black.
  EnvironmentSample sample(glm::vec2 u) const;
  float pdf_solid_angle(glm::vec3 direction) const;

 private:
  const Rgb& pixel(int x, int y) const;
  Rgb radiance_at(glm::dvec2 place) const;
  glm::dvec2 place_of(glm::vec3 direction) const;
  float pdf_in(std::size_t row, std::size_t column) const;

  const Scene& scene_;
  double mean_radiance_ = 0;
  // Of an image only:
  std::vector<double> row_cosines_;  ///< cosine of the polar angle at the upper edge of each row, and -1
  DiscreteDistribution rows_;
  std::vector<DiscreteDistribution> columns_;  ///< by row
};

}  // namespace heckbert::transport
