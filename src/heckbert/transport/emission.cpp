#include <heckbert/transport/emission.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/transport/delta_lights.h>
#include <heckbert/transport/frame.h>

namespace heckbert::transport {

using taxonomy::Symbol;
using Type = LightSource::Type;

namespace {

bool is_far(Type type) {
  return type == Type::Distant || type == Type::Environment;
}

/// Per steradian, of directions drawn evenly from the cone that a point light fills.
float cone_density(const SpotLight& spot) {
  return 1.0f / (2.0f * kPi * (1.0f - std::cos(glm::radians(spot.cutoff_degrees))));
}

/// A direction of even density within an angle of the axis.
glm::vec3 sample_cone(glm::vec3 axis, float cos_angle, glm::vec2 u) {
  const float z = 1.0f - u.x * (1.0f - cos_angle);
  const float r = std::sqrt(std::max(0.0f, 1.0f - z * z)), phi = 2.0f * kPi * u.y;
  return Frame::around(axis).to_world({r * std::cos(phi), r * std::sin(phi), z});
}

}  // namespace

Emission::Emission(const Scene& scene, const Tracer& tracer, const Lights& lights, glm::vec3 eye, float eye_radius)
    : scene_(scene), tracer_(tracer), lights_(lights) {
  std::vector<double> watts;
  for (const Lights::Power& light : lights.powers()) watts.push_back(light.watts);
  choice_ = DiscreteDistribution(std::move(watts));
  glm::vec3 low = eye - eye_radius, high = eye + eye_radius;
  if (const glm::vec3 l = tracer.bounds_low(), h = tracer.bounds_high(); std::isfinite(glm::distance(l, h))) {
    low = glm::min(low, l);
    high = glm::max(high, h);
  }
  center_ = 0.5f * (low + high);
  // A little more than half the diagonal, so that nothing lies on the rim.
  radius_ = std::max(0.501f * glm::distance(low, high), 1e-3f);
}

float Emission::chance_of(LightSource source) const {
  // The lights are in the order of their types, and of their indices within a type.
  const auto before = [](const Lights::Power& light, const LightSource& wanted) {
    return light.source.type != wanted.type ? light.source.type < wanted.type : light.source.index < wanted.index;
  };
  const auto& powers = lights_.powers();
  const auto at = std::lower_bound(powers.begin(), powers.end(), source, before);
  return static_cast<float>(choice_.probability(static_cast<std::size_t>(at - powers.begin())));
}

std::optional<Emitted> Emission::sample(Sampler& sampler) const {
  if (empty()) return std::nullopt;
  const std::size_t light = choice_.sample(sampler.next_fine()).index;
  const auto chance = static_cast<float>(choice_.probability(light));
  const LightSource source = lights_.powers()[light].source;
  if (source.type == Type::Emitter) return from_emitter(source.index, chance, sampler);
  return is_far(source.type) ? from_far(source, chance, sampler) : from_point(source, chance, sampler);
}

Departure Emission::from_area(std::uint32_t emitter, float cosine) const {
  const Emitter& e = tracer_.emitters()[emitter];
  const float sides = scene_.materials[e.material].emission_sides == Sides::Both ? 2.0f : 1.0f;
  const float place = chance_of({Type::Emitter, emitter}) / e.area;
  return {.pdf = place * cosine / (sides * kPi), .pdf_place = place, .cosine = cosine};
}

std::optional<Emitted> Emission::from_emitter(std::uint32_t index, float chance, Sampler& sampler) const {
  const Emitter& e = tracer_.emitters()[index];
  const Material& material = scene_.materials[e.material];
  const SurfaceSample surface = sample_area(e, sampler.next2());
  const bool front = material.emission_sides == Sides::Front || sampler.next() < 0.5f;
  const glm::vec3 normal = front ? surface.normal : -surface.normal;
  Hit place{};
  place.position = surface.position;
  place.normal_geometric = surface.normal;
  place.front = front;
  place.error = e.error;
  place.material = e.material;
  place.emitter = index;
  if (material.opacity || material.emission_texture) {
    // Where there may be a hole, or the texture's say is wanted, a ray looks at the very place.
    const float height = std::max(64.0f * e.error, 1e-4f * e.extent);
    const std::optional<Hit> met = tracer_.intersect({surface.position + height * normal, -normal}, 2.0f * height);
    if (!met || met->emitter != index) return std::nullopt;
    place = *met;
  }
  Emitted start{.kind = Symbol::La,
                .source = {Type::Emitter, index},
                .normal = normal,
                .error = place.error,
                .radiance = lights_.emitted(place)};
  if (is_black(start.radiance)) return std::nullopt;
  const glm::vec3 local = cosine_hemisphere(sampler.next2());
  if (!(local.z > 0)) return std::nullopt;
  start.ray = {place.position + place.error * normal, Frame::around(normal).to_world(local)};
  const float sides = material.emission_sides == Sides::Both ? 2.0f : 1.0f;
  const float pdf_place = chance / e.area;
  start.departure = {.pdf = pdf_place * local.z / (sides * kPi), .pdf_place = pdf_place, .cosine = local.z};
  start.throughput = start.radiance * (local.z / start.departure.pdf);
  return start;
}

std::optional<Emitted> Emission::from_point(const LightSource& source, float chance, Sampler& sampler) const {
  Emitted start{.kind = Symbol::Lp, .source = source, .is_delta = true};
  const glm::vec2 u = sampler.next2();
  float density = 1.0f / (4.0f * kPi), falloff = 1;
  if (source.type == Type::Spot) {
    const SpotLight& spot = scene_.spot_lights[source.index];
    const glm::vec3 axis = glm::normalize(spot.direction);
    start.ray = {spot.position, sample_cone(axis, std::cos(glm::radians(spot.cutoff_degrees)), u)};
    start.radiance = spot.intensity;
    density = cone_density(spot);
    falloff = spot_falloff(spot, glm::dot(start.ray.direction, axis));
  } else {
    const PointLight& point = scene_.point_lights[source.index];
    start.ray = {point.position, uniform_sphere(u)};
    start.radiance = point.intensity;
  }
  if (!(falloff > 0)) return std::nullopt;
  start.departure = {.pdf = chance * density, .pdf_place = chance};
  start.throughput = start.radiance * (falloff / start.departure.pdf);
  return start;
}

std::optional<Emitted> Emission::from_far(const LightSource& source, float chance, Sampler& sampler) const {
  Emitted start{.source = source, .infinite = true};
  float pdf_direction = 1;
  if (source.type == Type::Distant) {
    const DistantLight& light = scene_.distant_lights[source.index];
    start.kind = Symbol::Ld;
    start.is_delta = true;
    start.ray.direction = glm::normalize(light.direction);
    start.radiance = light.irradiance;
  } else {
    const EnvironmentSample sky = lights_.sky().sample(sampler.next2());
    if (is_black(sky.radiance) || !(sky.pdf_solid_angle > 0)) return std::nullopt;
    start.kind = Symbol::Le;
    start.ray.direction = -sky.direction;
    start.radiance = sky.radiance;
    pdf_direction = sky.pdf_solid_angle;
  }
  const Frame frame = Frame::around(start.ray.direction);
  const glm::vec2 disc = radius_ * uniform_disk(sampler.next2());
  start.ray.origin = center_ + disc.x * frame.s + disc.y * frame.t - radius_ * start.ray.direction;
  start.departure = {.pdf = chance * pdf_direction / (kPi * radius_ * radius_), .pdf_place = chance * pdf_direction};
  start.throughput = start.radiance / start.departure.pdf;
  return start;
}

Departure Emission::departure(const Hit& place, glm::vec3 direction) const {
  return from_area(place.emitter, std::abs(glm::dot(place.normal_geometric, direction)));
}

Departure Emission::departure_from_sky(glm::vec3 direction) const {
  const float place = chance_of({Type::Environment, 0}) * lights_.sky().pdf_solid_angle(-direction);
  return {.pdf = place / (kPi * radius_ * radius_), .pdf_place = place};
}

Departure Emission::departure(const LightSample& light) const {
  switch (light.source.type) {
    case Type::Emitter: {
      const Emitter& e = tracer_.emitters()[light.source.index];
      const glm::vec3 normal = e.form == Emitter::Form::Sphere ? glm::normalize(light.target - e.center) : e.normal;
      return from_area(light.source.index, std::abs(glm::dot(normal, light.direction)));
    }
    case Type::Point: {
      const float chance = chance_of(light.source);
      return {.pdf = chance / (4.0f * kPi), .pdf_place = chance};
    }
    case Type::Spot: {
      const float chance = chance_of(light.source);
      return {.pdf = chance * cone_density(scene_.spot_lights[light.source.index]), .pdf_place = chance};
    }
    case Type::Distant: {
      const float chance = chance_of(light.source);
      return {.pdf = chance / (kPi * radius_ * radius_), .pdf_place = chance};
    }
    case Type::Environment:
      break;
  }
  return departure_from_sky(-light.direction);
}

Rgb Emission::towards(const Emitted& start, glm::vec3 direction) const {
  switch (start.source.type) {
    case Type::Emitter: {
      const float cosine = glm::dot(start.normal, direction);
      const Material& material = scene_.materials[tracer_.emitters()[start.source.index].material];
      return start.radiance * (material.emission_sides == Sides::Both ? std::abs(cosine) : std::max(0.0f, cosine));
    }
    case Type::Spot: {
      const SpotLight& spot = scene_.spot_lights[start.source.index];
      return start.radiance * spot_falloff(spot, glm::dot(direction, glm::normalize(spot.direction)));
    }
    default:
      return start.radiance;
  }
}

}  // namespace heckbert::transport
