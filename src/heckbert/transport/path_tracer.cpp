#include <heckbert/transport/path_tracer.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include <heckbert/transport/medium.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;
using taxonomy::Symbol;

namespace {

/// Paths of fewer scatterings than this are never ended by roulette.
constexpr int kRouletteStart = 4;
constexpr float kHighestSurvival = 0.95f;

/// How a path goes on from a vertex; unless it says more, not at all.
struct Continuation {
  Ray ray{};
  Symbol event = Symbol::Dr;
  Rgb factor;                 ///< f cos / p of the chosen lobe, every choice divided out; black: absorbed
  float pdf_solid_angle = 0;  ///< of the mixture; 0 after a delta lobe
  float radiance_scale = 1;   ///< the compression of radiance in `factor`, which roulette must not see
  bool transmitted = false;   ///< through the surface
};

/// An index, and what the draw leaves over: again uniform in [0, 1).
struct Drawn {
  std::size_t index = 0;
  float u = 0;
};

/// The index drawn from weights that add up to `total`.
template <class Weights>
Drawn draw(const Weights& weights, std::size_t count, float total, float u) {
  constexpr float kBelowOne = 0x1.fffffep-1f;
  float left = u * total;
  Drawn drawn;
  for (std::size_t i = 0; i < count; ++i) {
    if (weights[i] <= 0) continue;
    drawn = {i, std::min(left / weights[i], kBelowOne)};
    if (left < weights[i]) break;
    left -= weights[i];
  }
  return drawn;
}

Continuation follow_delta(const Vertex& vertex, Drawn lobe) {
  const DeltaBranches branches = delta_branches(vertex.lobes()[lobe.index], vertex.wo, vertex.hit.front);
  const float reflect = max_channel(branches.reflected.weight);
  // The choice goes by energy, not by radiance, which changes with the medium.
  const float transmit =
      branches.transmitted ? max_channel(branches.transmitted->weight) / branches.transmitted->radiance_scale : 0.0f;
  if (!(reflect + transmit > 0)) return {};
  const float p_reflect = reflect / (reflect + transmit);
  const bool transmitted = lobe.u >= p_reflect;
  const DeltaBranch& branch = transmitted ? *branches.transmitted : branches.reflected;
  const float probability = vertex.selection[lobe.index] * (transmitted ? 1.0f - p_reflect : p_reflect);
  return {.ray = vertex.leave(branch.wi, transmitted),
          .event = branch.event,
          .factor = branch.weight / probability,
          .radiance_scale = branch.radiance_scale,
          .transmitted = transmitted};
}

Continuation follow_non_delta(const Vertex& vertex, Drawn sampled, Sampler& sampler) {
  const std::span<const Lobe> lobes = vertex.lobes();
  const glm::vec3 local =
      sample_direction(lobes[sampled.index], vertex.wo, {sampler.next2(), sampled.u}, vertex.hit.front);
  if (local.z == 0) return {};
  const glm::vec3 wi = vertex.local(vertex.frame.to_world(local));
  if (wi.z == 0) return {};
  const Vertex::Values values = vertex.values(wi);
  if (!(values.pdf_solid_angle > 0)) return {};

  std::array<float, kMaxLobes> weight{};
  float total = 0;
  for (std::size_t i = 0; i < lobes.size(); ++i) total += weight[i] = max_channel(values.f[i]);
  if (!(total > 0)) return {};
  const std::size_t lobe = lobes.size() > 1 ? draw(weight, lobes.size(), total, sampler.next()).index : 0;
  const bool transmitted = wi.z < 0;
  return {.ray = vertex.leave(wi, transmitted),
          .event = letter(lobes[lobe], transmitted),
          .factor = values.f[lobe] * (std::abs(wi.z) * total / (values.pdf_solid_angle * weight[lobe])),
          .pdf_solid_angle = values.pdf_solid_angle,
          .radiance_scale = transmitted ? radiance_compression(lobes[lobe], vertex.hit.front) : 1.0f,
          .transmitted = transmitted};
}

/// Draws no number where there is nothing to choose.
Continuation follow(const Vertex& vertex, Sampler& sampler) {
  if (!(vertex.total_weight > 0)) return {};
  const float u_choice = vertex.has_choice ? sampler.next() : 0.0f;
  const Drawn lobe = draw(vertex.selection, vertex.lobes().size(), 1.0f, u_choice);
  if (is_delta(vertex.lobes()[lobe.index])) return follow_delta(vertex, lobe);
  return follow_non_delta(vertex, lobe, sampler);
}

/// Next-event estimation at a particle where the ray ends.
void gather_light_at_particle(const World& world, Walk& walk, const Ray& ray, const Medium& medium,
                              taxonomy::WordTrie::Node node, Rgb throughput) {
  const LightSample light = world.lights.sample(ray.origin, walk.sampler);
  if (!(light.pdf_solid_angle > 0)) return;
  const float value = phase(medium.anisotropy, glm::dot(ray.direction, light.direction));
  const Rgb incident = arriving(world, walk, walk.bodies, ray.origin, light);
  if (is_black(incident)) return;
  const float weight = (light.is_delta ? 1.0f : power_heuristic(light.pdf_solid_angle, value)) * value;
  const taxonomy::WordTrie::Node scattered = walk.step(node, Symbol::V, world.labels.particle(medium));
  walk.find({walk.step(scattered, light.kind, world.labels.light(light.source)),
             throughput * incident * (weight / light.pdf_solid_angle), record::Technique::NextEvent},
            light);
}

/// What happens at a particle where the ray ends: light is gathered, and the path goes on.
Continuation scatter_at_particle(const World& world, Walk& walk, const Ray& ray, taxonomy::WordTrie::Node node,
                                 Rgb throughput) {
  const Medium& medium = *walk.bodies.medium(world.scene);
  if (world.next_event_estimation) gather_light_at_particle(world, walk, ray, medium, node, throughput);
  const glm::vec3 direction = sample_phase(medium.anisotropy, ray.direction, walk.sampler.next2());
  return {.ray = {ray.origin, direction},
          .event = Symbol::V,
          .factor = Rgb(1.0f),
          .pdf_solid_angle = phase(medium.anisotropy, glm::dot(ray.direction, direction))};
}

/// The same at a surface.
Continuation scatter_at_surface(const World& world, Walk& walk, const Hit& hit, glm::vec3 direction,
                                taxonomy::WordTrie::Node node, Rgb throughput) {
  const Vertex vertex = vertex_at(world, walk, hit, direction);
  if (vertex.has_non_delta && world.next_event_estimation)
    gather_direct_light(world, walk, vertex, node, throughput, {.multiple_importance = true});
  return follow(vertex, walk.sampler);
}

}  // namespace

