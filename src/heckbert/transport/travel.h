#pragma once
// How a ray gets from one event to the next when there are bodies and media on its way. Boundaries that are not there
// to be seen, because they are index-matched or hidden by a body of higher priority, are passed straight and leave no
// letter; a medium dims the ray and may scatter it, which is the letter V. A scene without either pays one test.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// What an edge of a path goes through: media, and boundaries that are passed straight. From its other end it is the
/// same, but for the two rates, which change places.
struct Passage {
  Rgb transmittance{1.0f};  ///< black: something is in between
  float chance = 1;         ///< of free flights along it, from whichever end, to get through
  /// Where it begins, and where it ends: with which a flight that got through ends at a particle there, per length.
  float rate_begin = 0, rate_end = 0;
};

/// What a ray met: a surface, or a particle at the ray's new origin, or neither: it left the scene.
struct Meeting {
  std::optional<Hit> hit;
  bool scattered = false;
};

enum class Particles : std::uint8_t {
  Scatter,  ///< light that meets a particle goes on as V
  Dim       ///< it is lost, for algorithms whose words have no V
};

/// What a walk has that travelling changes.
struct Traveller {
  Bodies& bodies;  ///< that it is in
  Sampler& sampler;
  std::uint64_t& rays;
  bool from_infinity = false;  ///< the ray begins infinitely far away, and its origin is only on its way
};

Meeting travel_through_bodies(const World& world, Traveller traveller, Ray& ray, Rgb& throughput, Particles particles,
                              Passage* passage);

/// Moves the ray's origin to the last boundary it passed, or to the particle; keeps the bodies; multiplies the
/// throughput by what the media did, over the density of what was drawn. Tells of the passage where it is asked to.
inline Meeting travel(const World& world, Traveller traveller, Ray& ray, Rgb& throughput, Particles particles,
                      Passage* passage = nullptr) {
  if (!world.has_bodies) [[likely]] {
    ++traveller.rays;
    return {world.tracer.intersect(ray), false};
  }
  // Copies, so that where there are no bodies nobody has the address of the tracer's ray and throughput, and they can
  // stay in registers.
  Ray through = ray;
  Rgb dimmed = throughput;
  const Meeting meeting = travel_through_bodies(world, traveller, through, dimmed, particles, passage);
  ray = through;
  throughput = dimmed;
  return meeting;
}
inline Meeting travel(const World& world, Walk& walk, Ray& ray, Rgb& throughput,
                      Particles particles = Particles::Scatter, Passage* passage = nullptr) {
  return travel(world, Traveller{walk.bodies, walk.sampler, walk.rays}, ray, throughput, particles, passage);
}

/// What arrives of a light at a point within `bodies`, dimmed by media, through boundaries that are passed straight;
/// black when anything else is in between. Tells of the passage where it is asked to.
Rgb arriving(const World& world, std::uint64_t& rays, Bodies bodies, glm::vec3 from, const LightSample& light,
             Passage* passage = nullptr);

/// The same of any two points; and of a point and what is infinitely far away.
Passage passage_between(const World& world, std::uint64_t& rays, const Bodies& bodies, glm::vec3 from, glm::vec3 to);
Passage passage_to_infinity(const World& world, std::uint64_t& rays, const Bodies& bodies, const Ray& ray);

/// The bodies that a point lies in: those that a ray from it leaves without having entered them.
Bodies bodies_at(const Scene& scene, const Tracer& tracer, glm::vec3 point);

/// Does any material enclose something, or a medium fill the scene?
bool has_bodies(const Scene& scene);

/// Errors: std::invalid_argument for media and interiors that break the rules of scene.h.
void check_media(const Scene& scene);

}  // namespace heckbert::transport
