#include <heckbert/transport/vertex.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include <heckbert/transport/fault.h>
#include <heckbert/transport/texture.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

namespace {

/// The factor by which a planted fault makes the value of a lobe wrong.
float error_of(Fault fault, const LightSample& light, float cosine, float importance_weight, bool is_glossy) {
  switch (fault) {
    case Fault::None:
      return 1;
    case Fault::HalvedLobe:
      return is_glossy ? 0.5f : 1.0f;
    case Fault::DroppedWeight:
      return 1 / importance_weight;
    case Fault::MissingCosine:
      return 1 / cosine;
    case Fault::WrongLightDensity:
      return light.source.type == LightSource::Type::Emitter && light.source.index == 0 ? 0.5f : 1.0f;
  }
  return 1;
}

/// Calls per_lobe(event, value) for each lobe that sends a light back. `arriving(transmitted)` asks what of the light
/// comes to that side of the surface.
template <class Arriving, class PerLobe>
void scatter_light(const World& world, const Vertex& vertex, const DirectLight& rule, const LightSample& light,
                   const Arriving& arriving, const PerLobe& per_lobe) {
  const glm::vec3 wi = vertex.local(light.direction);
  if (wi.z == 0) return;
  const bool transmitted = wi.z < 0;
  if (transmitted && !vertex.transmits) return;
  const Rgb radiance = arriving(transmitted);
  if (is_black(radiance)) return;
  const Vertex::Values values = vertex.values(wi);
  const float cosine = std::abs(wi.z);
  const float importance_weight = rule.multiple_importance && !light.is_delta
                                      ? power_heuristic(light.pdf_solid_angle, values.pdf_solid_angle)
                                      : 1.0f;
  const Rgb incident = radiance * (cosine / light.pdf_solid_angle * importance_weight);
  const std::span<const Lobe> lobes = vertex.lobes();
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    if (is_black(values.f[i])) continue;
    const taxonomy::Symbol event = letter(lobes[i], transmitted);
    const bool is_diffuse = taxonomy::facts(event).letter == 'D';
    if (!rule.glossy && !is_diffuse) continue;
    const bool has_own_weight = rule.follows_glossy && !is_diffuse && !light.is_delta;
    const float own_weight =
        has_own_weight
            ? power_heuristic(light.pdf_solid_angle, pdf_solid_angle(lobes[i], vertex.wo, wi, vertex.hit.front))
            : 1.0f;
    Rgb value = values.f[i] * incident * own_weight;
    if (world.fault != Fault::None) [[unlikely]]
      value *= error_of(world.fault, light, cosine, importance_weight * own_weight, !is_diffuse);
    per_lobe(event, value);
  }
}

/// Next-event estimation without words: calls per_lobe(event, light, value).
template <class PerLobe>
void estimate_direct_light(const World& world, Walk& walk, const Vertex& vertex, const DirectLight& rule,
                           const PerLobe& per_lobe) {
  const LightSample light = world.lights.sample(vertex.hit.position, walk.sampler);
  if (!(light.pdf_solid_angle > 0)) return;
  const auto arriving = [&](bool transmitted) {
    return arriving_light(world, walk, vertex, transmitted, leave(vertex.hit, vertex.hit.front != transmitted), light);
  };
  scatter_light(world, vertex, rule, light, arriving,
                [&](taxonomy::Symbol event, Rgb value) { per_lobe(event, light, value); });
}

/// Finds the path from the light by way of the vertex.
void find_light(const World& world, Walk& walk, const Vertex& vertex, taxonomy::WordTrie::Node node,
                taxonomy::Symbol event, const LightSample& light, Rgb value) {
  const taxonomy::WordTrie::Node scattered = walk.step(node, event, world.labels.surface(vertex.hit));
  walk.find({walk.step(scattered, light.kind, world.labels.light(light.source)), value, record::Technique::NextEvent},
            light);
}

/// On the silhouette of a sphere the cosine may round to the wrong sign; the side is known, so it is only small.
void keep_above(glm::vec3& wo) {
  constexpr float kSmallestCosine = 1e-6f;
  if (wo.z >= kSmallestCosine) return;
  wo.z = kSmallestCosine;
  wo = glm::normalize(wo);
}

}  // namespace

