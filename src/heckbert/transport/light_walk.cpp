#include <heckbert/transport/light_walk.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace heckbert::transport {

namespace {

/// The hit as a ray from the side that `direction` points to would have found it.
Hit seen_from(const Hit& hit, glm::vec3 direction) {
  Hit seen = hit;
  seen.front = glm::dot(direction, hit.normal_geometric) > 0;
  return seen;
}

bool is_same_side(const Hit& hit, glm::vec3 a, glm::vec3 b) {
  return (glm::dot(a, hit.normal_geometric) > 0) == (glm::dot(b, hit.normal_geometric) > 0);
}

bool transmits(const Material& material) {
  return std::ranges::any_of(material.lobes, [](const Lobe& lobe) { return transport::transmits(lobe); });
}

/// scatter() at a surface, which is `vertex` as the eye's side sees it, along wo. Takes: a black result.
void scatter_at_surface(Scattering& result, const Vertex& vertex, glm::vec3 wo, const LightVertex& at,
                        glm::vec3 to_eye) {
  const glm::vec3 wi = vertex.local(at.to_light);
  const float cos_light = cosine(at.hit, at.to_light);
  if (wi.z == 0 || !(cos_light > 0)) return;
  const Vertex::Values values = vertex.values(wo, wi);
  const std::span<const Lobe> lobes = vertex.lobes();
  result.lobes = lobes.size();
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    result.f[i] = values.f[i] * (std::abs(wi.z) * cosine(at.hit, to_eye) / cos_light);
    result.letters[i] = letter(lobes[i], wi.z < 0);
  }
  result.pdf_to_light = values.pdf_solid_angle;
}

/// How a walk from the light goes on.
struct Onward {
  Ray ray{};
  Event event{};
  Rgb factor;                ///< black: it does not
  bool transmitted = false;  ///< through the surface
  Step step{};
};

Onward scatter_at_particle(const World& world, const LightVertex& at, Sampler& sampler) {
  const Continuation next = follow_particle(*at.particle, {at.hit.position, -at.to_light}, sampler);
  return {
      .ray = next.ray,
      .event = {next.event, world.labels.particle(*at.particle)},
      .factor = next.factor,
      .step = {.is_from_particle = true, .pdf_solid_angle = next.pdf_solid_angle, .pdf_reverse = next.pdf_solid_angle}};
}

/// Normals nearer than this are one, and were only rounded differently.
constexpr float kSameNormal = 1e-4f;

/// Is the vertex shaded with the same normal when it is seen from the other side of the event?
bool is_shaded_alike(const Scene& scene, const Vertex& vertex, glm::vec3 other_side) {
  if (vertex.has_one_normal()) return true;
  const Hit seen = seen_from(vertex.hit, other_side);
  const Vertex other(scene, seen, -other_side);
  const glm::vec3 normal = seen.front == vertex.hit.front ? other.frame.n : -other.frame.n;
  return glm::distance(normal, vertex.frame.n) < kSameNormal;
}

/// How an event of a Dirac goes on towards the eye.
struct DiracEvent {
  Continuation next{};
  float correction = 1;  ///< of the factor, for cosines that a walk from the eye does not see (Veach 1997, 5.3)
};

/// The event that the vertex makes of the draw; black also where a walk from the eye would not come back that way.
DiracEvent follow_dirac(const Scene& scene, const Vertex& vertex, const Drawn& drawn, float cos_light) {
  DiracEvent event{.next = follow_delta(vertex, drawn)};
  if (is_black(event.next.factor)) return event;
  const glm::vec3 to_eye = event.next.ray.direction;
  const float cos_eye_shading = std::abs(vertex.frame.to_local(to_eye).z);
  if (!(cos_eye_shading > 0) || !is_shaded_alike(scene, vertex, to_eye)) return {};
  event.correction = vertex.wo.z * cosine(vertex.hit, to_eye) / (cos_light * cos_eye_shading);
  return event;
}

/// A walk from the eye that comes to the surface may see another normal than one from the light (Vertex), and for a
/// Dirac each normal has a way of its own: the light goes on by any way that a walk from the eye would come.
DiracEvent draw_dirac(const Scene& scene, const LightVertex& at, const Drawn& drawn, float cos_light,
                      Sampler& sampler) {
  if (at.surface->has_one_normal()) return follow_dirac(scene, *at.surface, drawn, cos_light);
  const Hit& hit = at.hit;
  std::array<glm::vec3, 3> normals{hit.normal_shading, hit.normal_geometric};
  std::size_t number = 2;
  if (hit.has_coordinates && at.surface->material->normal_map)
    normals[number++] = mapped_normal(scene, *at.surface->material, hit);
  DiracEvent chosen;
  float found = 0;
  for (std::size_t i = 0; i < number; ++i) {
    const auto is_same = [&](glm::vec3 before) { return glm::distance(before, normals[i]) < kSameNormal; };
    if (std::any_of(normals.begin(), normals.begin() + static_cast<std::ptrdiff_t>(i), is_same)) continue;
    Vertex shaded = *at.surface;
    shaded.frame = Frame::around(hit.front ? normals[i] : -normals[i]);
    shaded.wo = shaded.frame.to_local(at.to_light);
    if (!(shaded.wo.z > 0)) continue;
    const DiracEvent event = follow_dirac(scene, shaded, drawn, cos_light);
    if (is_black(event.next.factor)) continue;
    ++found;
    if (found == 1 || sampler.next() * found < 1) chosen = event;
  }
  chosen.next.factor *= found;
  return chosen;
}

