#pragma once
// A walk from a light: where it began, the vertices it visited, and what bidirectional weights need to know of it.
// Light tracing joins its vertices to the eye, bidirectional path tracing to the walk from the eye, photon mapping
// leaves photons there.
//
// Values are those of the adjoint: a vertex scatters by f(eye, light) with the side and the normal that a walk from the
// eye would see, in the measure of the geometric normal (Veach 1997, 5.3: where the shading normal differs, and where
// radiance is compressed by refraction, f is not symmetric). So walks from either end converge to one picture.
//
// Weights are the power heuristic with an exponent of two over all techniques (s, t). For a path x_0 (light) to x_k
// (eye) let p_s be the density of the technique with s vertices from the light. Neighbouring techniques differ in one
// vertex: p_(s-1) / p_s = p<-(x_(s-1)) / p->(x_(s-1)), with p-> and p<- the densities per area of the walks from the
// light and from the eye. The sum over all techniques with fewer light vertices,
//
//     A_s = sum over j < s of (p_j / p_s)^2 = p<-(x_(s-1))^2 (near + pdf<-^2 far),
//
// needs two numbers at each vertex x_i, made from those of the vertex before while the walk goes on (van Antwerpen
// 2011, "Recursive MIS Computation for Streaming BDPT on the GPU"; Georgiev 2012, "Implementing Vertex Connection and
// Merging"):
//
//     near_i = [x_(i-1) can be joined to x_i] / p->(x_i)^2
//     far_i  = (g_(i-1) / p->(x_i))^2 (near_(i-1) + pdf<-(x_(i-1) to x_(i-2))^2 far_(i-1))
//
// with p<-(x_i) = pdf<- g_i, pdf<- per steradian, and g the cosine over the squared distance. At an event of a Dirac
// the density of either direction counts as one and near_(i-1) as zero. The walk from the eye keeps the same two
// numbers.
//
// Media (Lafortune and Willems 1996, "Rendering Participating Media with Bidirectional Path Tracing"; Raab, Seibert and
// Keller 2008, "Unbiased Global Illumination with Participating Media"). A particle scatters by its phase function,
// without cosines, and its density is per volume. So in g the place of the cosine is taken by the rate with which free
// flights end there, per length; and every edge has a factor more, the chance of flights to get through it, which is
// the same from both its ends and so goes with the squared distance. Both are Passage's.

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include <glm/geometric.hpp>

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/emission.h>
#include <heckbert/transport/place.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

/// The power heuristic against techniques whose squared ratios of density to one's own add up to `rivals`.
constexpr double weight_against(double rivals) {
  return 1 / (1 + rivals);
}

/// What bidirectional weights know of a walk up to a vertex; see above.
struct Rivals {
  double near = 0, far = 0;
  /// The sum of the squared ratios of all techniques in which this vertex is of the other walk, which reaches it with
  /// `pdf_area` and would go on from it along this walk's own way with `pdf_solid_angle`.
  constexpr double sum(double pdf_area, double pdf_solid_angle) const {
    return pdf_area * pdf_area * (near + pdf_solid_angle * pdf_solid_angle * far);
  }
};

constexpr double squared(double x) {
  return x * x;
}

/// One step of a walk, from a vertex to the next.
struct Step {
  bool is_delta = false;
  bool is_from_particle = false;
  double pdf_solid_angle = 0;   ///< with which it was drawn; of a Dirac: not read
  double pdf_reverse = 0;       ///< with which the other walk would have gone on from here along this walk's way; of a
                                ///< Dirac: 1 if it could
  double facing_from = 0;       ///< Place::facing() where it begins
  double facing_to = 1;         ///< where it ends; 1 at infinity
  double squared_distance = 1;  ///< 1 to infinity; over the chance to get through

  /// What is known once the step is made.
  void end(const Passage& passage, double facing, double squared) {
    if (is_from_particle) facing_from = static_cast<double>(passage.rate_begin);
    facing_to = facing;
    squared_distance = squared / static_cast<double>(passage.chance);
  }
};
Rivals rivals_after(const Rivals& before, const Step& step);