TrailVertex trail_vertex(const record::Contribution& contribution, const LightSample& light) {
  const auto ratio = [](float value, float radiance) { return radiance > 0 ? value / radiance : 0.0f; };
  const Rgb value = contribution.value, radiance = light.radiance;
  const Rgb throughput{ratio(value.r, radiance.r), ratio(value.g, radiance.g), ratio(value.b, radiance.b)};
  return {light.infinite ? light.direction : light.target, throughput, light.infinite};
}

Rgb arriving_light(const World& world, Walk& walk, const Vertex& vertex, bool transmitted, glm::vec3 origin,
                   const LightSample& light, Passage* passage) {
  if (world.has_bodies) {
    Bodies bodies = walk.bodies;
    if (transmitted) bodies.cross(world.scene, vertex.hit.material, vertex.hit.front);
    return arriving(world, walk.rays, bodies, origin, light, passage);
  }
  ++walk.rays;
  const Ray ray{origin, light.direction};
  if (light.to_be_met != kNoEmitter) {
    const std::optional<Hit> met = world.tracer.intersect(ray);
    return met && met->emitter == light.to_be_met ? world.lights.emitted(*met) : Rgb{};
  }
  const bool occluded = light.infinite ? world.tracer.is_occluded(ray) : world.tracer.is_occluded(origin, light.target);
  return occluded ? Rgb{} : light.radiance;
}

glm::vec3 mapped_normal(const Scene& scene, const Material& material, const Hit& hit) {
  const Frame unmapped = Frame::along(hit.normal_shading, hit.along_u);
  const float handedness = glm::dot(unmapped.t, hit.along_v) < 0 ? -1.0f : 1.0f;
  const glm::vec3 n = mapped_normal(scene, *material.normal_map, hit.uv);
  return unmapped.to_world({n.x, handedness * n.y, n.z});
}

Vertex::Vertex(const Scene& scene, const Hit& found, glm::vec3 ray_direction, float index_in_front)
    : hit(found), material(&scene.materials[found.material]) {
  if (!hit.has_coordinates && hit.normal_shading == hit.normal_geometric) [[likely]] {
    frame = Frame::around(hit.front ? hit.normal_shading : -hit.normal_shading);
    wo = frame.to_local(-ray_direction);
  } else {
    shade_with_first_valid(scene, ray_direction);
  }
  keep_above(wo);

  lobe_count_ = hit.front || material->lobe_sides == Sides::Both ? material->lobes.size() : 0;
  const bool is_textured = hit.has_coordinates && !material->textures.empty();
  if (is_textured || index_in_front != 1)
    std::copy(material->lobes.begin(), material->lobes.end(), lobes_here_.emplace().begin());
  if (index_in_front != 1) {
    for (Lobe& lobe : *lobes_here_) {
      if (auto* glass = std::get_if<Dielectric>(&lobe)) glass->ior /= index_in_front;
      if (auto* rough = std::get_if<RoughDielectric>(&lobe)) rough->ior /= index_in_front;
    }
  }
  if (is_textured) {
    for (const LobeTexture& use : material->textures) apply_texture(scene, use, hit.uv, (*lobes_here_)[use.lobe]);
  }
  const std::span<const Lobe> here = lobes();
  has_choice = here.size() > 1;
  for (std::size_t i = 0; i < here.size(); ++i) {
    selection[i] = selection_weight(here[i], wo);
    total_weight += selection[i];
    has_non_delta |= !is_delta(here[i]);
    transmits |= transport::transmits(here[i]);
    has_choice |= is_branching(here[i]);
  }
  if (here.size() == 1 && total_weight > 0) selection[0] = 1;
  if (here.size() > 1 && total_weight > 0)
    for (std::size_t i = 0; i < here.size(); ++i) selection[i] /= total_weight;
}

void Vertex::shade_with_first_valid(const Scene& scene, glm::vec3 ray_direction) {
  const auto shade_with = [&](glm::vec3 normal) {
    const glm::vec3 n = hit.front ? normal : -normal;
    frame = hit.has_coordinates ? Frame::along(n, hit.along_u) : Frame::around(n);
    wo = frame.to_local(-ray_direction);
  };
  const bool is_flat = hit.normal_shading == hit.normal_geometric;
  if (hit.has_coordinates && material->normal_map) {
    shade_with(mapped_normal(scene, *material, hit));
    normal_ = is_valid(wo) ? Normal::First : Normal::Other;
    if (normal_ == Normal::First) return;
  } else if (!is_flat) {
    normal_ = Normal::First;
  }
  shade_with(hit.normal_shading);
  if (is_flat || is_valid(wo)) return;
  shade_with(hit.normal_geometric);
  normal_ = Normal::Other;
}

