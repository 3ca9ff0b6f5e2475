#include <heckbert/transport/light_to_eye.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace heckbert::transport {

using record::Technique;
using taxonomy::WordTrie;

namespace {

/// A point as the eye sees it.
struct Seen {
  Sight sight;
  PixelShare pixel{};
  float per_area = 0;          ///< pixels per area at the point that faces the eye
  float squared_distance = 1;  ///< from the lens

  bool is_seen() const { return pixel.weight > 0; }
};

class Splatting {
 public:
  Splatting(const World& world, Walk& walk, const LightWalk& light, Sampler& sampler, Rivalry rivalry)
      : world_(world), walk_(walk), light_(light), sampler_(sampler), rivalry_(rivalry) {}

  /// s = 1, t = 1.
  void light_itself() {
    const Emitted& start = *light_.start;
    if (!world_.eye.has_lens() && (rivalry_ == Rivalry::LightOnly || start.is_delta)) return;
    if (start.infinite) return sky();
    const Seen seen = see(start.ray.origin);
    if (!seen.is_seen()) return;
    const glm::vec3 to_eye = -seen.sight.direction;
    const Rgb sent = world_.emission.towards(start, to_eye);
    if (is_black(sent)) return;
    const bool on_surface = start.source.type == LightSource::Type::Emitter;
    const glm::vec3 from = on_surface && glm::dot(to_eye, start.normal) < 0
                               ? start.ray.origin - 2.0f * start.error * start.normal
                               : start.ray.origin;
    const Passage passage = passage_between(world_, walk_.rays, world_.bodies_at_eye, seen.sight.from, from);
    if (is_black(passage.transmittance)) return;
    const float cosine = on_surface ? std::abs(glm::dot(start.normal, to_eye)) : 1.0f;
    const Departure& d = start.departure;
    double rivals = 0;
    if (rivalry_ == Rivalry::All && !start.is_delta)
      rivals +=
          squared(static_cast<double>(seen.per_area * passage.chance * cosine * world_.pixel_share / d.pdf_place));
    if (world_.eye.has_lens()) rivals += lens_rival(pdf_departure(start, to_eye), seen, passage.chance);
    add(seen, walk_.sink.words().eye(world_.eye.kind()), 0,
        sent * passage.transmittance * (seen.per_area / d.pdf_place), rivals, 1);
  }

  /// t = 1, from the vertex with this number.
  void vertex(std::size_t number) {
    const LightVertex& at = light_.vertices[number];
    if (!can_be_joined(at)) return;
    const Place place = at.place();
    const Seen seen = see(place.position);
    if (!seen.is_seen()) return;
    const glm::vec3 to_eye = -seen.sight.direction;
    const Scattering scattering = scatter(world_.scene, at, to_eye);
    if (scattering.is_black()) return;
    const Passage passage = passage_between(world_, walk_.rays, place.bodies(world_.scene, at.bodies, to_eye),
                                            place.leave(to_eye), seen.sight.from);
    if (is_black(passage.transmittance)) return;
    double rivals = world_.eye.has_lens() ? lens_rival(pdf_to_eye(at, to_eye), seen, passage.chance) : 0;
    if (rivalry_ == Rivalry::All) {
      const float facing = place.facing(to_eye, passage.rate_begin);
      rivals += at.rivals.sum(static_cast<double>(seen.per_area * passage.chance * facing * world_.pixel_share),
                              static_cast<double>(scattering.pdf_to_light));
    }
    const Labels::Id label = place.label(world_.labels);
    const Rgb arriving = at.throughput * passage.transmittance * seen.per_area;
    const WordTrie::Node eye = walk_.sink.words().eye(world_.eye.kind());
    for (std::size_t i = 0; i < scattering.lobes; ++i) {
      if (is_black(scattering.f[i])) continue;
      const WordTrie::Node node = walk_.step(eye, scattering.letters[i], label);
      add(seen, node, number, arriving * scattering.f[i], rivals, number + 2);
    }
  }

