#pragma once
// One vertex of a path: a hit with its local frame, its lobes, and the probabilities with which one of them is
// followed. All integrators share it; those that ask lights from the eye's side alone also share how direct light is
// gathered lobe by lobe.

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <heckbert/record/path_sink.h>
#include <heckbert/transport/bodies.h>
#include <heckbert/transport/eye.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/labels.h>
#include <heckbert/transport/lights.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/tracer.h>
#include <heckbert/transport/trail.h>

namespace heckbert::transport {

class Emission;
enum class Fault : std::uint8_t;  // fault.h
struct Passage;                   // travel.h
class PhotonMap;
class RadiositySolution;
struct LightWalk;

/// A scene ready to be traced.
struct World {
  const Scene& scene;
  const Tracer& tracer;
  const Lights& lights;
  const Eye& eye;
  const Labels& labels;
  int max_depth;
  bool has_bodies = false;  ///< some space is filled: with a medium, or with what a surface encloses
  Bodies bodies_at_eye{};
  const Emission& emission;
  record::Window window{};  ///< the part of the picture that is traced
  float pixel_share = 1;    ///< one over the number of its pixels
  Fault fault{};            ///< none, but in tests
  /// Where walks are merged too (vertex_merging.h), pi r^2 times the number of walks from the light; 0 elsewhere.
  double merging = 0;
  int gather_rays = 1;      ///< of final gathering, from each diffuse lobe
  bool one_branch = false;  ///< RecursiveOptions
  /// Of the sample number under way, for algorithms that use them.
  const PhotonMap* photons = nullptr;
  const PhotonMap* caustics = nullptr;  ///< those of caustics alone, for final gathering
  const std::deque<LightWalk>* virtual_lights = nullptr;
  const RadiositySolution* radiosity = nullptr;  ///< for the algorithms that show it
};

/// The end of a path at the light that was sampled from its last vertex.
TrailVertex trail_vertex(const record::Contribution& contribution, const LightSample& light);

/// What one camera sample carries along.
struct Walk {
  record::PathSink& sink;
  std::vector<record::Contribution>& found;  ///< by this sample; handed to the sink together when it ends
  Sampler sampler;
  bool wants_words = true;  ///< false when only the picture is asked for: nothing is spelt then
  std::uint64_t rays = 0;
  Bodies bodies{};         ///< that the walk is in
  Rgb cut_off{};           ///< light that the depth limit cut off, estimated
  Trail* trail = nullptr;  ///< unless paths are traced again: not kept

  taxonomy::WordTrie::Node step(taxonomy::WordTrie::Node node, taxonomy::Symbol letter, Labels::Id label) {
    return wants_words ? sink.words().step(node, letter, label) : node;
  }
  /// The walk stands at a vertex after so many scatterings, or has left the scene.
  void arrive(int depth, const TrailVertex& vertex) {
    if (trail != nullptr) trail->arrive(depth, vertex);
  }
  /// A path to the light that the walk stands at.
  void find(const record::Contribution& contribution) {
    // Member by member: a whole that was just put together is not read before all its stores are through.
    found.emplace_back(contribution.word, contribution.value, contribution.technique);
    if (trail != nullptr) trail->of_found.push_back(trail->vertices);
  }
  /// A path that goes on from here to a light.
  void find(const record::Contribution& contribution, const LightSample& light) {
    find(contribution);
    if (trail != nullptr) trail->of_found.back().push_back(trail_vertex(contribution, light));
  }
};

/// Where shading normals (interpolated or mapped) and the geometric normal disagree, two rules hold, in every algorithm
/// alike, so that all of them converge to one picture: a vertex is shaded with the first normal of mapped,
/// interpolated, flat that faces the ray and would mirror it to the outside; and an event keeps its side, so that a
/// direction counts only when both normals call it a reflection, or both a transmission. No cosine is corrected (Veach
/// 1997, 5.3).
struct Vertex {
  const Hit& hit;
  Frame frame;   ///< normal on the side the ray came from; s along u where the material asks for it
  glm::vec3 wo;  ///< local
  const Material* material;

  bool has_non_delta = false;
  bool transmits = false;                    ///< some lobe without a Dirac does
  bool has_choice = false;                   ///< following it chooses among lobes, or among the events of one
  float total_weight = 0;                    ///< sum of the selection weights; 0: the surface is black
  std::array<float, kMaxLobes> selection{};  ///< probability of following each lobe

  /// Keeps a reference to the hit. `index_in_front` is the index of refraction of what lies before the surface, which
  /// its interfaces are relative to.
  Vertex(const Scene& scene, const Hit& found, glm::vec3 ray_direction, float index_in_front = 1);

  /// The material's lobes as they are here, after textures and with their indices relative; none on the back of a
  /// one-sided material.
  std::span<const Lobe> lobes() const {
    if (lobes_here_) return std::span(*lobes_here_).first(lobe_count_);
    return std::span(material->lobes).first(lobe_count_);
  }
  /// What becomes of radiance from wi at the lobes without a Dirac.
  struct Values {
    /// Of each lobe, as LobeValue's. In a union, which does not set to zero what no lobe will use.
    union {
      Rgb f[kMaxLobes];
    };
    std::size_t lobes = 0;
    /// Of following any of them into wi, selection included: the density that multiple importance weights see.
    float pdf_solid_angle = 0;

