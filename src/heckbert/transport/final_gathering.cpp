#include <heckbert/transport/final_gathering.h>

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/photon_gathering.h>
#include <heckbert/transport/running_into_lights.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;
using taxonomy::Symbol;
using taxonomy::WordTrie;

namespace {

bool is_diffuse(Symbol event) {
  return taxonomy::facts(event).letter == 'D';
}

/// A walk, about to follow a ray.
struct Leg {
  Ray ray;
  WordTrie::Node node = 0;
  Rgb throughput{1.0f};
  float radiance_scale = 1;
  Approach approach{};  ///< spread over a glossy lobe; of no density for all others
  int scatterings = 0;
  Bodies bodies{};  ///< that the ray starts in
};

class FinalGathering {
 public:
  FinalGathering(const World& world, Walk& walk) : world_(world), walk_(walk) {}

  void trace(const Ray& ray) {
    Leg leg{.ray = ray, .node = walk_.sink.words().eye(world_.eye.kind()), .bodies = world_.bodies_at_eye};
    for (;;) {
      const std::optional<Hit> hit = meet(leg);
      if (is_black(leg.throughput)) return walk_.sink.end_path(PathEnd::Absorbed);
      if (!hit) {
        run_into_sky(world_, walk_, leg.node, leg.ray.direction, leg.throughput, leg.approach);
        return walk_.sink.end_path(world_.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
      }
      run_into_lamp(world_, walk_, leg.node, *hit, leg.throughput, leg.approach);
      if (leg.scatterings == world_.max_depth) return walk_.sink.end_path(PathEnd::DepthLimit);
      const Vertex vertex = vertex_at(world_, walk_, *hit, leg.ray.direction);
      if (vertex.has_non_delta) {
        gather_direct_light(world_, walk_, vertex, leg.node, leg.throughput, {.follows_glossy = true});
        look_up(*world_.caustics, vertex, leg, 1);
        gather(vertex, leg);
      }
      if (const std::optional<PathEnd> end = go_on(vertex, leg)) return walk_.sink.end_path(*end);
    }
  }

 private:
  /// The walk stands there afterwards.
  std::optional<Hit> meet(Leg& leg) {
    walk_.bodies = leg.bodies;
    const Meeting meeting = travel(world_, walk_, leg.ray, leg.throughput, Particles::Dim);
    leg.bodies = walk_.bodies;
    return meeting.hit;
  }

  /// Light of a map that a vertex scatters diffusely.
  void look_up(const PhotonMap& map, const Vertex& vertex, const Leg& leg, float share) {
    const auto in_full = [](const Photon&, glm::vec3, const Vertex::Values&) { return 1.0f; };
    gather_photons(world_, walk_, map, vertex, leg.node, leg.throughput * share, leg.scatterings, is_diffuse, in_full);
  }

  /// Light that comes to a vertex by way of other diffuse surfaces.
  void gather(const Vertex& vertex, const Leg& leg) {
    for (const Lobe& lobe : vertex.lobes()) {
      if (is_delta(lobe) || !is_diffuse(letter(lobe))) continue;
      for (int i = 0; i < world_.gather_rays; ++i) {
        Leg ray = leg;
        if (!follow(vertex, follow_alone(vertex, lobe, walk_.sampler), ray)) gather_along(ray);
      }
    }
  }

  void gather_along(Leg leg) {
    while (leg.scatterings < world_.max_depth) {
      const std::optional<Hit> hit = meet(leg);
      if (!hit || is_black(leg.throughput)) return;
      const Vertex vertex = vertex_at(world_, walk_, *hit, leg.ray.direction);
      if (vertex.has_non_delta) look_up(*world_.photons, vertex, leg, 1 / static_cast<float>(world_.gather_rays));
      if (go_on(vertex, leg)) return;
    }
  }

  /// Follows one lobe that is not diffuse, or ends: where the draw was a diffuse lobe, whose light is gathered.
  std::optional<PathEnd> go_on(const Vertex& vertex, Leg& leg) {
    const std::optional<Drawn> drawn = draw_lobe(vertex, walk_.sampler);
    if (!drawn) return PathEnd::Absorbed;
    const Lobe& lobe = vertex.lobes()[drawn->index];
    if (is_delta(lobe)) return follow(vertex, follow_delta(vertex, *drawn), leg);
    if (is_diffuse(letter(lobe))) return PathEnd::Absorbed;
    Continuation next = follow_alone(vertex, lobe, walk_.sampler);
    next.factor *= 1 / vertex.selection[drawn->index];
    return follow(vertex, next, leg);
  }

  std::optional<PathEnd> follow(const Vertex& vertex, const Continuation& next, Leg& leg) {
    if (is_black(next.factor)) return PathEnd::Absorbed;
    leg.ray = next.ray;
    leg.node = walk_.step(leg.node, next.event, world_.labels.surface(vertex.hit));
    leg.throughput *= next.factor;
    leg.radiance_scale *= next.radiance_scale;
    leg.approach = {next.pdf_solid_angle, vertex.hit.position};
    ++leg.scatterings;
    if (next.transmitted && world_.has_bodies) leg.bodies.cross(world_.scene, vertex.hit.material, vertex.hit.front);
    if (!survives(walk_.sampler, leg.throughput, leg.radiance_scale, leg.scatterings)) return PathEnd::Roulette;
    return std::nullopt;
  }

  const World& world_;
  Walk& walk_;
};

}  // namespace

void trace_with_final_gathering(const World& world, Walk& walk, Ray ray) {
  FinalGathering(world, walk).trace(ray);
}

}  // namespace heckbert::transport