  /// t = 0.
  void through_lens(const LensVertex& at) {
    const Seen seen{.sight = at.sight, .pixel = pixel_at(at.sight)};
    if (!seen.is_seen()) return;
    const float cosine = world_.eye.cosine(at.sight.direction);
    const double area = static_cast<double>(world_.eye.lens_area());
    Rivals others = at.rivals;
    if (rivalry_ == Rivalry::LightOnly) others.far = 0;
    const double rivals = others.sum(1 / area, static_cast<double>(at.sight.pixels * world_.pixel_share));
    add(seen, walk_.sink.words().eye(world_.eye.kind()), at.vertices,
        at.throughput * static_cast<float>(static_cast<double>(at.sight.pixels) / (area * static_cast<double>(cosine))),
        rivals, at.vertices + 2);
  }

 private:
  PixelShare pixel_at(const Sight& sight) {
    PixelShare pixel = world_.eye.pixel_at(sight.place, sampler_);
    const record::Window& w = world_.window;
    if (pixel.x < w.x0 || pixel.x >= w.x1 || pixel.y < w.y0 || pixel.y >= w.y1) pixel.weight = 0;
    return pixel;
  }

  Seen see(glm::vec3 point) {
    Seen seen{.sight = world_.eye.sight_of(point, sampler_)};
    if (!seen.sight.is_seen()) return seen;
    seen.pixel = pixel_at(seen.sight);
    const glm::vec3 d = point - seen.sight.from;
    if (!world_.eye.is_parallel()) seen.squared_distance = glm::dot(d, d);
    seen.per_area = seen.sight.pixels / seen.squared_distance;
    return seen;
  }

  /// Light from infinitely far away, seen directly.
  void sky() {
    const Emitted& start = *light_.start;
    Seen seen{.sight = world_.eye.sight_along(-start.ray.direction, sampler_)};
    const Sight& sight = seen.sight;
    if (!sight.is_seen()) return;
    seen.pixel = pixel_at(sight);
    seen.per_area = sight.pixels;
    if (!seen.is_seen()) return;
    const Passage passage =
        passage_to_infinity(world_, walk_.rays, world_.bodies_at_eye, {sight.from, sight.direction});
    if (is_black(passage.transmittance)) return;
    const Departure& d = start.departure;
    double rivals = world_.eye.has_lens() ? lens_rival(d.pdf / d.pdf_place, seen, passage.chance) : 0;
    if (rivalry_ == Rivalry::All && !start.is_delta)
      rivals += squared(static_cast<double>(sight.pixels * passage.chance * world_.pixel_share / d.pdf_place));
    add(seen, walk_.sink.words().eye(world_.eye.kind()), 0,
        start.radiance * passage.transmittance * (sight.pixels / d.pdf_place), rivals, 1);
  }

  /// Per steradian, of the direction alone.
  float pdf_departure(const Emitted& start, glm::vec3 direction) const {
    const Departure& d = start.departure;
    if (start.source.type != LightSource::Type::Emitter) return d.pdf / d.pdf_place;
    return d.pdf / d.pdf_place * std::abs(glm::dot(start.normal, direction)) / d.cosine;
  }

  /// The squared ratio of meeting the lens, if there is one, by chance to choosing this point of it; `chance` is that
  /// of getting there.
  double lens_rival(float pdf_to_eye, const Seen& seen, float chance) const {
    return squared(static_cast<double>(pdf_to_eye * chance * world_.eye.cosine(seen.sight.direction) /
                                       seen.squared_distance * world_.eye.lens_area()));
  }

  void add(const Seen& seen, WordTrie::Node node, std::size_t events, Rgb value, double rivals, std::size_t vertices) {
    const auto weight = static_cast<float>(weight_against(rivals)) * world_.pixel_share * seen.pixel.weight;
    walk_.sink.splat(
        seen.pixel.x, seen.pixel.y,
        {spell(world_, walk_, node, light_, events), value * weight, Technique{static_cast<std::uint16_t>(vertices)}});
  }

  const World& world_;
  Walk& walk_;
  const LightWalk& light_;
  Sampler& sampler_;
  Rivalry rivalry_;
};

}  // namespace

void splat(const World& world, Walk& walk, const LightWalk& light, Sampler& sampler, Rivalry rivalry) {
  if (!light.start) return;
  Splatting splatting(world, walk, light, sampler, rivalry);
  splatting.light_itself();
  for (std::size_t i = 0; i < light.vertices.size(); ++i) splatting.vertex(i);
  for (const LensVertex& at : light.through_lens) splatting.through_lens(at);
}

}  // namespace heckbert::transport