Onward scatter_at_surface(const World& world, const LightVertex& at, Sampler& sampler) {
  const Vertex& vertex = *at.surface;
  const std::optional<Drawn> drawn = draw_lobe(vertex, sampler);
  if (!drawn) return {};
  const Labels::Id label = world.labels.surface(at.hit);
  const float cos_light = cosine(at.hit, at.to_light);
  if (!(cos_light > 0)) return {};

  if (is_delta(vertex.lobes()[drawn->index])) {
    const auto [next, correction] = draw_dirac(world.scene, at, *drawn, cos_light, sampler);
    if (is_black(next.factor)) return {};
    return {.ray = next.ray,
            .event = {next.event, label},
            .factor = next.factor * (correction / next.radiance_scale),
            .transmitted = next.transmitted,
            .step = {.is_delta = true, .pdf_reverse = 1, .facing_from = cosine(at.hit, next.ray.direction)}};
  }

  const glm::vec3 out = draw_direction(vertex, *drawn, sampler);
  if (out.z == 0) return {};
  const float pdf = vertex.pdf_solid_angle(out);
  if (!(pdf > 0)) return {};
  const Ray ray = vertex.leave(out, out.z < 0);
  const Scattering scattering = scatter(world.scene, at, ray.direction);
  const ChosenLobe lobe = choose_lobe(scattering.of_lobes(), sampler);
  if (!(lobe.share > 0)) return {};
  return {.ray = ray,
          .event = {scattering.letters[lobe.index], label},
          .factor = scattering.f[lobe.index] / (pdf * lobe.share),
          .transmitted = out.z < 0,
          .step = {.pdf_solid_angle = pdf,
                   .pdf_reverse = scattering.pdf_to_light,
                   .facing_from = cosine(at.hit, ray.direction)}};
}

/// The rivals where the first step ends: hitting the light, and asking for it with `pdf_next_event` there. Per area,
/// direction or light, as Departure::pdf_place is.
Rivals first_rivals(const Emitted& start, double pdf_next_event, const Step& step) {
  const Departure& d = start.departure;
  const double reached = d.pdf * step.facing_to / step.squared_distance;
  const double seen = d.cosine / step.squared_distance;
  return {squared(pdf_next_event / reached), start.is_delta ? 0 : squared(seen / reached)};
}

/// With which next-event estimation at `from` would have drawn the place where the walk began, as pdf_place is.
double pdf_next_event(const World& world, const Emitted& start, glm::vec3 from) {
  switch (start.source.type) {
    case LightSource::Type::Emitter: {
      Hit place{};
      place.position = start.ray.origin;
      place.normal_geometric = start.normal;
      place.emitter = start.source.index;
      const glm::vec3 d = start.ray.origin - from;
      return static_cast<double>(world.lights.pdf_solid_angle(place, from) * start.departure.cosine / glm::dot(d, d));
    }
    case LightSource::Type::Environment:
      return static_cast<double>(world.lights.pdf_environment(-start.ray.direction));
    default:
      return static_cast<double>(world.lights.probability(start.source, from));
  }
}

}  // namespace

Rivals rivals_after(const Rivals& before, const Step& step) {
  if (step.is_delta) return {0, squared(step.pdf_reverse * step.facing_from / step.facing_to) * before.far};
  const double reached = step.pdf_solid_angle * step.facing_to;
  return {squared(step.squared_distance / reached),
          squared(step.facing_from / reached) * (before.near + squared(step.pdf_reverse) * before.far)};
}

bool can_be_joined(const LightVertex& at) {
  return !at.surface ||
         std::ranges::any_of(at.surface->material->lobes, [](const Lobe& lobe) { return !is_delta(lobe); });
}

Scattering scatter(const Scene& scene, const LightVertex& at, glm::vec3 to_eye) {
  Scattering result;
  if (!at.surface) {
    result.lobes = 1;
    result.pdf_to_light = pdf_to_eye(at, to_eye);
    result.f[0] = Rgb(result.pdf_to_light);
    result.letters[0] = taxonomy::Symbol::V;
    return result;
  }
  // Most surfaces reflect and are seen with one normal: then the vertex that the light came to will do.
  if (const glm::vec3 from = at.surface->as_seen_from(to_eye); from.z > 0) {
    scatter_at_surface(result, *at.surface, from, at, to_eye);
  } else if (is_same_side(at.hit, to_eye, at.to_light) || transmits(*at.surface->material)) {
    const Hit seen = seen_from(at.hit, to_eye);
    const Vertex from_eye(scene, seen, -to_eye, at.index_in_front);
    scatter_at_surface(result, from_eye, from_eye.wo, at, to_eye);
  }
  return result;
}

