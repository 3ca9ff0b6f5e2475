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

class EyeWalk {
 public:
  EyeWalk(const World& world, Walk& walk, const LightWalk& light) : world_(world), walk_(walk), light_(light) {}

  void trace(Ray ray) {
    WordTrie::Node node = walk_.sink.words().eye(world_.eye.kind());
    Rgb throughput(1.0f);
    Rivals rivals;
    Step step;
    float radiance_scale = 1;
    for (int depth = 0;; ++depth) {
      ++walk_.rays;
      const std::optional<Hit> hit = world_.tracer.intersect(ray);
      if (!hit) {
        rivals = depth == 0 ? first_rivals(ray, 1, 1, true) : rivals_after(rivals, step);
        add_sky(ray, node, throughput, rivals, depth);
        return walk_.sink.end_path(world_.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
      }
      step.cos_to = static_cast<double>(cosine(*hit, ray.direction));
      const glm::vec3 d = hit->position - ray.origin;
      step.squared_distance = static_cast<double>(glm::dot(d, d));
      if (!(step.cos_to > 0)) return walk_.sink.end_path(PathEnd::Absorbed);
      rivals = depth == 0 ? first_rivals(ray, step.cos_to, step.squared_distance, false) : rivals_after(rivals, step);
      add_emitted(*hit, ray, node, throughput, rivals, depth);
      if (depth == world_.max_depth) return walk_.sink.end_path(PathEnd::DepthLimit);

      rivals.near += squared(world_.merging);
      const Vertex vertex(world_.scene, *hit, ray.direction);
      const EyeVertex at{vertex, -ray.direction, throughput, rivals, node, depth};
      if (vertex.has_non_delta) {
        join_light(at);
        for (std::size_t i = 0; i < light_.vertices.size() && depth + static_cast<int>(i) + 2 <= world_.max_depth; ++i)
          join_vertex(at, i);
        if (world_.photons != nullptr) merge(world_, walk_, at);
      }
      const Continuation next = follow(vertex, walk_.sampler);
      throughput *= next.factor;
      radiance_scale *= next.radiance_scale;
      if (is_black(throughput)) return walk_.sink.end_path(PathEnd::Absorbed);
      if (!survives(walk_.sampler, throughput, radiance_scale, depth + 1))
        return walk_.sink.end_path(PathEnd::Roulette);
      node = walk_.step(node, next.event, world_.labels.surface(*hit));
      const glm::vec3 onward = next.ray.direction;
      const bool is_delta = next.pdf_solid_angle == 0;
      step = {.is_delta = is_delta,
              .pdf_solid_angle = static_cast<double>(next.pdf_solid_angle),
              .pdf_reverse = is_delta ? (is_shaded_alike(world_.scene, vertex, onward) ? 1.0 : 0.0)
                                      : at.pdf_to_eye(world_.scene, onward),
              .cos_from = static_cast<double>(cosine(*hit, onward))};
      ray = next.ray;
    }
  }

 private:
  /// Where the first edge from the eye ends: joining to the eye, and meeting the lens by chance.
  Rivals first_rivals(const Ray& ray, double cos_to, double squared_distance, bool infinite) const {
    const Eye& eye = world_.eye;
    // A parallel eye sees what is infinitely far away in one direction, which nothing else could choose.
    if (infinite && eye.is_parallel()) return {};
    const double area = infinite || eye.is_parallel() ? 1.0 : squared_distance;
    const double reached = static_cast<double>(eye.pixels_along(ray.direction) * world_.pixel_share) * cos_to / area;
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
  void add_emitted(const Hit& hit, const Ray& ray, WordTrie::Node node, Rgb throughput, const Rivals& rivals,
                   int depth) {
    const Rgb emitted = world_.lights.emitted(hit);
    if (is_black(emitted)) return;
    const Departure d = world_.emission.departure(hit, -ray.direction);
    float place = d.pdf_place;
    if (depth > 0) {
      const glm::vec3 edge = hit.position - ray.origin;
      place = world_.lights.pdf_solid_angle(hit, ray.origin) * d.cosine / glm::dot(edge, edge);
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
    const Vertex& vertex = at.vertex;
    const Hit& hit = vertex.hit;
    const LightSample light = world_.lights.sample(hit.position, walk_.sampler);
    if (!(light.pdf_solid_angle > 0)) return;
    const glm::vec3 wi = vertex.local(light.direction);
    if (wi.z == 0 || (wi.z < 0 && !vertex.transmits)) return;
    const bool transmitted = wi.z < 0;
    const Vertex::Values values = vertex.values(wi);
    const std::span<const Lobe> lobes = vertex.lobes();
    if (std::ranges::all_of(std::span(values.f).first(lobes.size()), [](Rgb f) { return is_black(f); })) return;
    const Rgb arriving =
        arriving_light(world_, walk_, vertex, transmitted, leave(hit, hit.front != transmitted), light);
    if (is_black(arriving)) return;

    const auto pdf_light = static_cast<double>(light.pdf_solid_angle);
    const Departure departure = world_.emission.departure(light);
    const glm::vec3 edge = light.target - hit.position;
    const double measure = light.infinite   ? 1.0
                           : light.is_delta ? static_cast<double>(glm::dot(edge, edge))
                                            : static_cast<double>(departure.cosine);
    const double reached = static_cast<double>(departure.pdf * cosine(hit, light.direction)) / (pdf_light * measure);
    double others = at.rivals.sum(reached, at.pdf_to_eye(world_.scene, light.direction));
    if (!light.is_delta) others += squared(static_cast<double>(values.pdf_solid_angle) / pdf_light);

    const Rgb incident = at.throughput * arriving *
                         (std::abs(wi.z) / light.pdf_solid_angle * static_cast<float>(weight_against(others)));
    for (std::size_t i = 0; i < lobes.size(); ++i) {
      if (is_black(values.f[i])) continue;
      const WordTrie::Node node = walk_.step(at.node, letter(lobes[i], transmitted), world_.labels.surface(hit));
      walk_.find({walk_.step(node, light.kind, world_.labels.light(light.source)), incident * values.f[i],
                  Technique::NextEvent});
    }
  }

  /// s > 1, with the vertex of this number on the walk from the light.
  void join_vertex(const EyeVertex& at, std::size_t number) {
    const LightVertex& other = light_.vertices[number];
    const std::optional<Joint> joint = join(world_.scene, at.vertex, other);
    if (!joint || is_blocked(world_, walk_, at.vertex, other, *joint)) return;
    const float d2 = joint->squared_distance;
    const float cos_here = cosine(at.vertex.hit, joint->direction);
    const auto pdf_there = static_cast<double>(joint->here.pdf_solid_angle * joint->cos_there / d2);
    const auto pdf_here = static_cast<double>(pdf_to_eye(other, -joint->direction) * cos_here / d2);
    const double others = other.rivals.sum(pdf_there, static_cast<double>(joint->there.pdf_to_light)) +
                          at.rivals.sum(pdf_here, at.pdf_to_eye(world_.scene, joint->direction));
    const float geometry = std::abs(joint->wi.z) * joint->cos_there / d2;
    add_joint(world_, walk_, at.vertex, at.node, light_, number, *joint,
              at.throughput * other.throughput * (geometry * static_cast<float>(weight_against(others))));
  }

  const World& world_;
  Walk& walk_;
  const LightWalk& light_;
};

}  // namespace

void trace_bidirectionally(const World& world, Walk& walk, Ray ray) {
  Sampler sampler = walk.sampler.split();
  const LightWalk light = walk_from_light(world, walk.rays, sampler);
  splat(world, walk, light, sampler, Rivalry::All);
  EyeWalk(world, walk, light).trace(ray);
}

}  // namespace heckbert::transport
