#include <heckbert/transport/radiosity.h>

#include <algorithm>
#include <limits>

#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;
using taxonomy::Symbol;

namespace {

/// Paths of fewer mirrors than this are never ended by roulette.
constexpr int kRouletteStart = 4;

/// The light that is stored where the ray ends, as it leaves towards the ray's origin.
void show(const World& world, Walk& walk, const Vertex& vertex, int depth, taxonomy::WordTrie::Node node,
          Rgb throughput, const RadiositySolution& solution) {
  Rgb reflectance;
  for (const Lobe& lobe : vertex.lobes()) reflectance += diffuse_reflectance(lobe, vertex.wo);
  if (is_black(reflectance)) return;
  const auto place = solution.find(vertex.hit);
  if (!place) return;
  const Rgb factor = throughput * reflectance * (1 / kPi);
  // Past the limit nothing is left out: there the walk counts all that it finds as cut off.
  const std::size_t room = depth > world.max_depth ? std::numeric_limits<std::size_t>::max()
                                                   : static_cast<std::size_t>(world.max_depth - depth);
  for (std::size_t i = 0; i < solution.lights().size(); ++i) {
    const RadiosityLight& light = solution.lights()[i];
    taxonomy::WordTrie::Node scattered = node;
    for (std::size_t bounce = 1; bounce <= light.irradiance.size(); ++bounce) {
      const Rgb value = factor * solution.irradiance(i, bounce, *place);
      if (bounce > room) {
        walk.cut_off += value;
        continue;
      }
      scattered = walk.step(scattered, Symbol::Dr, taxonomy::WordTrie::kNoLabel);
      if (is_black(value)) continue;
      const record::Technique technique{static_cast<std::uint16_t>(bounce + 1), true};
      walk.find({walk.step(scattered, light.kind, taxonomy::WordTrie::kNoLabel), value, technique});
    }
  }
}

struct Mirrored {
  DeltaBranch branch;
  Rgb factor;  ///< of the branch, the choice divided out; black: there is none
  bool transmitted = false;
};

/// One of the events that mirrors and panes have here, drawn by energy.
Mirrored follow_mirrors(const Vertex& vertex, Sampler& sampler) {
  std::vector<Mirrored> choices;
  float total = 0;
  const auto energy = [](const DeltaBranch& branch) { return max_channel(branch.weight) / branch.radiance_scale; };
  const auto offer = [&](const DeltaBranch& branch, bool transmitted) {
    if (is_black(branch.weight)) return;
    choices.push_back({branch, branch.weight, transmitted});
    total += energy(branch);
  };
  for (const Lobe& lobe : vertex.lobes()) {
    if (!is_delta(lobe)) continue;
    const DeltaBranches branches = delta_branches(lobe, vertex.wo, vertex.hit.front);
    offer(branches.reflected, false);
    if (branches.transmitted) offer(*branches.transmitted, true);
  }
  if (choices.empty()) return {};
  float left = choices.size() > 1 ? sampler.next() * total : 0;
  std::size_t chosen = 0;
  while (chosen + 1 < choices.size() && left >= energy(choices[chosen].branch))
    left -= energy(choices[chosen++].branch);
  choices[chosen].factor *= total / energy(choices[chosen].branch);
  return choices[chosen];
}

}  // namespace

void trace_radiosity(const World& world, Walk& walk, Ray ray, const RadiositySolution& solution, bool through_mirrors) {
  taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  Rgb throughput(1.0f);
  float radiance_scale = 1;
  std::optional<PastTheLimit> past_the_limit;
  const auto end = [&](PathEnd how) {
    if (!past_the_limit) walk.sink.end_path(how);
  };
  for (int depth = 0;; ++depth) {
    const auto hit = travel(world, walk, ray, throughput, Particles::Dim).hit;
    if (!hit) {
      walk.arrive(depth, {ray.direction, throughput, true});
      if (const Rgb sky = world.lights.environment(ray.direction); !is_black(sky))
        add_hit(walk, node, Symbol::Le, taxonomy::WordTrie::kNoLabel, throughput * sky);
      return end(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
    }
    walk.arrive(depth, {hit->position, throughput});
    if (const Rgb emitted = world.lights.emitted(*hit); !is_black(emitted))
      add_hit(walk, node, Symbol::La, taxonomy::WordTrie::kNoLabel, throughput * emitted);
    const Vertex vertex = vertex_at(world, walk, *hit, ray.direction);
    show(world, walk, vertex, depth, node, throughput, solution);
    const Mirrored next = through_mirrors ? follow_mirrors(vertex, walk.sampler) : Mirrored{};
    if (is_black(next.factor)) return end(PathEnd::Absorbed);
    if (depth == world.max_depth) {
      end(PathEnd::DepthLimit);
      if (walk.sampler.next() >= PastTheLimit::kShare) return;
      past_the_limit.emplace(walk);
    }

    throughput *= next.factor;
    radiance_scale *= next.branch.radiance_scale;
    if (depth + 1 >= kRouletteStart) {
      const float survival = std::min(1.0f, max_channel(throughput) / radiance_scale);
      if (walk.sampler.next() >= survival) return end(PathEnd::Roulette);
      throughput *= 1 / survival;
    }
    node = walk.step(node, next.branch.event, taxonomy::WordTrie::kNoLabel);
    if (next.transmitted && world.has_bodies) walk.bodies.cross(world.scene, hit->material, hit->front);
    ray = vertex.leave(next.branch.wi, next.transmitted);
  }
}

}  // namespace heckbert::transport
