#pragma once
// Primary rays: a point of the picture to a ray, through a pinhole or a thin lens, in parallel, or all around.

#include <glm/vec2.hpp>

#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/filter.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/scene.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

class Eye {
 public:
  /// Errors: std::invalid_argument when the camera looks nowhere.
  Eye(const Camera& camera, int width, int height, const PixelFilter& filter = {});

  /// The pinhole's letter for all but a lens: a panoramic eye is a point, and a parallel one a point at infinity, in
  /// the same way as a distant light (docs/decisions/2026-11-23-lights-and-eyes.md).
  taxonomy::Symbol kind() const { return lens_radius_ > 0 ? taxonomy::Symbol::El : taxonomy::Symbol::Ep; }
  /// A ray for pixel (x, y), y downwards, through a point drawn by the pixel filter.
  Ray ray(int x, int y, Sampler& sampler) const;

 private:
  Ray through_lens(glm::vec2 film, Sampler& sampler) const;

  Projection projection_;
  FilterSampler filter_;
  glm::vec3 position_, right_, up_, forward_;
  float lens_radius_, focus_distance_;
  /// The picture's upper left corner, and one pixel: on the plane at distance one, in scene units for an orthographic
  /// eye, as angles for a panoramic one.
  glm::vec2 corner_, pixel_;
};

}  // namespace heckbert::transport