    Values() {}
    std::span<const Rgb> of_lobes() const { return std::span(f).first(lobes); }
  };
  Values values(glm::vec3 wi) const;
  float pdf_solid_angle(glm::vec3 wi) const;
  /// The same, had the walk come along another wo; see as_seen_from().
  Values values(glm::vec3 from, glm::vec3 wi) const;
  float pdf_solid_angle(glm::vec3 from, glm::vec3 wi) const;
  /// The wo that a walk from that side, `to_walk` being unit, would have given this vertex. Its z is 0 when such a walk
  /// would have made another vertex: on the other side of the surface, or shaded with another normal.
  glm::vec3 as_seen_from(glm::vec3 to_walk) const;
  /// From wherever it is seen, it is shaded with the same normal.
  bool has_one_normal() const { return normal_ == Normal::Only; }
  /// A world direction as this vertex may use it: local, with a z of 0 when the shading and the geometric normal
  /// disagree about its side.
  glm::vec3 local(glm::vec3 world) const {
    glm::vec3 wi = frame.to_local(world);
    if (has_one_normal()) return wi;
    const bool same_side = (glm::dot(world, hit.normal_geometric) > 0) == hit.front;
    if ((wi.z > 0) != same_side) wi.z = 0;
    return wi;
  }
  /// The same of a direction that is local already.
  glm::vec3 usable(glm::vec3 local_direction) const {
    return has_one_normal() ? local_direction : local(frame.to_world(local_direction));
  }
  /// The ray that goes on; `transmitted` says on which side.
  Ray leave(glm::vec3 wi, bool transmitted) const {
    return {transport::leave(hit, hit.front != transmitted), frame.to_world(wi)};
  }

 private:
  /// Of the normals that the rule above tries, the one that this vertex is shaded with.
  enum class Normal : std::uint8_t { Only, First, Other };

  /// Sets the frame and wo by the rule above; the constructor does the same for the commonest case at once.
  void shade_with_first_valid(const Scene& scene, glm::vec3 ray_direction);
  /// Would a ray from wo be mirrored to the outside?
  bool is_valid(glm::vec3 wo_local) const;

  Normal normal_ = Normal::Only;
  std::size_t lobe_count_ = 0;
  std::optional<std::array<Lobe, kMaxLobes>> lobes_here_;
};

/// The normal that the material's map gives the front there. Takes: a hit with coordinates, a material with a map.
glm::vec3 mapped_normal(const Scene& scene, const Material& material, const Hit& hit);

/// The vertex that the walk stands at.
inline Vertex vertex_at(const World& world, const Walk& walk, const Hit& hit, glm::vec3 ray_direction) {
  return {world.scene, hit, ray_direction,
          world.has_bodies ? walk.bodies.index_in_front(world.scene, hit.material) : 1.0f};
}

/// The light sample's radiance as it arrives at the vertex; black when something is in between. `origin` is where the
/// shadow ray leaves the surface, on its far side when `transmitted`. `passage`: as arriving()'s.
Rgb arriving_light(const World& world, Walk& walk, const Vertex& vertex, bool transmitted, glm::vec3 origin,
                   const LightSample& light, Passage* passage = nullptr);

/// How direct light is gathered at a vertex.
struct DirectLight {
  bool multiple_importance = false;  ///< weigh against the chance of hitting the light by following a lobe
  bool glossy = true;                ///< glossy lobes too, or diffuse ones only
  /// Weigh each glossy lobe against the chance of hitting the light by following that lobe, and diffuse ones not at
  /// all: for tracers that follow glossy lobes one by one and diffuse ones never. In place of `multiple_importance`.
  bool follows_glossy = false;
};

/// Next-event estimation at a vertex: one light, one shadow ray, one contribution per non-delta lobe, all with one
/// common weight (design decision 2). `node` is the path up to but without this vertex.
void gather_direct_light(const World& world, Walk& walk, const Vertex& vertex, taxonomy::WordTrie::Node node,
                         Rgb throughput, const DirectLight& rule);

/// The same with a light that was chosen already, and that nothing shadows.
void gather_unshadowed_light(const World& world, Walk& walk, const Vertex& vertex, taxonomy::WordTrie::Node node,
                             Rgb throughput, const LightSample& light);

/// Next-event estimation as a colour, for light that belongs to no path.
Rgb direct_light(const World& world, Walk& walk, const Vertex& vertex, const DirectLight& rule);

/// k_a, which the ambient term multiplies.
Rgb ambient_reflectance(const Vertex& vertex);

/// The power heuristic with exponent two (Veach 1997, 9.2.4).
inline float power_heuristic(float pdf, float other) {
  const float ratio = other / pdf;
  return 1.0f / (1.0f + ratio * ratio);
}

/// A walk that goes on past the depth limit to find out what it cuts off: while this lives, nothing is spelt; in the
/// end what was found counts as cut off and not as found. A small share of walks does so and carries the light of all,
/// which is unbiased and costs little.
class PastTheLimit {
 public:
  static constexpr float kShare = 1.0f / 16.0f;

  explicit PastTheLimit(Walk& walk)
      : walk_(walk), found_(walk.found.size()), wanted_words_(std::exchange(walk.wants_words, false)) {}
  ~PastTheLimit() {
    for (std::size_t i = found_; i < walk_.found.size(); ++i) walk_.cut_off += walk_.found[i].value / kShare;
    walk_.found.resize(found_);
    if (walk_.trail != nullptr) walk_.trail->of_found.resize(found_);
    walk_.wants_words = wanted_words_;
  }
  PastTheLimit(const PastTheLimit&) = delete;
  PastTheLimit& operator=(const PastTheLimit&) = delete;

 private:
  Walk& walk_;
  std::size_t found_;
  bool wanted_words_;
};

/// A path that ran into a light: finishes its word and adds its value.
void add_hit(Walk& walk, taxonomy::WordTrie::Node node, taxonomy::Symbol kind, Labels::Id label, Rgb value);

}  // namespace heckbert::transport