float pdf_to_eye(const LightVertex& at, glm::vec3 to_eye) {
  if (!at.surface) return phase(at.particle->anisotropy, glm::dot(-at.to_light, to_eye));
  const glm::vec3 out = at.surface->local(to_eye);
  return out.z == 0 ? 0.0f : at.surface->pdf_solid_angle(out);
}

float pdf_from_light(const Scene& scene, const Vertex& vertex, float index_in_front, glm::vec3 to_light,
                     glm::vec3 to_eye) {
  if (const glm::vec3 from = vertex.as_seen_from(to_light); from.z > 0) return vertex.pdf_solid_angle(from, vertex.wo);
  const Hit seen = seen_from(vertex.hit, to_light);
  const Vertex from_light(scene, seen, -to_light, index_in_front);
  const glm::vec3 out = from_light.local(to_eye);
  return out.z == 0 ? 0.0f : from_light.pdf_solid_angle(out);
}

LightWalk walk_from_light(const World& world, std::uint64_t& rays, Sampler& sampler, Particles particles,
                          int roulette_start) {
  LightWalk light{.start = world.emission.sample(sampler)};
  if (!light.start) return light;
  const Emitted& start = *light.start;
  Ray ray = start.ray;
  Bodies bodies = world.has_bodies && !start.infinite ? bodies_at(world.scene, world.tracer, ray.origin) : Bodies{};
  Rgb reflected(1.0f);  // of what left the light
  Step step;
  const auto arrive = [&](const Passage& passage, float facing, double squared_distance, double pdf_of_rival) {
    const bool is_first = light.vertices.empty();
    step.end(passage, static_cast<double>(facing), is_first && start.infinite ? 1.0 : squared_distance);
    return is_first ? first_rivals(start, pdf_of_rival, step) : rivals_after(light.vertices.back().rivals, step);
  };
  const auto come_through_lens = [&](const Sight& sight, glm::vec3 from, const Passage& passage, Rgb sent) {
    if (is_black(passage.transmittance)) return;
    const glm::vec3 d = sight.from - from;
    const Rivals rivals = arrive(passage, world.eye.cosine(sight.direction), static_cast<double>(glm::dot(d, d)),
                                 static_cast<double>(start.departure.pdf_place));
    light.through_lens.push_back({light.vertices.size(), sight, sent * passage.transmittance / passage.chance, rivals});
  };
  for (;;) {
    const Ray edge = ray;
    const Bodies around = bodies;
    const Rgb sent = start.throughput * reflected;
    const bool from_infinity = start.infinite && light.vertices.empty();
    Passage passage;
    const auto [hit, scattered] =
        travel(world, {bodies, sampler, rays, from_infinity}, ray, reflected, particles, &passage);
    if (from_infinity && is_black(reflected)) return light;
    const glm::vec3 position = hit ? hit->position : ray.origin;
    const float farthest =
        hit || scattered ? glm::distance(position, edge.origin) : std::numeric_limits<float>::infinity();
    if (const Sight sight = world.eye.sight_met_by(edge, farthest); sight.is_seen()) {
      Passage to_lens;
      if (world.has_bodies)
        to_lens = from_infinity ? passage_to_infinity(world, rays, world.bodies_at_eye, {sight.from, sight.direction})
                                : passage_between(world, rays, around, edge.origin, sight.from);
      come_through_lens(sight, edge.origin, to_lens, sent);
    }
    if (!(hit || scattered) || light.vertices.size() == static_cast<std::size_t>(world.max_depth)) return light;
    const float facing = hit ? cosine(*hit, ray.direction) : passage.rate_end;
    if (!(facing > 0) || is_black(reflected)) return light;
    const Rivals rivals = arrive(passage, facing, squared(static_cast<double>(farthest)),
                                 light.vertices.empty() ? pdf_next_event(world, start, position) : 0.0);
    const Rgb arriving = start.throughput * reflected;
    LightVertex& at = hit ? light.vertices.emplace_back(world, *hit, ray.direction, bodies, arriving)
                          : light.vertices.emplace_back(world, position, ray.direction, bodies, arriving);
    at.rivals = rivals;
    if (hit) at.rivals.near += squared(world.merging);

    const Onward onward = hit ? scatter_at_surface(world, at, sampler) : scatter_at_particle(world, at, sampler);
    if (is_black(onward.factor)) return light;
    reflected *= onward.factor;
    const auto scatterings = static_cast<int>(light.vertices.size());
    const float left = onward.step.is_delta ? 1.0f : max_channel(onward.factor);
    if (!survives_from(roulette_start, sampler, reflected, 1, left, scatterings)) return light;
    light.events.push_back(onward.event);
    if (onward.transmitted && world.has_bodies) bodies.cross(world.scene, hit->material, hit->front);
    step = onward.step;
    ray = onward.ray;
  }
}

taxonomy::WordTrie::Node spell(const World& world, Walk& walk, taxonomy::WordTrie::Node node, const LightWalk& light,
                               std::size_t count) {
  for (std::size_t i = count; i-- > 0;) node = walk.step(node, light.events[i].symbol, light.events[i].label);
  return walk.step(node, light.start->kind, world.labels.light(light.start->source));
}

}  // namespace heckbert::transport
