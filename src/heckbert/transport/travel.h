#pragma once
// How a ray gets from one event to the next when there are bodies and media on its way. Boundaries that are not there
// to be seen, because they are index-matched or hidden by a body of higher priority, are passed straight and leave no
// letter; a medium dims the ray and may scatter it, which is the letter V. A scene without either pays one test.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// What a ray met: a surface, or a particle at the ray's new origin, or neither: it left the scene.
struct Meeting {
  std::optional<Hit> hit;
  bool scattered = false;
};

enum class Particles : std::uint8_t {
  Scatter,  ///< light that meets a particle goes on as V
  Dim       ///< it is lost, for algorithms whose words have no V
};

Meeting travel_through_bodies(const World& world, Walk& walk, Ray& ray, Rgb& throughput, Particles particles);

/// Moves the ray's origin to the last boundary it passed, or to the particle; keeps walk.bodies; multiplies the
/// throughput by what the media did, over the density of what was drawn.
inline Meeting travel(const World& world, Walk& walk, Ray& ray, Rgb& throughput,
                      Particles particles = Particles::Scatter) {
  if (!world.has_bodies) [[likely]] {
    ++walk.rays;
    return {world.tracer.intersect(ray), false};
  }
  // Copies, so that where there are no bodies nobody has the address of the tracer's ray and throughput, and they can
  // stay in registers.
  Ray through = ray;
  Rgb dimmed = throughput;
  const Meeting meeting = travel_through_bodies(world, walk, through, dimmed, particles);
  ray = through;
  throughput = dimmed;
  return meeting;
}

/// What arrives of a light at a point within `bodies`, dimmed by media, through boundaries that are passed straight;
/// black when anything else is in between.
Rgb arriving(const World& world, Walk& walk, Bodies bodies, glm::vec3 from, const LightSample& light);

/// The bodies that a point lies in: those that a ray from it leaves without having entered them.
Bodies bodies_at(const Scene& scene, const Tracer& tracer, glm::vec3 point);

/// Does any material enclose something, or a medium fill the scene?
bool has_bodies(const Scene& scene);

/// Errors: std::invalid_argument for media and interiors that break the rules of scene.h.
void check_media(const Scene& scene);

}  // namespace heckbert::transport
