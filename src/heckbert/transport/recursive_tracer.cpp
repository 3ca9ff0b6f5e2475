#include <heckbert/transport/recursive_tracer.h>

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/running_into_lights.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::NonPath;
using record::PathEnd;
using taxonomy::Symbol;

namespace {

/// Branches that carry less than this share are ended by roulette, so that the tree of a glass ball stays small without
/// losing energy on average (Hall and Greenberg 1983 cut it off instead).
constexpr float kThinBranch = 1.0f / 64.0f;

/// Between two perfect mirrors the tree never ends: what the depth limit cuts off is looked for so many levels deep.
constexpr int kLevelsPastTheLimit = 32;

struct Branch {
  Ray ray;
  taxonomy::WordTrie::Node node = 0;
  Rgb weight{1.0f};
  float radiance_scale = 1;  ///< compression of radiance in `weight`; see path_tracer.cpp
  Approach approach{};       ///< spread over a glossy lobe; of no density for all others
  int depth = 0;
  bool phantom = false;
  Bodies bodies{};  ///< that the ray starts in
};

class Tree {
 public:
  Tree(const World& world, Walk& walk, const RecursiveOptions& options)
      : world_(world), walk_(walk), options_(options) {}

  void trace(Branch branch) {
    walk_.bodies = branch.bodies;
    const std::optional<Hit> hit = travel(world_, walk_, branch.ray, branch.weight, Particles::Dim).hit;
    branch.bodies = walk_.bodies;
    if (!hit) {
      walk_.arrive(branch.depth, {branch.ray.direction, branch.weight, true});
      add(branch, Symbol::Le, {LightSource::Type::Environment, 0},
          sky_met(world_, branch.ray.direction, branch.approach));
      return end(world_.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
    }
    walk_.arrive(branch.depth, {hit->position, branch.weight});
    add(branch, Symbol::La, {LightSource::Type::Emitter, hit->emitter}, lamp_met(world_, *hit, branch.approach));
    const Vertex vertex = vertex_at(world_, walk_, *hit, branch.ray.direction);
    add_ambient(branch, vertex);
    if (branch.depth != world_.max_depth) return go_on(branch, vertex);
    end(PathEnd::DepthLimit);
    if (branch.phantom || walk_.sampler.next() >= PastTheLimit::kShare) return;
    const PastTheLimit unrecorded(walk_);
    past_the_limit_ = true;
    go_on(branch, vertex);
    past_the_limit_ = false;
  }

 private:
  void end(PathEnd how) {
    if (!past_the_limit_) walk_.sink.end_path(how);
  }

  void go_on(const Branch& branch, const Vertex& vertex) {
    shade(branch, vertex);
    bool spawned = options_.one_branch ? spawn_one(branch, vertex) : spawn_all(branch, vertex);
    // Only where the ray would end: two rays at full strength from every wall would be a tree without bound.
    if (!spawned && !past_the_limit_ && options_.mirror_at_diffuse && !is_black(vertex.material->phantom_reflectance))
      spawned = spawn_phantom(branch, vertex);
    if (!spawned) end(PathEnd::Absorbed);
  }

  void add(const Branch& branch, Symbol kind, LightSource light, Rgb radiance) {
    if (is_black(radiance)) return;
    if (branch.phantom)
      walk_.sink.add_non_path(NonPath::Phantom, branch.weight * radiance);
    else
      add_hit(walk_, branch.node, kind, world_.labels.light(light), branch.weight * radiance);
  }

  void add_ambient(const Branch& branch, const Vertex& vertex) {
    if (is_black(world_.scene.ambient) || past_the_limit_) return;
    walk_.sink.add_non_path(branch.phantom ? NonPath::Phantom : NonPath::Ambient,
                            branch.weight * ambient_reflectance(vertex) * world_.scene.ambient);
  }

  void shade(const Branch& branch, const Vertex& vertex) {
    if (!vertex.has_non_delta) return;
    const DirectLight rule{.glossy = options_.glossy_highlights, .follows_glossy = options_.spread_glossy};
    if (branch.phantom) {
      const Rgb light = direct_light(world_, walk_, vertex, rule);
      if (!is_black(light)) walk_.sink.add_non_path(NonPath::Phantom, branch.weight * light);
    } else {
      gather_direct_light(world_, walk_, vertex, branch.node, branch.weight, rule);
    }
  }

  /// Hands each ray that leaves the surface to `take`, as it is made.
  template <class Take>
  void offer_branches(const Vertex& vertex, Take take) {
    const auto delta = [&](const DeltaBranch& child, bool transmitted) {
      take(Continuation{.ray = vertex.leave(child.wi, transmitted),
                        .event = child.event,
                        .factor = child.weight,
                        .radiance_scale = child.radiance_scale,
                        .transmitted = transmitted});
    };
    for (const Lobe& lobe : vertex.lobes())
      if (is_delta(lobe)) {
        const DeltaBranches children = delta_branches(lobe, vertex.wo, vertex.hit.front);
        delta(children.reflected, false);
        if (children.transmitted) delta(*children.transmitted, true);
      } else if (options_.spread_glossy && taxonomy::facts(letter(lobe)).letter == 'G') {
        take(follow_alone(vertex, lobe, walk_.sampler));
      }
  }

  bool spawn_all(const Branch& branch, const Vertex& vertex) {
    bool spawned = false;
    offer_branches(vertex, [&](const Continuation& child) { spawned |= spawn(branch, vertex, child); });
    return spawned;
  }

  /// Of branches with shares a, b, c, ... each takes the place of those before it with its share of the sum so far, and
  /// so is left with its share of the whole (Chao 1982, "A general purpose unequal probability sampling plan").
  bool spawn_one(const Branch& branch, const Vertex& vertex) {
    Continuation chosen;
    float share_chosen = 0, sum = 0;
    offer_branches(vertex, [&](const Continuation& child) {
      const float share = max_channel(child.factor) / child.radiance_scale;
      if (!(share > 0)) return;
      const bool is_first = sum == 0;
      sum += share;
      if (!is_first && walk_.sampler.next() * sum >= share) return;
      chosen = child;
      share_chosen = share;
    });
    if (sum == 0) return false;
    chosen.factor *= sum / share_chosen;
    return spawn(branch, vertex, chosen);
  }

  bool spawn(const Branch& parent, const Vertex& vertex, const Continuation& child) {
    if (is_black(child.factor)) return false;
    Branch next{
        .ray = child.ray,
        .node = parent.phantom ? parent.node : walk_.step(parent.node, child.event, world_.labels.surface(vertex.hit)),
        .weight = parent.weight * child.factor,
        .radiance_scale = parent.radiance_scale * child.radiance_scale,
        .approach = {child.pdf_solid_angle, vertex.hit.position},
        .depth = parent.depth + 1,
        .phantom = parent.phantom,
        .bodies = parent.bodies};
    if (child.transmitted && world_.has_bodies) next.bodies.cross(world_.scene, vertex.hit.material, vertex.hit.front);
    descend(next);
    return true;
  }

  bool spawn_phantom(const Branch& parent, const Vertex& vertex) {
    Branch next = parent;
    next.ray = vertex.leave({-vertex.wo.x, -vertex.wo.y, vertex.wo.z}, false);
    next.weight *= vertex.material->phantom_reflectance;
    next.depth += 1;
    next.phantom = true;
    descend(next);
    return true;
  }

  void descend(Branch& branch) {
    if (branch.depth > world_.max_depth + kLevelsPastTheLimit) return;
    const float strength = max_channel(branch.weight) / branch.radiance_scale;
    if (strength < kThinBranch) {
      const float survival = strength / kThinBranch;
      if (walk_.sampler.next() >= survival) return end(PathEnd::Roulette);
      branch.weight *= 1.0f / survival;
    }
    trace(branch);
  }

  const World& world_;
  Walk& walk_;
  const RecursiveOptions& options_;
  bool past_the_limit_ = false;
};

}  // namespace

void trace_recursively(const World& world, Walk& walk, const Ray& ray, const RecursiveOptions& options) {
  Tree(world, walk, options)
      .trace({.ray = ray, .node = walk.sink.words().eye(world.eye.kind()), .bodies = world.bodies_at_eye});
}

}  // namespace heckbert::transport
