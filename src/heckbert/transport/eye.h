#pragma once
// Primary rays: a point of the picture to a ray, through a pinhole or a thin lens.

#include <glm/vec2.hpp>

#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/scene.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

class Eye {
 public:
  /// Errors: std::invalid_argument when the camera looks nowhere.
  Eye(const Camera& camera, int width, int height);

  taxonomy::Symbol kind() const { return lens_radius_ > 0 ? taxonomy::Symbol::El : taxonomy::Symbol::Ep; }
  /// A ray through a uniformly drawn point of pixel (x, y), y downwards: the box filter, drawn by importance.
  Ray ray(int x, int y, Sampler& sampler) const;

 private:
  glm::vec3 position_, right_, up_, forward_;
  float lens_radius_, focus_distance_;
  glm::vec2 corner_, pixel_;  ///< on the plane at distance one: the picture's upper left corner, and one pixel
};

}  // namespace heckbert::transport
