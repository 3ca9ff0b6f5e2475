#include <heckbert/transport/local_shading.h>

#include <cmath>

#include <heckbert/transport/delta_lights.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;
using taxonomy::Symbol;
using Type = LightSource::Type;

namespace {

/// Adds what one light sends to the eye by way of the vertex.
void shade(const World& world, Walk& walk, const Vertex& vertex, Rgb weight, Symbol kind, const DeltaSample& light,
           LightSource source) {
  const glm::vec3 wi = vertex.local(light.direction);
  if (wi.z == 0 || (wi.z < 0 && !vertex.transmits)) return;
  const Vertex::Values values = vertex.values(wi);
  const std::span<const Lobe> lobes = vertex.lobes();
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    if (is_black(values.f[i])) continue;
    const auto node = walk.step(walk.sink.words().eye(world.eye.kind()), letter(lobes[i], wi.z < 0),
                                world.labels.surface(vertex.hit));
    walk.find({walk.step(node, kind, world.labels.light(source)),
               weight * values.f[i] * light.irradiance * std::abs(wi.z), record::Technique::NextEvent});
  }
}

void shade_by_all(const World& world, Walk& walk, const Vertex& vertex, Rgb weight) {
  const Scene& scene = world.scene;
  const auto add = [&](Symbol kind, const std::optional<DeltaSample>& light, Type type, std::uint32_t index) {
    if (light) shade(world, walk, vertex, weight, kind, *light, {type, index});
  };
  const glm::vec3 place = vertex.hit.position;
  for (std::uint32_t i = 0; i < scene.point_lights.size(); ++i)
    add(Symbol::Lp, sample_delta(scene.point_lights[i], place), Type::Point, i);
  for (std::uint32_t i = 0; i < scene.spot_lights.size(); ++i)
    add(Symbol::Lp, sample_delta(scene.spot_lights[i], place), Type::Spot, i);
  for (std::uint32_t i = 0; i < scene.distant_lights.size(); ++i)
    add(Symbol::Ld, sample_delta(scene.distant_lights[i]), Type::Distant, i);
}

}  // namespace

void shade_locally(const World& world, Walk& walk, Ray ray) {
  Rgb weight(1.0f);
  const std::optional<Hit> hit = travel(world, walk, ray, weight, Particles::Dim).hit;
  if (!hit) return walk.sink.end_path(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
  walk.arrive(0, {hit->position, weight});
  const Vertex vertex = vertex_at(world, walk, *hit, ray.direction);
  if (const Rgb ambient = ambient_reflectance(vertex) * world.scene.ambient; !is_black(ambient))
    walk.sink.add_non_path(record::NonPath::Ambient, weight * ambient);
  if (world.max_depth > 0) {
    shade_by_all(world, walk, vertex, weight);
    return walk.sink.end_path(PathEnd::Absorbed);
  }
  walk.sink.end_path(PathEnd::DepthLimit);
  if (walk.sampler.next() >= PastTheLimit::kShare) return;
  const PastTheLimit unrecorded(walk);
  shade_by_all(world, walk, vertex, weight);
}

}  // namespace heckbert::transport
