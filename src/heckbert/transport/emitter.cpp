#include <heckbert/transport/emitter.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/spherical_triangle.h>

namespace heckbert::transport {

namespace {

using Form = Emitter::Form;

/// Beyond this distance, in extents of the piece, a triangle is drawn by area: the squared distance to its points
/// varies by less than a factor of three.
constexpr float kFarTriangle = 4;
/// Beyond this one a rectangle is drawn by area, more often where it is nearer: as good as by solid angle, and cheaper
/// (measured: docs/performance.md).
constexpr float kFarRectangle = 2;
/// A flat piece that covers less than this (in steradian) at close range is seen edge on and left out.
constexpr double kEdgeOn = 1e-9;

bool is_near(const Emitter& e, glm::vec3 from, float far) {
  const glm::vec3 d = e.center - from;
  const float reach = far * e.extent;
  return glm::dot(d, d) < reach * reach;
}

bool is_outside_sphere(const Emitter& e, float distance2) {
  const float clear = e.radius + e.error;
  return distance2 > clear * clear;
}

/// 1 - cos of the cone that a sphere subtends, without cancellation.
float one_minus_cos_cone(const Emitter& sphere, float distance2) {
  const float sin2 = sphere.radius * sphere.radius / distance2;
  return sin2 / (1.0f + std::sqrt(std::max(0.0f, 1.0f - sin2)));
}

/// Of a point whose density per area is one over `area`.
float pdf_by_area(float area, glm::vec3 from, glm::vec3 position, glm::vec3 normal) {
  const glm::vec3 d = position - from;
  const float distance2 = glm::dot(d, d);
  const float cos_times_distance = std::abs(glm::dot(d, normal));
  return cos_times_distance > 0 ? distance2 * std::sqrt(distance2) / (area * cos_times_distance) : 0.0f;
}

SphericalTriangle spherical_triangle(const Emitter& e, glm::vec3 from) {
  return {e.origin, e.origin + e.edge_u, e.origin + e.edge_v, e.normal, from};
}

/// A point and its density where the whole piece has the same one.
template <class Spherical>
SurfaceSample sample_by_solid_angle(const Spherical& spherical, const Emitter& e, glm::vec2 u) {
  if (!(spherical.solid_angle() > kEdgeOn)) return {};
  return {spherical.sample(u), e.normal, static_cast<float>(1 / spherical.solid_angle())};
}

template <class Spherical>
float pdf_by_solid_angle(const Spherical& spherical) {
  return spherical.solid_angle() > kEdgeOn ? static_cast<float>(1 / spherical.solid_angle()) : 0.0f;
}

/// A direction in the cone that the sphere subtends, then the nearer of its two intersections with the sphere (Shirley,
/// Wang, Zimmerman 1996), written as a point on the sphere so that a shadow ray ends exactly there. Its angle at the
/// centre follows from the law of sines, which stays exact for a sphere as small and far as a star.
SurfaceSample sample_cone(const Emitter& e, glm::vec3 from, float distance2, glm::vec2 u) {
  const float distance = std::sqrt(distance2);
  const float whole = one_minus_cos_cone(e, distance2);
  const float one_minus_cos = u.x * whole;
  const float sin2_theta = one_minus_cos * (2.0f - one_minus_cos);
  const float in_radii = distance / e.radius;
  const float cos_alpha =
      std::min(1.0f, sin2_theta * in_radii +
                         (1.0f - one_minus_cos) * std::sqrt(std::max(0.0f, 1.0f - sin2_theta * in_radii * in_radii)));
  const float sin_alpha = std::sqrt(std::max(0.0f, 1.0f - cos_alpha * cos_alpha));
  const float phi = 2.0f * kPi * u.y;
  const glm::vec3 normal = Frame::around((from - e.center) / distance)
                               .to_world({sin_alpha * std::cos(phi), sin_alpha * std::sin(phi), cos_alpha});
  return {e.center + e.radius * normal, normal, 1.0f / (2.0f * kPi * whole)};
}

SurfaceSample sample_by_area(const Emitter& e, glm::vec3 from, glm::vec2 u) {
  SurfaceSample s = sample_area(e, u);
  s.pdf_solid_angle = pdf_by_area(e.area, from, s.position, s.normal);
  return s;
}

// A rectangle from afar. By solid angle its density per area goes as one over the cubed distance, whose logarithm is
// nearly linear over the rectangle: along an edge v it grows by s = 3 (from - c).v / r^2, with the centre c and the
// mean of the squared distance, r^2. The warp t = u + a u (1 - u) of the unit interval has the density
// 1 / (1 + a (1 - 2 u)) at t, whose logarithm grows by s at the centre when a = s / 2; so one warp for either edge
// (to be composed with others as in Hart et al. 2020, "Practical Product Sampling by Fitting and Composing Warps").

/// a, for both edges. Less than one, where the warp would stop being monotonic.
[[gnu::always_inline]] inline glm::vec2 warp_of_far_rectangle(const Emitter& e, glm::vec3 from) {
  constexpr float kMost = 0.8f;
  const glm::vec3 d = from - e.center;
  const float per_length = 1.5f / (glm::dot(d, d) + e.extent * e.extent * (1.0f / 3.0f));
  return {std::clamp(per_length * glm::dot(d, e.edge_u), -kMost, kMost),
          std::clamp(per_length * glm::dot(d, e.edge_v), -kMost, kMost)};
}

SurfaceSample sample_far_rectangle(const Emitter& e, glm::vec3 from, glm::vec2 u) {
  const glm::vec2 a = warp_of_far_rectangle(e, from);
  const glm::vec2 t = u + a * u * (1.0f - u), stretch = 1.0f + a * (1.0f - 2.0f * u);
  const glm::vec3 position = e.origin + t.x * e.edge_u + t.y * e.edge_v;
  return {position, e.normal, pdf_by_area(e.area * stretch.x * stretch.y, from, position, e.normal)};
}

float pdf_far_rectangle(const Emitter& e, glm::vec3 from, glm::vec3 position, glm::vec3 normal) {
  const glm::vec2 a = warp_of_far_rectangle(e, from);
  const glm::vec3 d = position - e.origin;
  const glm::vec2 t(glm::dot(d, e.edge_u) / glm::dot(e.edge_u, e.edge_u),
                    glm::dot(d, e.edge_v) / glm::dot(e.edge_v, e.edge_v));
  // The stretch 1 + a (1 - 2 u) where t = u + a u (1 - u).
  const glm::vec2 stretch_squared = (1.0f + a) * (1.0f + a) - 4.0f * a * glm::clamp(t, 0.0f, 1.0f);
  return pdf_by_area(e.area * std::sqrt(stretch_squared.x * stretch_squared.y), from, position, normal);
}

}  // namespace

Emitter triangle_emitter(const Corners& corners) {
  Emitter e{.form = Form::Triangle, .origin = corners[0]};
  e.edge_u = corners[1] - corners[0];
  e.edge_v = corners[2] - corners[0];
  const glm::vec3 normal = glm::cross(e.edge_u, e.edge_v);
  e.area = 0.5f * glm::length(normal);
  if (e.area > 0) e.normal = glm::normalize(normal);
  e.center = (corners[0] + corners[1] + corners[2]) / 3.0f;
  for (const glm::vec3 corner : corners) e.extent = std::max(e.extent, glm::distance(corner, e.center));
  return e;
}

std::optional<Emitter> rectangle_emitter(const Corners& first, const Corners& second) {
  constexpr float kTolerance = 1e-5f;  // of the longer edge
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // The diagonal runs one way round in the first triangle and the other way round in the second.
      const glm::vec3 corner = first[i], next = first[(i + 1) % 3], last = first[(i + 2) % 3];
      if (second[(j + 1) % 3] != last || second[(j + 2) % 3] != next) continue;
      Emitter e{.form = Form::Rectangle, .origin = corner};
      e.edge_u = next - corner;
      e.edge_v = last - corner;
      const float longer = std::max(glm::length(e.edge_u), glm::length(e.edge_v));
      if (glm::distance(second[j], next + e.edge_v) > kTolerance * longer) return std::nullopt;
      if (std::abs(glm::dot(e.edge_u, e.edge_v)) > kTolerance * longer * longer) return std::nullopt;
      const glm::vec3 normal = glm::cross(e.edge_u, e.edge_v);
      e.area = glm::length(normal);
      if (!(e.area > 0)) return std::nullopt;
      e.normal = normal / e.area;
      e.center = 0.5f * (next + last);
      e.extent = 0.5f * glm::distance(next, last);
      e.rectangle = Rectangle(e.origin, e.edge_u, e.edge_v);
      return e;
    }
  return std::nullopt;
}