bool Vertex::is_valid(glm::vec3 wo_local) const {
  const float side = hit.front ? 1.0f : -1.0f;
  return wo_local.z > 0 && side * glm::dot(frame.to_world(mirrored(wo_local)), hit.normal_geometric) > 0;
}

glm::vec3 Vertex::as_seen_from(glm::vec3 to_walk) const {
  const bool same_side = (glm::dot(to_walk, hit.normal_geometric) > 0) == hit.front;
  glm::vec3 from = frame.to_local(to_walk);
  if (!same_side || normal_ == Normal::Other || (normal_ == Normal::First && !is_valid(from)))
    from.z = 0;
  else
    keep_above(from);
  return from;
}

Vertex::Values Vertex::values(glm::vec3 wi) const {
  Values values;
  const std::span<const Lobe> here = lobes();
  values.lobes = here.size();
  for (std::size_t i = 0; i < here.size(); ++i) {
    const LobeValue value = value_and_pdf(here[i], wo, wi, hit.front);
    values.f[i] = value.f;
    values.pdf_solid_angle += selection[i] * value.pdf_solid_angle;
  }
  return values;
}

float Vertex::pdf_solid_angle(glm::vec3 wi) const {
  float pdf = 0;
  const std::span<const Lobe> here = lobes();
  for (std::size_t i = 0; i < here.size(); ++i)
    pdf += selection[i] * transport::pdf_solid_angle(here[i], wo, wi, hit.front);
  return pdf;
}

Vertex::Values Vertex::values(glm::vec3 from, glm::vec3 wi) const {
  Values values;
  const std::span<const Lobe> here = lobes();
  values.lobes = here.size();
  float total = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const LobeValue value = value_and_pdf(here[i], from, wi, hit.front);
    const float weight = selection_weight(here[i], from);
    values.f[i] = value.f;
    values.pdf_solid_angle += weight * value.pdf_solid_angle;
    total += weight;
  }
  if (total > 0) values.pdf_solid_angle /= total;
  return values;
}

float Vertex::pdf_solid_angle(glm::vec3 from, glm::vec3 wi) const {
  const std::span<const Lobe> here = lobes();
  float pdf = 0, total = 0;
  for (const Lobe& lobe : here) {
    const float weight = selection_weight(lobe, from);
    pdf += weight * transport::pdf_solid_angle(lobe, from, wi, hit.front);
    total += weight;
  }
  return total > 0 ? pdf / total : 0.0f;
}

void gather_direct_light(const World& world, Walk& walk, const Vertex& vertex, taxonomy::WordTrie::Node node,
                         Rgb throughput, const DirectLight& rule) {
  estimate_direct_light(world, walk, vertex, rule, [&](taxonomy::Symbol event, const LightSample& light, Rgb value) {
    find_light(world, walk, vertex, node, event, light, throughput * value);
  });
}

void gather_unshadowed_light(const World& world, Walk& walk, const Vertex& vertex, taxonomy::WordTrie::Node node,
                             Rgb throughput, const LightSample& light) {
  const auto unshadowed = [&](bool) { return light.radiance; };
  scatter_light(world, vertex, {}, light, unshadowed, [&](taxonomy::Symbol event, Rgb value) {
    find_light(world, walk, vertex, node, event, light, throughput * value);
  });
}

Rgb ambient_reflectance(const Vertex& vertex) {
  Rgb k_a;
  for (const Lobe& lobe : vertex.lobes()) k_a += diffuse_albedo(lobe);
  return vertex.material->ambient_reflectance.value_or(k_a);
}

Rgb direct_light(const World& world, Walk& walk, const Vertex& vertex, const DirectLight& rule) {
  Rgb sum;
  estimate_direct_light(world, walk, vertex, rule,
                        [&](taxonomy::Symbol, const LightSample&, Rgb value) { sum += value; });
  return sum;
}

void add_hit(Walk& walk, taxonomy::WordTrie::Node node, taxonomy::Symbol kind, Labels::Id label, Rgb value) {
  walk.find({walk.step(node, kind, label), value, record::Technique::Hit});
}

}  // namespace heckbert::transport
