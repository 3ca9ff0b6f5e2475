#include <heckbert/transport/travel.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <heckbert/transport/medium.h>

namespace heckbert::transport {

namespace {

/// More boundaries than any scene has in a line; a ray that meets more is caught between two of them by rounding.
constexpr int kMostBoundaries = 4096;

/// Lamps are seen wherever they are, so that sampling them and running into them agree.
bool is_passed(const Scene& scene, const Bodies& bodies, const Hit& hit) {
  const Material& material = scene.materials[hit.material];
  return material.is_index_matched || (is_black(material.emission) && !bodies.shows(scene, hit.material, hit.front));
}

/// One more stretch, in a medium or in none.
void lengthen(Passage& passage, const Medium* medium, float distance, bool is_first) {
  const Stretch way = medium != nullptr ? stretch(*medium, distance) : Stretch{};
  passage.transmittance *= way.transmittance;
  passage.chance *= way.chance;
  passage.rate_end = way.rate;
  if (is_first) passage.rate_begin = way.rate;
}

void pass(const Scene& scene, Bodies& bodies, const Hit& hit, glm::vec3& origin) {
  bodies.cross(scene, hit.material, hit.front);
  origin = leave(hit, !hit.front);
}

Passage passage_to(const World& world, std::uint64_t& rays, const Bodies& bodies, glm::vec3 from,
                   const LightSample& white) {
  Passage passage;
  passage.transmittance = arriving(world, rays, bodies, from, white, &passage);
  return passage;
}

}  // namespace

Meeting travel_through_bodies(const World& world, Traveller traveller, Ray& ray, Rgb& throughput, Particles particles,
                              Passage* passage) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (int boundary = 0; boundary < kMostBoundaries; ++boundary) {
    ++traveller.rays;
    const std::optional<Hit> hit = world.tracer.intersect(ray);
    const Medium* medium = traveller.bodies.medium(world.scene);
    const bool is_endless = !hit || (traveller.from_infinity && boundary == 0);
    const float farthest = is_endless ? kInfinity : glm::distance(hit->position, ray.origin);
    Flight flight{farthest};
    if (medium != nullptr) {
      flight = particles == Particles::Scatter ? fly(*medium, farthest, traveller.sampler)
                                               : Flight{farthest, false, transmittance(*medium, farthest)};
      throughput *= flight.weight;
    }
    if (passage != nullptr) lengthen(*passage, medium, flight.distance, boundary == 0);
    if (flight.scattered && traveller.from_infinity && boundary == 0) break;  // before it came anywhere
    if (flight.scattered) {
      ray.origin += flight.distance * ray.direction;
      return {std::nullopt, true};
    }
    if (!hit || !is_passed(world.scene, traveller.bodies, *hit)) return {hit, false};
    pass(world.scene, traveller.bodies, *hit, ray.origin);
  }
  throughput = Rgb(0);
  return {};
}

Rgb arriving(const World& world, std::uint64_t& rays, Bodies bodies, glm::vec3 from, const LightSample& light,
             Passage* passage) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const bool is_met = light.to_be_met != kNoEmitter, endless = light.infinite || is_met;
  Passage way;
  Rgb light_sent;
  for (int boundary = 0; boundary < kMostBoundaries; ++boundary) {
    const float farthest = endless ? kInfinity : glm::distance(light.target, from);
    const glm::vec3 direction = endless ? light.direction : (light.target - from) / farthest;
    ++rays;
    const std::optional<Hit> hit = world.tracer.intersect(Ray{from, direction}, farthest);
    lengthen(way, bodies.medium(world.scene), hit ? glm::distance(hit->position, from) : farthest, boundary == 0);
    if (!hit) {
      if (!is_met) light_sent = light.radiance;
      break;
    }
    if (is_met && hit->emitter == light.to_be_met) {
      light_sent = world.lights.emitted(*hit);
      break;
    }
    if (!is_passed(world.scene, bodies, *hit)) break;
    pass(world.scene, bodies, *hit, from);
  }
  if (passage != nullptr) *passage = way;
  return way.transmittance * light_sent;
}

Passage passage_between(const World& world, std::uint64_t& rays, const Bodies& bodies, glm::vec3 from, glm::vec3 to) {
  if (!world.has_bodies) {
    ++rays;
    return {.transmittance = Rgb(world.tracer.is_occluded(from, to) ? 0.0f : 1.0f)};
  }
  return passage_to(world, rays, bodies, from, {.target = to, .radiance = Rgb(1)});
}

Passage passage_to_infinity(const World& world, std::uint64_t& rays, const Bodies& bodies, const Ray& ray) {
  if (!world.has_bodies) {
    ++rays;
    return {.transmittance = Rgb(world.tracer.is_occluded(ray) ? 0.0f : 1.0f)};
  }
  return passage_to(world, rays, bodies, ray.origin,
                    {.direction = ray.direction, .infinite = true, .radiance = Rgb(1)});
}

Bodies bodies_at(const Scene& scene, const Tracer& tracer, glm::vec3 point) {
  Ray ray{point, glm::normalize(glm::vec3(0.3257f, 0.5413f, 0.7751f))};  // along nothing that people build
  std::map<std::uint32_t, int> entered;
  std::vector<std::uint32_t> around;  // from the inside out
  for (int boundary = 0; boundary < kMostBoundaries; ++boundary) {
    const std::optional<Hit> hit = tracer.intersect(ray);
    if (!hit) break;
    if (scene.materials[hit->material].interior) {
      int& open = entered[hit->material];
      if (hit->front)
        ++open;
      else if (open > 0)
        --open;
      else
        around.push_back(hit->material);
    }
    ray.origin = leave(*hit, !hit->front);
  }
  Bodies bodies;
  for (auto body = around.rbegin(); body != around.rend(); ++body) bodies.cross(scene, *body, true);
  return bodies;
}

bool has_bodies(const Scene& scene) {
  return scene.medium || std::any_of(scene.materials.begin(), scene.materials.end(),
                                     [](const Material& m) { return m.interior || m.is_index_matched; });
}

void check_media(const Scene& scene) {
  const auto check_index = [&](std::optional<std::uint32_t> medium, const std::string& where) {
    if (medium && *medium >= scene.media.size())
      throw std::invalid_argument(fmt::format("{}: there is no medium {}", where, *medium));
  };
  check_index(scene.medium, "the scene");
  for (const Material& m : scene.materials) {
    if (m.interior) check_index(m.interior->medium, fmt::format("material '{}'", m.name));
    if (m.is_index_matched && (!m.lobes.empty() || !is_black(m.emission)))
      throw std::invalid_argument(
          fmt::format("material '{}': an index-matched boundary has no lobes and emits nothing", m.name));
  }
  const auto is_coefficient = [](Rgb c) { return is_finite(c) && c.r >= 0 && c.g >= 0 && c.b >= 0; };
  for (const Medium& medium : scene.media)
    if (!is_coefficient(medium.absorption) || !is_coefficient(medium.scattering) ||
        !(medium.anisotropy > -1 && medium.anisotropy < 1))
      throw std::invalid_argument(fmt::format(
          "medium '{}': coefficients must not be negative, and the anisotropy must lie between -1 and 1", medium.name));
}

}  // namespace heckbert::transport