Emitter disk_emitter(glm::vec3 center, glm::vec3 normal, float radius) {
  return {.form = Form::Disk,
          .origin = center,
          .normal = glm::normalize(normal),
          .radius = radius,
          .center = center,
          .extent = radius,
          .area = kPi * radius * radius};
}

Emitter sphere_emitter(glm::vec3 center, float radius) {
  return {.form = Form::Sphere,
          .origin = center,
          .radius = radius,
          .center = center,
          .extent = radius,
          .area = 4.0f * kPi * radius * radius};
}

SurfaceSample sample_area(const Emitter& e, glm::vec2 u) {
  SurfaceSample s{.position = e.origin, .normal = e.normal};
  switch (e.form) {
    case Form::Triangle: {
      const glm::vec2 b = uniform_triangle(u);
      s.position += b.x * e.edge_u + b.y * e.edge_v;
      break;
    }
    case Form::Rectangle:
      s.position += u.x * e.edge_u + u.y * e.edge_v;
      break;
    case Form::Disk: {
      const glm::vec2 d = e.radius * uniform_disk(u);
      const Frame frame = Frame::around(e.normal);
      s.position += d.x * frame.s + d.y * frame.t;
      break;
    }
    case Form::Sphere:
      s.normal = uniform_sphere(u);
      s.position += e.radius * s.normal;
      break;
  }
  return s;
}

