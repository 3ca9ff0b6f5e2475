#include <heckbert/transport/lights.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include <heckbert/transport/delta_lights.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/texture.h>

namespace heckbert::transport {

using taxonomy::Symbol;

namespace {

/// More lights than this are chosen through a tree.
constexpr std::size_t kMostByPower = 64;

/// By material: the largest channel of what it emits, on average over its texture. Above zero wherever it may emit.
std::vector<float> mean_emissions(const Scene& scene) {
  std::vector<float> means;
  for (const Material& material : scene.materials)
    means.push_back(max_channel(material.emission_texture
                                    ? material.emission * mean_colour(scene.textures[*material.emission_texture])
                                    : material.emission));
  return means;
}

LightSample from_point(LightSource source, const std::optional<DeltaSample>& delta, glm::vec3 position,
                       float probability) {
  if (!delta) return {};
  return {.kind = Symbol::Lp,
          .direction = delta->direction,
          .target = position,
          .radiance = delta->irradiance,
          .pdf_solid_angle = probability,
          .is_delta = true,
          .source = source};
}

}  // namespace

Lights::Lights(const Scene& scene, const Tracer& tracer) : scene_(scene), tracer_(tracer), environment_(scene) {
  using Type = LightSource::Type;
  std::vector<LightBounds> near;
  const auto& emitters = tracer.emitters();
  const std::vector<float> emissions = mean_emissions(scene);
  for (std::uint32_t i = 0; i < emitters.size(); ++i) {
    const bool both_sides = scene.materials[emitters[i].material].emission_sides == Sides::Both;
    near_.push_back({Type::Emitter, i});
    near.push_back(bounds_of(emitters[i], both_sides,
                             (both_sides ? 2 : 1) * kPi * emitters[i].area * emissions[emitters[i].material]));
  }
  const auto add_near = [&](Type type, const auto& lights) {
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      const LightBounds bounds = bounds_of(lights[i]);
      if (!(bounds.power > 0)) continue;
      near_.push_back({type, i});
      near.push_back(bounds);
    }
  };
  add_near(Type::Point, scene.point_lights);
  add_near(Type::Spot, scene.spot_lights);

  std::vector<double> near_power, far_power;
  for (const LightBounds& bounds : near) near_power.push_back(bounds.power);
  const double half_diagonal = 0.5 * glm::length(tracer.bounds_high() - tracer.bounds_low());
  const double radius = std::isfinite(half_diagonal) ? half_diagonal : 1.0;  // a scene of nothing but sky
  for (std::uint32_t i = 0; i < scene.distant_lights.size(); ++i) {
    far_.push_back({Type::Distant, i});
    far_power.push_back(power(scene.distant_lights[i], radius));
  }
  if (has_environment()) {
    far_.push_back({Type::Environment, 0});
    far_power.push_back(4 * std::numbers::pi * std::numbers::pi * radius * radius * environment_.mean_radiance());
  }
  for (std::size_t i = 0; i < near_.size(); ++i) powers_.push_back({near_[i], near_power[i]});
  for (std::size_t i = 0; i < far_.size(); ++i) powers_.push_back({far_[i], far_power[i]});
  const double lamps = std::accumulate(near_power.begin(), near_power.end(), 0.0);
  const double sky = std::accumulate(far_power.begin(), far_power.end(), 0.0);
  // A wide floor must not starve the lamps that stand on it: the sky is never chosen more often than all of them.
  const double scale = lamps > 0 && sky > lamps ? lamps / sky : 1.0;
  for (double& p : far_power) p *= scale;
  far_power.insert(far_power.begin(), lamps);
  groups_ = DiscreteDistribution(std::move(far_power));
  if (near.size() > kMostByPower)
    near_tree_.emplace(near);
  else
    near_choice_ = DiscreteDistribution(std::move(near_power));
  if (near_.size() + far_.size() == 1) only_ = near_.empty() ? far_.front() : near_.front();
}

Rgb Lights::emitted(std::uint32_t material, bool front) const {
  const Material& m = scene_.materials[material];
  return front || m.emission_sides == Sides::Both ? m.emission : Rgb{};
}

Rgb Lights::emitted(const Hit& hit) const {
  if (hit.emitter == kNoEmitter) return {};
  const Rgb radiance = emitted(hit.material, hit.front);
  const std::optional<std::uint32_t> texture = scene_.materials[hit.material].emission_texture;
  if (!texture || is_black(radiance)) return radiance;
  const glm::vec4 colour = look_up(scene_.textures[*texture], hit.uv);
  return radiance * Rgb(colour.r, colour.g, colour.b);
}

