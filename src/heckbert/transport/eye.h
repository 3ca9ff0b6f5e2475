#pragma once
// Primary rays: a point of the picture to a ray, through a pinhole or a thin lens, in parallel, or all around; and the
// way back, for walks from the light: where in the picture a point is seen, and how large it looks there. How large is
// counted in pixels per steradian at the eye, or, where all rays are parallel, per area; for a pinhole this is Veach's
// importance W_e times the cosine (Veach 1997, 8.2; pbrt-v3, 16.1.1).

#include <glm/vec2.hpp>

#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/filter.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/scene.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

/// A line of sight, and where in the picture it shows. No std::optional: copies of those wait (docs/performance.md).
struct Sight {
  glm::vec3 from{0};       ///< on the lens; of a parallel eye, in its plane
  glm::vec3 direction{0};  ///< unit, into the scene
  glm::vec2 place{0};      ///< in pixels from the picture's upper left corner, wherever it falls
  float pixels = 0;        ///< per steradian; of a parallel eye, per area that faces it; 0: nothing is seen

  bool is_seen() const { return pixels > 0; }
};

class Eye {
 public:
  /// Errors: std::invalid_argument when the camera looks nowhere.
  Eye(const Camera& camera, int width, int height, const PixelFilter& filter = {});

  /// The pinhole's letter for all but a lens: a panoramic eye is a point, and a parallel one a point at infinity, in
  /// the same way as a distant light (docs/decisions/2026-11-23-lights-and-eyes.md).
  taxonomy::Symbol kind() const { return lens_radius_ > 0 ? taxonomy::Symbol::El : taxonomy::Symbol::Ep; }
  /// A ray for pixel (x, y), y downwards, through a point drawn by the pixel filter.
  Ray ray(int x, int y, Sampler& sampler) const;

  bool has_lens() const { return lens_radius_ > 0; }
  float lens_area() const;
  bool is_parallel() const { return projection_ == Projection::Orthographic; }
  glm::vec3 position() const { return position_; }

  /// To a point of the scene, through a point of the lens, if there is one. Not seen when the eye looks away from it.
  Sight sight_of(glm::vec3 point, Sampler& sampler) const;
  /// To infinity. Not seen also when all rays are parallel: they see one direction, and no other.
  Sight sight_along(glm::vec3 direction, Sampler& sampler) const;
  /// Where a ray from the scene meets the lens, at most so far away.
  Sight sight_met_by(const Ray& ray, float farthest) const;
  /// Sight::pixels of a primary ray.
  float pixels_along(glm::vec3 direction) const;
  /// Of a direction, with the lens's or picture's axis.
  float cosine(glm::vec3 direction) const;
  /// See FilterSampler::pixel_at. Draws no numbers where there is nothing to choose, and nor do the two above.
  PixelShare pixel_at(glm::vec2 place, Sampler& sampler) const {
    return filter_.pixel_at(place, filter_.overlaps() ? sampler.next2() : glm::vec2(0));
  }

 private:
  Ray through_lens(glm::vec2 film, Sampler& sampler) const;
  glm::vec3 lens_point(glm::vec2 u) const;
  glm::vec3 seen_from(Sampler& sampler) const { return has_lens() ? lens_point(sampler.next2()) : position_; }
  glm::vec2 place_of(glm::vec2 film) const { return (film - corner_) / pixel_; }
  Sight sight(glm::vec3 lens, glm::vec3 direction) const;

  Projection projection_;
  FilterSampler filter_;
  glm::vec3 position_, right_, up_, forward_;
  float lens_radius_, focus_distance_;
  /// The picture's upper left corner, and one pixel: on the plane at distance one, in scene units for an orthographic
  /// eye, as angles for a panoramic one.
  glm::vec2 corner_, pixel_;
};

}  // namespace heckbert::transport
