#include <heckbert/transport/light_tracer.h>

#include <heckbert/transport/light_to_eye.h>
#include <heckbert/transport/light_walk.h>

namespace heckbert::transport {

void trace_from_light(const World& world, Walk& walk) {
  const LightWalk light = walk_from_light(world, walk.rays, walk.sampler, Particles::Scatter);
  splat(world, walk, light, walk.sampler, Rivalry::LightOnly);
}

}  // namespace heckbert::transport
