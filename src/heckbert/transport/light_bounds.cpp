#include <heckbert/transport/light_bounds.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/transport/delta_lights.h>

namespace heckbert::transport {

namespace {

/// Bounds are computed in floats; this much of a cosine is forgiven, so that rounding never calls a light dark that is
/// not, and no light that is seen at a grazing angle becomes arbitrarily unlikely.
constexpr float kSlack = 1e-2f;

glm::vec3 center_of(const LightBounds& b) {
  return 0.5f * (b.low + b.high);
}

/// Of 0 to pi.
struct Angle {
  float cosine = 1, sine = 0;
};

Angle angle_with(float cosine) {
  cosine = std::clamp(cosine, -1.0f, 1.0f);
  return {cosine, std::sqrt(1.0f - cosine * cosine)};
}

/// The difference, or zero when it is negative; without inverse functions, which would cost more than all the rest.
Angle minus(Angle a, Angle b) {
  if (a.cosine >= b.cosine) return {};
  return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}

double angle_of(double cosine) {
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

Cone join(const Cone& a, const Cone& b) {
  const Cone& wide = a.cos_angle <= b.cos_angle ? a : b;
  const Cone& narrow = a.cos_angle <= b.cos_angle ? b : a;
  const double wide_angle = angle_of(wide.cos_angle);
  const double narrow_angle = angle_of(narrow.cos_angle);
  const double between = angle_of(glm::dot(wide.axis, narrow.axis));
  if (between + narrow_angle <= wide_angle) return wide;
  const double angle = 0.5 * (wide_angle + between + narrow_angle);
  const glm::vec3 pivot = glm::cross(wide.axis, narrow.axis);
  const float sine = glm::length(pivot);
  if (angle >= std::numbers::pi || !(sine > 0)) return {wide.axis, -1};
  // The new axis lies between the two, turned from the wide cone's towards the other.
  const double turn = angle - wide_angle;
  const glm::vec3 across = glm::cross(pivot / sine, wide.axis);
  const glm::vec3 axis = static_cast<float>(std::cos(turn)) * wide.axis + static_cast<float>(std::sin(turn)) * across;
  return {glm::normalize(axis), static_cast<float>(std::cos(angle))};
}

LightBounds join(const LightBounds& a, const LightBounds& b) {
  return {.low = glm::min(a.low, b.low),
          .high = glm::max(a.high, b.high),
          .normals = join(a.normals, b.normals),
          .cos_emission = std::min(a.cos_emission, b.cos_emission),
          .both_sides = a.both_sides || b.both_sides,
          .power = a.power + b.power};
}

double importance(const LightBounds& b, glm::vec3 from) {
  const glm::vec3 half = 0.5f * (b.high - b.low), d = from - center_of(b);
  const float radius2 = glm::dot(half, half), distance2 = glm::dot(d, d);
  // Nearer than its radius, a group can be anywhere around.
  if (distance2 <= radius2 || !(distance2 > 0)) return radius2 > 0 ? b.power / static_cast<double>(radius2) : b.power;
  float cosine = glm::dot(d, b.normals.axis) / std::sqrt(distance2);
  if (b.both_sides) cosine = std::abs(cosine);
  // The smallest angle that any normal of the group may make with the direction from any of its points: the angle at
  // the centre less the spread of the normals and the angle that the bounds subtend.
  const float subtended = std::sqrt(radius2 / distance2);
  const Angle at_center = angle_with(cosine), spread = angle_with(b.normals.cos_angle);
  const float best =
      minus(minus(at_center, spread), {.cosine = std::sqrt(1.0f - radius2 / distance2), .sine = subtended}).cosine;
  if (best < b.cos_emission - kSlack) return 0;
  return b.power * static_cast<double>(std::max(best, kSlack)) / static_cast<double>(distance2);
}

LightBounds bounds_of(const Emitter& e, bool both_sides, double power) {
  LightBounds b{.normals = {e.normal, 1}, .both_sides = both_sides, .power = power};
  switch (e.form) {
    case Emitter::Form::Triangle:
    case Emitter::Form::Rectangle: {
      const glm::vec3 next = e.origin + e.edge_u, last = e.origin + e.edge_v;
      b.low = glm::min(e.origin, glm::min(next, last));
      b.high = glm::max(e.origin, glm::max(next, last));
      if (e.form == Emitter::Form::Rectangle) {
        b.low = glm::min(b.low, next + e.edge_v);
        b.high = glm::max(b.high, next + e.edge_v);
      }
      break;
    }
    case Emitter::Form::Disk: {
      const glm::vec3 reach = e.radius * glm::sqrt(glm::max(glm::vec3(0), 1.0f - e.normal * e.normal));
      b.low = e.center - reach;
      b.high = e.center + reach;
      break;
    }
    case Emitter::Form::Sphere:
      b.normals = {};
      b.low = e.center - e.radius;
      b.high = e.center + e.radius;
      break;
  }
  return b;
}

LightBounds bounds_of(const PointLight& light) {
  return {.low = light.position, .high = light.position, .normals = {}, .power = power(light)};
}

LightBounds bounds_of(const SpotLight& light) {
  return {.low = light.position,
          .high = light.position,
          .normals = {glm::normalize(light.direction), 1},
          .cos_emission = std::cos(glm::radians(light.cutoff_degrees)),
          .power = power(light)};
}

double split_cost(const LightBounds& b) {
  const double spread = angle_of(b.normals.cos_angle);
  const double reach = std::min(spread + angle_of(b.cos_emission), std::numbers::pi);
  const double sine = std::sin(spread), cosine = std::cos(spread);
  const double directions =
      2 * std::numbers::pi * (1 - cosine) +
      std::numbers::pi / 2 * (2 * reach * sine - std::cos(spread - 2 * reach) - 2 * spread * sine + cosine);
  const glm::dvec3 size(b.high - b.low);
  const double area = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  return b.power * directions * area;
}

}  // namespace heckbert::transport