void trace_path(const World& world, Walk& walk, Ray ray) {
  taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  Rgb throughput(1.0f);
  float radiance_scale = 1;
  float pdf_arrival = 0;  // 0: a light here could not have been found by next-event estimation
  glm::vec3 previous{0};
  std::optional<PastTheLimit> past_the_limit;
  const auto end = [&](PathEnd how) {
    if (!past_the_limit) walk.sink.end_path(how);
  };

  for (int depth = 0;; ++depth) {
    const auto [hit, scattered] = travel(world, walk, ray, throughput);
    if (is_black(throughput)) return end(PathEnd::Absorbed);
    if (!hit && !scattered) {
      walk.arrive(depth, {ray.direction, throughput, true});
      const Rgb sky = world.lights.environment(ray.direction);
      if (!is_black(sky)) {
        const float weight =
            pdf_arrival > 0 ? power_heuristic(pdf_arrival, world.lights.pdf_environment(ray.direction)) : 1.0f;
        add_hit(walk, node, Symbol::Le, world.labels.light({LightSource::Type::Environment, 0}),
                throughput * sky * weight);
      }
      return end(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
    }
    walk.arrive(depth, {hit ? hit->position : ray.origin, throughput});
    if (const Rgb emitted = hit ? world.lights.emitted(*hit) : Rgb{}; !is_black(emitted)) {
      const float weight =
          pdf_arrival > 0 ? power_heuristic(pdf_arrival, world.lights.pdf_solid_angle(*hit, previous)) : 1.0f;
      add_hit(walk, node, Symbol::La, world.labels.light({LightSource::Type::Emitter, hit->emitter}),
              throughput * emitted * weight);
    }
    if (depth == world.max_depth) {
      end(PathEnd::DepthLimit);
      if (walk.sampler.next() >= PastTheLimit::kShare) return;
      past_the_limit.emplace(walk);
    }

    const Continuation next = scattered ? scatter_at_particle(world, walk, ray, node, throughput)
                                        : scatter_at_surface(world, walk, *hit, ray.direction, node, throughput);
    throughput *= next.factor;
    radiance_scale *= next.radiance_scale;
    if (is_black(throughput)) return end(PathEnd::Absorbed);
    if (depth + 1 >= kRouletteStart) {
      const float survival = std::min(kHighestSurvival, max_channel(throughput) / radiance_scale);
      if (walk.sampler.next() >= survival) return end(PathEnd::Roulette);
      throughput *= 1.0f / survival;
    }
    const Labels::Id label =
        scattered ? world.labels.particle(*walk.bodies.medium(world.scene)) : world.labels.surface(*hit);
    node = walk.step(node, next.event, label);
    pdf_arrival = world.next_event_estimation ? next.pdf_solid_angle : 0.0f;
    previous = scattered ? ray.origin : hit->position;
    if (next.transmitted && world.has_bodies) walk.bodies.cross(world.scene, hit->material, hit->front);
    ray = next.ray;
  }
}

}  // namespace heckbert::transport