float Lights::pdf_environment(glm::vec3 direction) const {
  return has_environment()
             ? static_cast<float>(groups_.probability(far_.size())) * environment_.pdf_solid_angle(direction)
             : 0.0f;
}

float Lights::probability(LightSource source, glm::vec3 from) const {
  // Both lists are sorted: first by type, then by index.
  const auto before = [](const LightSource& a, const LightSource& b) {
    return a.type != b.type ? a.type < b.type : a.index < b.index;
  };
  const bool is_far = source.type == LightSource::Type::Distant || source.type == LightSource::Type::Environment;
  const std::vector<LightSource>& list = is_far ? far_ : near_;
  const auto place =
      static_cast<std::size_t>(std::lower_bound(list.begin(), list.end(), source, before) - list.begin());
  if (is_far) return static_cast<float>(groups_.probability(place + 1));
  const double within = near_tree_ ? near_tree_->probability(place, from) : near_choice_.probability(place);
  return static_cast<float>(groups_.probability(0) * within);
}

float Lights::pdf_solid_angle(const Hit& hit, glm::vec3 from) const {
  // The tracer's emitters come first among the near lights.
  const double within = near_tree_ ? near_tree_->probability(hit.emitter, from) : near_choice_.probability(hit.emitter);
  const double choice = groups_.probability(0) * within;
  return static_cast<float>(choice) *
         transport::pdf_solid_angle(tracer_.emitters()[hit.emitter], from, hit.position, hit.normal_geometric);
}

Lights::Choice Lights::choose(glm::vec3 from, double u) const {
  const auto [group, rest] = groups_.sample(u);
  const double of_group = groups_.probability(group);
  if (group > 0) return {far_[group - 1], static_cast<float>(of_group)};
  if (!near_tree_) {
    const std::size_t light = near_choice_.sample(rest).index;
    return {near_[light], static_cast<float>(of_group * near_choice_.probability(light))};
  }
  const std::optional<LightTree::Choice> near = near_tree_->sample(from, rest);
  return near ? Choice{near_[near->light], static_cast<float>(of_group * near->probability)} : Choice{};
}

LightSample Lights::sample(glm::vec3 from, Sampler& sampler) const {
  if (empty()) return {};
  const Choice choice = only_ ? Choice{*only_, 1} : choose(from, sampler.next_fine());
  return sample_source(choice, from, sampler.next2());
}

LightSample Lights::sample_source(const Choice& choice, glm::vec3 from, glm::vec2 u) const {
  const auto [source, probability] = choice;
  if (!(probability > 0)) return {};
  switch (source.type) {
    case LightSource::Type::Emitter: {
      const Emitter& e = tracer_.emitters()[source.index];
      const SurfaceSample surface = sample_surface(e, from, u);
      const glm::vec3 d = surface.position - from;
      const float distance = glm::length(d);
      if (!(surface.pdf_solid_angle > 0 && distance > 0)) return {};
      const bool front = glm::dot(d, surface.normal) < 0;
      const Rgb radiance = emitted(e.material, front);
      if (is_black(radiance)) return {};
      const Material& material = scene_.materials[e.material];
      return {.kind = Symbol::La,
              .direction = d / distance,
              .target = surface.position + (front ? e.error : -e.error) * surface.normal,
              .radiance = radiance,
              .pdf_solid_angle = probability * surface.pdf_solid_angle,
              .to_be_met = material.opacity || material.emission_texture ? source.index : kNoEmitter,
              .source = source};
    }
    case LightSource::Type::Point: {
      const PointLight& light = scene_.point_lights[source.index];
      return from_point(source, sample_delta(light, from), light.position, probability);
    }
    case LightSource::Type::Spot: {
      const SpotLight& light = scene_.spot_lights[source.index];
      return from_point(source, sample_delta(light, from), light.position, probability);
    }
    case LightSource::Type::Distant: {
      const DeltaSample delta = sample_delta(scene_.distant_lights[source.index]);
      return {.kind = Symbol::Ld,
              .direction = delta.direction,
              .infinite = true,
              .radiance = delta.irradiance,
              .pdf_solid_angle = probability,
              .is_delta = true,
              .source = source};
    }
    case LightSource::Type::Environment: {
      const EnvironmentSample sky = environment_.sample(u);
      if (is_black(sky.radiance)) return {};
      return {.kind = Symbol::Le,
              .direction = sky.direction,
              .infinite = true,
              .radiance = sky.radiance,
              .pdf_solid_angle = probability * sky.pdf_solid_angle,
              .source = source};
    }
  }
  return {};
}

}  // namespace heckbert::transport