SurfaceSample sample_surface(const Emitter& e, glm::vec3 from, glm::vec2 u) {
  switch (e.form) {
    case Form::Triangle:
      if (is_near(e, from, kFarTriangle)) return sample_by_solid_angle(spherical_triangle(e, from), e, u);
      break;
    case Form::Rectangle:
      if (is_near(e, from, kFarRectangle)) return sample_by_solid_angle(SphericalRectangle(e.rectangle, from), e, u);
      return sample_far_rectangle(e, from, u);
    case Form::Sphere: {
      const glm::vec3 d = e.center - from;
      if (const float distance2 = glm::dot(d, d); is_outside_sphere(e, distance2))
        return sample_cone(e, from, distance2, u);
      break;
    }
    case Form::Disk:
      break;
  }
  return sample_by_area(e, from, u);
}

float pdf_solid_angle(const Emitter& e, glm::vec3 from, glm::vec3 position, glm::vec3 normal) {
  switch (e.form) {
    case Form::Triangle:
      if (is_near(e, from, kFarTriangle)) return pdf_by_solid_angle(spherical_triangle(e, from));
      break;
    case Form::Rectangle:
      if (is_near(e, from, kFarRectangle)) return pdf_by_solid_angle(SphericalRectangle(e.rectangle, from));
      return pdf_far_rectangle(e, from, position, normal);
    case Form::Sphere: {
      const glm::vec3 d = e.center - from;
      if (const float distance2 = glm::dot(d, d); is_outside_sphere(e, distance2))
        return 1.0f / (2.0f * kPi * one_minus_cos_cone(e, distance2));
      break;
    }
    case Form::Disk:
      break;
  }
  return pdf_by_area(e.area, from, position, normal);
}

}  // namespace heckbert::transport
