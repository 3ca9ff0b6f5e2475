#include <heckbert/transport/local_shading.h>

#include <heckbert/transport/delta_lights.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;
using taxonomy::Symbol;
using Type = LightSource::Type;

namespace {

void shade_by_all(const World& world, Walk& walk, const Vertex& vertex, Rgb weight) {
  const Scene& scene = world.scene;
  const taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  const auto add = [&](Symbol kind, const std::optional<DeltaSample>& light, LightSource source, glm::vec3 target) {
    if (light)
      gather_unshadowed_light(world, walk, vertex, node, weight,
                              {.kind = kind,
                               .direction = light->direction,
                               .target = target,
                               .infinite = kind == Symbol::Ld,
                               .radiance = light->irradiance,
                               .pdf_solid_angle = 1,
                               .is_delta = true,
                               .source = source});
  };
  const glm::vec3 place = vertex.hit.position;
  for (std::uint32_t i = 0; const PointLight& light : scene.point_lights)
    add(Symbol::Lp, sample_delta(light, place), {Type::Point, i++}, light.position);
  for (std::uint32_t i = 0; const SpotLight& light : scene.spot_lights)
    add(Symbol::Lp, sample_delta(light, place), {Type::Spot, i++}, light.position);
  for (std::uint32_t i = 0; const DistantLight& light : scene.distant_lights)
    add(Symbol::Ld, sample_delta(light), {Type::Distant, i++}, {});
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
