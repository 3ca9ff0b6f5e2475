#include <heckbert/transport/bidirectional.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/joint.h>
#include <heckbert/transport/light_to_eye.h>
#include <heckbert/transport/vertex_merging.h>

namespace heckbert::transport {

using record::PathEnd;
using record::Technique;
using taxonomy::Symbol;
using taxonomy::WordTrie;

namespace {

/// From how many scatterings on roulette may end a walk.
struct RouletteStarts {
  int eye = kRouletteStart, light = kRouletteStart;
};

/// A path of many scatterings is found by many pairs of walks, so each of them may end sooner than one that is alone;
/// but not at a Dirac, where nothing is joined (docs/performance.md, "Roulette on two walks"). With photons it was not
/// measured.
RouletteStarts roulette_starts(const World& world) {
  return world.photons == nullptr ? RouletteStarts{.eye = 3, .light = 1} : RouletteStarts{};
}

class EyeWalk {
 public:
  EyeWalk(const World& world, Walk& walk, const LightWalk& light, int roulette_start)
      : world_(world), walk_(walk), light_(light), roulette_start_(roulette_start) {}

  void trace(Ray ray) {
    WordTrie::Node node = walk_.sink.words().eye(world_.eye.kind());
    Rgb throughput(1.0f);
    Rivals rivals;
    Step step;
    float radiance_scale = 1;
    for (int depth = 0;; ++depth) {
      const glm::vec3 from = ray.origin;
      Passage passage;
      const auto [hit, scattered] = travel(world_, walk_, ray, throughput, Particles::Scatter, &passage);
      if (is_black(throughput)) return walk_.sink.end_path(PathEnd::Absorbed);
      if (!hit && !scattered) {
        step.end(passage, 1, 1);
        rivals = depth == 0 ? first_rivals(ray, step, true) : rivals_after(rivals, step);
        add_sky(ray, node, throughput, rivals, depth);
        return walk_.sink.end_path(world_.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
      }
      const glm::vec3 d = (hit ? hit->position : ray.origin) - from;
      const float facing = hit ? cosine(*hit, ray.direction) : passage.rate_end;
      if (!(facing > 0)) return walk_.sink.end_path(PathEnd::Absorbed);
      const bool is_seen_in_parallel = depth == 0 && world_.eye.is_parallel();
      step.end(passage, static_cast<double>(facing), is_seen_in_parallel ? 1.0 : static_cast<double>(glm::dot(d, d)));
      rivals = depth == 0 ? first_rivals(ray, step, false) : rivals_after(rivals, step);
      if (hit) add_emitted(*hit, from, ray.direction, node, throughput, rivals, depth);
      if (depth == world_.max_depth) return walk_.sink.end_path(PathEnd::DepthLimit);

      if (hit) rivals.near += squared(world_.merging);
      EyeVertex at{
          .to_eye = -ray.direction, .throughput = throughput, .rivals = rivals, .node = node, .scatterings = depth};
      std::optional<Vertex> surface;
      if (hit) {
        at.index_in_front = world_.has_bodies ? walk_.bodies.index_in_front(world_.scene, hit->material) : 1.0f;
        at.surface = &surface.emplace(world_.scene, *hit, ray.direction, at.index_in_front);
        at.position = hit->position;
      } else {
        at.particle = walk_.bodies.medium(world_.scene);
        at.position = ray.origin;
      }
      if (!hit || surface->has_non_delta) {
        join_light(at);
        for (std::size_t i = 0; i < light_.vertices.size() && depth + static_cast<int>(i) + 2 <= world_.max_depth; ++i)
          join_vertex(at, i);
        if (hit && world_.photons != nullptr) merge(world_, walk_, at);
      }
      const Continuation next =
          hit ? follow(*surface, walk_.sampler) : follow_particle(*at.particle, ray, walk_.sampler);
      throughput *= next.factor;
      radiance_scale *= next.radiance_scale;
      if (is_black(throughput)) return walk_.sink.end_path(PathEnd::Absorbed);
      const bool is_delta = next.pdf_solid_angle == 0;
      const float left = is_delta ? 1.0f : max_channel(next.factor) / next.radiance_scale;
      if (!survives_from(roulette_start_, walk_.sampler, throughput, radiance_scale, left, depth + 1))
        return walk_.sink.end_path(PathEnd::Roulette);
      const Place place = at.place();
      node = walk_.step(node, next.event, place.label(world_.labels));
      const glm::vec3 onward = next.ray.direction;
      step = {.is_delta = is_delta,
              .is_from_particle = !hit,
              .pdf_solid_angle = static_cast<double>(next.pdf_solid_angle),
              .pdf_reverse = is_delta ? 1.0 : at.pdf_to_eye(world_.scene, onward),
              .facing_from = static_cast<double>(place.facing(onward, 0))};
      if (next.transmitted && world_.has_bodies) walk_.bodies.cross(world_.scene, hit->material, hit->front);
      ray = next.ray;
    }
  }

 private:
  /// Where the first edge from the eye ends: joining to the eye, and meeting the lens by chance.
  Rivals first_rivals(const Ray& ray, const Step& step, bool infinite) const {
    const Eye& eye = world_.eye;
    // A parallel eye sees what is infinitely far away in one direction, which nothing else could choose.
    if (infinite && eye.is_parallel()) return {};
    const double area = step.squared_distance;
    const double reached =
        static_cast<double>(eye.pixels_along(ray.direction) * world_.pixel_share) * step.facing_to / area;
    Rivals rivals{.near = squared(1 / reached)};
    if (eye.has_lens())
      rivals.far = squared(static_cast<double>(eye.cosine(ray.direction) * eye.lens_area()) / area / reached);
    return rivals;
  }

  /// s = 0, infinitely far away.
  void add_sky(const Ray& ray, WordTrie::Node node, Rgb throughput, const Rivals& rivals, int depth) {
    const Rgb sky = world_.lights.environment(ray.direction);
    if (is_black(sky)) return;
    const Departure d = world_.emission.departure_from_sky(-ray.direction);
    const float place = depth == 0 ? d.pdf_place : world_.lights.pdf_environment(ray.direction);
    add_hit(node, Symbol::Le, {LightSource::Type::Environment, 0}, throughput * sky, rivals, d, place);
  }

  /// s = 0.
  void add_emitted(const Hit& hit, glm::vec3 from, glm::vec3 direction, WordTrie::Node node, Rgb throughput,
                   const Rivals& rivals, int depth) {
    const Rgb emitted = world_.lights.emitted(hit);
    if (is_black(emitted)) return;
    const Departure d = world_.emission.departure(hit, -direction);
    float place = d.pdf_place;
    if (depth > 0) {
      const glm::vec3 edge = hit.position - from;
      place = world_.lights.pdf_solid_angle(hit, from) * d.cosine / glm::dot(edge, edge);
    }
    add_hit(node, Symbol::La, {LightSource::Type::Emitter, hit.emitter}, throughput * emitted, rivals, d, place);
  }

  void add_hit(WordTrie::Node node, Symbol kind, LightSource source, Rgb value, const Rivals& rivals,
               const Departure& departure, float pdf_place) {
    const double others = squared(static_cast<double>(pdf_place)) * rivals.near +
                          squared(static_cast<double>(departure.pdf)) * rivals.far;
    walk_.find({walk_.step(node, kind, world_.labels.light(source)), value * static_cast<float>(weight_against(others)),
                Technique::Hit});
  }

  /// s = 1.
  void join_light(const EyeVertex& at) {
    const LightSample light = world_.lights.sample(at.position, walk_.sampler);
    if (!(light.pdf_solid_angle > 0)) return;
    const Scattering scattering = scatter(at, light.direction);
    if (scattering.is_black()) return;
    Passage passage;
    const Rgb arriving = arriving_light(world_, walk_, at, light, passage);
    if (is_black(arriving)) return;

    const auto pdf_light = static_cast<double>(light.pdf_solid_angle), chance = static_cast<double>(passage.chance);
    const Place place = at.place();
    const Departure departure = world_.emission.departure(light);
    const glm::vec3 edge = light.target - at.position;
    const double measure = light.infinite   ? 1.0
                           : light.is_delta ? static_cast<double>(glm::dot(edge, edge))
                                            : static_cast<double>(departure.cosine);
    const double facing = static_cast<double>(place.facing(light.direction, passage.rate_begin));
    const double reached = static_cast<double>(departure.pdf) * facing * chance / (pdf_light * measure);
    double others = at.rivals.sum(reached, at.pdf_to_eye(world_.scene, light.direction));
    if (!light.is_delta) others += squared(static_cast<double>(scattering.pdf_to_light) * chance / pdf_light);

    const Rgb incident =
        at.throughput * arriving * (static_cast<float>(weight_against(others)) / light.pdf_solid_angle);
    for (std::size_t i = 0; i < scattering.lobes; ++i) {
      if (is_black(scattering.f[i])) continue;
      const WordTrie::Node node = walk_.step(at.node, scattering.letters[i], place.label(world_.labels));
      walk_.find({walk_.step(node, light.kind, world_.labels.light(light.source)), incident * scattering.f[i],
                  Technique::NextEvent});
    }
  }

  /// s > 1, with the vertex of this number on the walk from the light.
  void join_vertex(const EyeVertex& at, std::size_t number) {
    const LightVertex& other = light_.vertices[number];
    const Joint joint = join(world_.scene, at, other);
    if (joint.is_black()) return;
    const Passage passage = passage_along(world_, walk_, at, other, joint);
    if (is_black(passage.transmittance)) return;
    const float facing_here = at.place().facing(joint.direction, passage.rate_begin);
    const float facing_there = other.place().facing(joint.direction, passage.rate_end);
    const float reaching = passage.chance / joint.squared_distance;
    const auto pdf_there = static_cast<double>(joint.here.pdf_to_light * facing_there * reaching);
    const auto pdf_here = static_cast<double>(pdf_to_eye(other, -joint.direction) * facing_here * reaching);
    const double others = other.rivals.sum(pdf_there, static_cast<double>(joint.there.pdf_to_light)) +
                          at.rivals.sum(pdf_here, at.pdf_to_eye(world_.scene, joint.direction));
    add_joint(world_, walk_, at, light_, number, joint,
              at.throughput * other.throughput * passage.transmittance *
                  (static_cast<float>(weight_against(others)) / joint.squared_distance));
  }

  const World& world_;
  Walk& walk_;
  const LightWalk& light_;
  int roulette_start_;
};

}  // namespace

void trace_bidirectionally(const World& world, Walk& walk, Ray ray) {
  const RouletteStarts starts = roulette_starts(world);
  Sampler sampler = walk.sampler.split();
  const LightWalk light = walk_from_light(world, walk.rays, sampler, Particles::Scatter, starts.light);
  splat(world, walk, light, sampler, Rivalry::All);
  EyeWalk(world, walk, light, starts.eye).trace(ray);
}

}  // namespace heckbert::transport