/// An event of a walk, for spelling.
struct Event {
  taxonomy::Symbol symbol = taxonomy::Symbol::Dr;
  Labels::Id label = 0;
};

/// A surface or a particle that a walk from the light came to.
struct LightVertex {
  Hit hit{};                         ///< of a particle: nothing but its position
  const Medium* particle = nullptr;  ///< of this medium; null: a surface
  glm::vec3 to_light;                ///< unit, towards the vertex before
  Bodies bodies;                     ///< that it is in, on the side from which the light came
  float index_in_front = 1;          ///< of refraction, of a surface
  std::optional<Vertex> surface;     ///< as seen from there; none at a particle
  Rgb throughput;                    ///< of the light that arrives, over the density of the walk
  Rivals rivals;

  LightVertex(const World& world, const Hit& found, glm::vec3 direction, const Bodies& around, Rgb light)
      : hit(found),
        to_light(-direction),
        bodies(around),
        index_in_front(world.has_bodies ? around.index_in_front(world.scene, found.material) : 1.0f),
        throughput(light) {
    surface.emplace(world.scene, hit, direction, index_in_front);
  }
  LightVertex(const World& world, glm::vec3 position, glm::vec3 direction, const Bodies& around, Rgb light)
      : particle(around.medium(world.scene)), to_light(-direction), bodies(around), throughput(light) {
    hit.position = position;
  }
  LightVertex(const LightVertex&) = delete;
  LightVertex& operator=(const LightVertex&) = delete;

  Place place() const { return {particle == nullptr ? &hit : nullptr, particle, hit.position}; }
};

/// A walk from the light that came through the eye's lens after `vertices` scatterings.
struct LensVertex {
  std::size_t vertices = 0;
  Sight sight;
  Rgb throughput;
  Rivals rivals;
};

struct LightWalk {
  std::optional<Emitted> start{};
  std::deque<LightVertex> vertices{};  ///< at most as many as scatterings are allowed
  std::vector<Event> events{};         ///< by vertex, where the walk went on
  std::vector<LensVertex> through_lens{};
};

/// Walks from a light until the light is absorbed, leaves, or has scattered so often that the path is full; ended by
/// roulette as survives_from() says. Counts its rays.
LightWalk walk_from_light(const World& world, std::uint64_t& rays, Sampler& sampler, Particles particles,
                          int roulette_start = kRouletteStart);

/// Is it a particle, or has its surface a lobe without a Dirac, on whichever side?
bool can_be_joined(const LightVertex& vertex);

/// A surface or a particle in the light of one direction as a place beyond it sees it.
struct Scattering {
  /// Of each lobe, in the measure of the geometric normal; times the cosine, at a surface, with the direction in which
  /// the walk does not come.
  union {  // as Vertex::Values::f
    Rgb f[kMaxLobes];
  };
  std::array<taxonomy::Symbol, kMaxLobes> letters;  ///< of each lobe
  std::size_t lobes = 0;
  float pdf_to_light = 0;  ///< with which a walk from the eye would go on to the vertex before; per steradian

  Scattering() {}
  std::span<const Rgb> of_lobes() const { return std::span(f).first(lobes); }
  bool is_black() const {
    return std::ranges::all_of(of_lobes(), [](Rgb value) { return heckbert::is_black(value); });
  }
};
/// `to_eye` is unit.
Scattering scatter(const Scene& scene, const LightVertex& vertex, glm::vec3 to_eye);

/// The density with which the walk from the light would go on that way, per steradian.
float pdf_to_eye(const LightVertex& vertex, glm::vec3 to_eye);

/// The density with which a walk that comes from the light's side, and not from where the vertex was seen, leaves its
/// surface for the eye's side; per steradian.
float pdf_from_light(const Scene& scene, const Vertex& vertex, float index_in_front, glm::vec3 to_light,
                     glm::vec3 to_eye);

/// The word of a path whose part nearest the eye is spelt at `node`: adds the first `count` events of the walk from the
/// light, the last first, and the light.
taxonomy::WordTrie::Node spell(const World& world, Walk& walk, taxonomy::WordTrie::Node node, const LightWalk& light,
                               std::size_t count);

}  // namespace heckbert::transport
