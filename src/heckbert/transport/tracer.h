#pragma once
// Ray queries over a scene. This header knows nothing of Embree; embree_tracer.cpp is the one file that does.
//
// A ray that leaves a surface must neither hit that surface again where it stands nor skip another one close behind it.
// Every hit therefore carries a bound on the rounding error of its position and of the next intersection test, and
// leave() moves the origin by just that much along the geometric normal, to the side the ray goes to: a few millionths
// of the size of the numbers involved, and on the right side of the surface, so that a ball of glass is entered and
// left in pairs at any angle and any scale.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/emitter.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

struct Ray {
  glm::vec3 origin;
  glm::vec3 direction;  ///< unit
};

inline constexpr std::uint32_t kNoEmitter = std::numeric_limits<std::uint32_t>::max();

struct Hit {
  glm::vec3 position;
  glm::vec3 normal_geometric;  ///< unit, on the front of the surface
  glm::vec3 normal_shading;    ///< unit; equal to normal_geometric on flat surfaces
  bool front = true;           ///< the ray came from the front
  float error = 0;             ///< distance in scene units by which a ray leaving here must clear the surface
  std::uint32_t material = 0;
  std::uint32_t shape = 0;             ///< number of the shape: those of the scene, then those of its groups
  std::uint32_t primitive = 0;         ///< of a mesh: its triangle
  std::uint32_t emitter = kNoEmitter;  ///< index into Tracer's emitters, when the surface emits
  bool has_coordinates = false;        ///< the material asks for texture coordinates: the following are set
  glm::vec2 uv;
  glm::vec3 along_u, along_v;  ///< how the position moves with u and with v; zero where the coordinates stand still

  Hit() {}  // not `= default`, or every hit would be set to zero before it is filled
};

/// How far from a point a ray must start to clear the shape that it lies on. `size`: of the shape, or of its triangle
/// there; `placement`: of the offset in its transform.
inline float clearance(glm::vec3 position, float placement, float size) {
  // The rounding error of Embree's triangle and sphere tests, relative to the coordinates and extents involved, is
  // below half a millionth: six roundings of 2^-24 in the plane distance, four in the squared distance to a sphere's
  // axis divided by twice its radius. Four times that is clear of both.
  constexpr float kRelativeError = 2e-6f;
  const float farthest = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
  return kRelativeError * (farthest + placement + size);
}

/// The hit's position moved off the surface to its front or its back. The side is the event's to say, not a cosine's:
/// at grazing angles its sign is noise.
inline glm::vec3 leave(const Hit& hit, bool to_front) {
  return hit.position + (to_front ? hit.error : -hit.error) * hit.normal_geometric;
}

class Tracer {
 public:
  /// Errors: std::invalid_argument for indices out of range, a sphere without a radius or under a transform that is no
  /// similarity.
  explicit Tracer(const Scene& scene);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// The nearest hit, at most `farthest` away.
  std::optional<Hit> intersect(const Ray& ray, float farthest = std::numeric_limits<float>::infinity()) const;
  /// Is anything between the two points? Both must already be off their surfaces.
  bool is_occluded(glm::vec3 from, glm::vec3 to) const;
  /// Is anything in this direction, however far?
  bool is_occluded(const Ray& ray) const;

  const std::vector<Emitter>& emitters() const;
  glm::vec3 bounds_low() const;
  glm::vec3 bounds_high() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heckbert::transport
