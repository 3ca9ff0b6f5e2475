#pragma once
// Walks from the eye that run into a light. Where next-event estimation could have found the same path, both are
// weighed against each other (Veach 1997, 9.2).

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// The ray of a walk, as next-event estimation at its origin is weighed against it.
struct Approach {
  float pdf_solid_angle = 0;  ///< with which the ray was drawn; 0: what it runs into has no other way to be found
  glm::vec3 from{0};          ///< the vertex where it begins
};

/// What a walk along `direction` sees infinitely far away, weighed.
inline Rgb sky_met(const World& world, glm::vec3 direction, const Approach& approach) {
  const Rgb sky = world.lights.environment(direction);
  if (is_black(sky) || !(approach.pdf_solid_angle > 0)) return sky;
  return sky * power_heuristic(approach.pdf_solid_angle, world.lights.pdf_environment(direction));
}

/// What the surface that a walk came to emits, weighed.
inline Rgb lamp_met(const World& world, const Hit& hit, const Approach& approach) {
  const Rgb emitted = world.lights.emitted(hit);
  if (is_black(emitted) || !(approach.pdf_solid_angle > 0)) return emitted;
  return emitted * power_heuristic(approach.pdf_solid_angle, world.lights.pdf_solid_angle(hit, approach.from));
}

/// Finds the path to the sky, if it is not black; `node` is the word up to the light.
inline void run_into_sky(const World& world, Walk& walk, taxonomy::WordTrie::Node node, glm::vec3 direction,
                         Rgb throughput, const Approach& approach = {}) {
  if (const Rgb sky = sky_met(world, direction, approach); !is_black(sky))
    add_hit(walk, node, taxonomy::Symbol::Le, world.labels.light({LightSource::Type::Environment, 0}),
            throughput * sky);
}

/// Finds the path to the lamp, if the surface is one.
inline void run_into_lamp(const World& world, Walk& walk, taxonomy::WordTrie::Node node, const Hit& hit, Rgb throughput,
                          const Approach& approach = {}) {
  if (const Rgb emitted = lamp_met(world, hit, approach); !is_black(emitted))
    add_hit(walk, node, taxonomy::Symbol::La, world.labels.light({LightSource::Type::Emitter, hit.emitter}),
            throughput * emitted);
}

}  // namespace heckbert::transport
