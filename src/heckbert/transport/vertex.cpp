#include <heckbert/transport/vertex.h>

#include <algorithm>

#include <glm/geometric.hpp>

namespace heckbert::transport {

namespace {

/// Next-event estimation without words: calls per_lobe(lobe, light kind, value) for each lobe that sends light back.
template <class PerLobe>
void estimate_direct_light(const World& world, Walk& walk, const Vertex& vertex, const DirectLight& rule,
                           PerLobe per_lobe) {
  const std::optional<LightSample> light = world.lights.sample(vertex.hit.position, walk.sampler);
  if (!light) return;
  const std::optional<glm::vec3> wi = vertex.reflected(light->direction);
  if (!wi) return;
  const glm::vec3 origin = leave(vertex.hit, vertex.hit.front);
  ++walk.rays;
  if (light->infinite ? world.tracer.is_occluded(Ray{origin, light->direction})
                      : world.tracer.is_occluded(origin, light->target))
    return;
  float weight = wi->z / light->pdf_solid_angle;
  if (rule.multiple_importance && !light->is_delta)
    weight *= power_heuristic(light->pdf_solid_angle, vertex.pdf_solid_angle(*wi));
  const Rgb incident = light->radiance * weight;
  for (const Lobe& lobe : vertex.material->lobes) {
    if (!rule.glossy && letter(lobe) != taxonomy::Symbol::Dr) continue;
    if (const Rgb f = evaluate(lobe, vertex.wo, *wi); !is_black(f)) per_lobe(lobe, light->kind, f * incident);
  }
}

}  // namespace

Vertex::Vertex(const Scene& scene, const Hit& found, glm::vec3 ray_direction)
    : hit(found), material(&scene.materials[found.material]) {
  const float side = hit.front ? 1.0f : -1.0f;
  const auto shade_with = [&](glm::vec3 normal) {
    frame = Frame::around(side * normal);
    wo = frame.to_local(-ray_direction);
  };
  shade_with(hit.normal_shading);
  // An interpolated normal that looks away from the ray, or that would mirror it into the surface: shade with the flat
  // one, or a convex mirror would show itself at its rim.
  const glm::vec3 mirrored = frame.to_world({-wo.x, -wo.y, wo.z});
  if (wo.z <= 0 || side * glm::dot(mirrored, hit.normal_geometric) <= 0) shade_with(hit.normal_geometric);
  // On the silhouette of a sphere the cosine may round to the wrong sign; the side is known, so it is only small.
  constexpr float kSmallestCosine = 1e-6f;
  if (wo.z < kSmallestCosine) {
    wo.z = kSmallestCosine;
    wo = glm::normalize(wo);
  }
  for (std::size_t i = 0; i < material->lobes.size(); ++i) {
    selection[i] = selection_weight(material->lobes[i], wo);
    total_weight += selection[i];
    has_non_delta |= !is_delta(material->lobes[i]);
  }
  if (total_weight > 0)
    for (float& s : selection) s /= total_weight;
}

float Vertex::pdf_solid_angle(glm::vec3 wi) const {
  float pdf = 0;
  for (std::size_t i = 0; i < material->lobes.size(); ++i)
    pdf += selection[i] * transport::pdf_solid_angle(material->lobes[i], wo, wi);
  return pdf;
}

std::optional<glm::vec3> Vertex::reflected(glm::vec3 world) const {
  const bool to_front = glm::dot(world, hit.normal_geometric) > 0;
  const glm::vec3 wi = frame.to_local(world);
  if (to_front != hit.front || wi.z <= 0) return std::nullopt;
  return wi;
}

Ray Vertex::leave(glm::vec3 wi, bool transmitted) const {
  return {transport::leave(hit, hit.front != transmitted), frame.to_world(wi)};
}

void gather_direct_light(const World& world, Walk& walk, const Vertex& vertex, taxonomy::WordTrie::Node node,
                         Rgb throughput, const DirectLight& rule) {
  estimate_direct_light(world, walk, vertex, rule, [&](const Lobe& lobe, taxonomy::Symbol kind, Rgb value) {
    walk.found.push_back(
        {walk.step(walk.step(node, letter(lobe)), kind), throughput * value, record::Technique::NextEvent});
  });
}

Rgb direct_light(const World& world, Walk& walk, const Vertex& vertex, const DirectLight& rule) {
  Rgb sum;
  estimate_direct_light(world, walk, vertex, rule, [&](const Lobe&, taxonomy::Symbol, Rgb value) { sum += value; });
  return sum;
}

void add_hit(Walk& walk, taxonomy::WordTrie::Node node, taxonomy::Symbol light, Rgb value) {
  walk.found.push_back({walk.step(node, light), value, record::Technique::Hit});
}

}  // namespace heckbert::transport
