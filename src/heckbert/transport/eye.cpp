#include <heckbert/transport/eye.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/transport/frame.h>

namespace heckbert::transport {

Eye::Eye(const Camera& camera, int width, int height, const PixelFilter& filter)
    : projection_(camera.projection),
      filter_(filter),
      position_(camera.position),
      lens_radius_(camera.projection == Projection::Perspective ? camera.lens_radius : 0.0f),
      focus_distance_(camera.focus_distance) {
  const glm::vec3 view = camera.look_at - camera.position;
  const glm::vec3 side = glm::cross(view, camera.up);
  if (!(glm::dot(view, view) > 0) || !(glm::dot(side, side) > 0))
    throw std::invalid_argument("the camera looks nowhere: position equals look_at, or up is along the view");
  forward_ = glm::normalize(view);
  right_ = glm::normalize(side);
  up_ = glm::cross(right_, forward_);
  if (camera.mirrored) right_ = -right_;
  const auto columns = static_cast<float>(width), rows = static_cast<float>(height);
  if (projection_ == Projection::Panoramic) {
    pixel_ = {2 * kPi / columns, -kPi / rows};
    corner_ = {-kPi, 0.5f * kPi};
    return;
  }
  const float half_height = projection_ == Projection::Orthographic
                                ? 0.5f * camera.height
                                : std::tan(0.5f * glm::radians(camera.vertical_fov_degrees));
  const float pixel = 2.0f * half_height / rows;
  pixel_ = {pixel, -pixel};
  corner_ = {-0.5f * pixel * columns, half_height};
}

Ray Eye::ray(int x, int y, Sampler& sampler) const {
  const glm::vec2 film = corner_ + pixel_ * (glm::vec2(x, y) + 0.5f + filter_.sample(sampler.next2()));
  switch (projection_) {
    case Projection::Perspective:
      return through_lens(film, sampler);
    case Projection::Orthographic:
      return {position_ + film.x * right_ + film.y * up_, forward_};
    case Projection::Panoramic:
      break;
  }
  const float longitude = film.x, latitude = film.y;
  const glm::vec3 level = std::sin(longitude) * right_ + std::cos(longitude) * forward_;
  return {position_, std::cos(latitude) * level + std::sin(latitude) * up_};
}

Ray Eye::through_lens(glm::vec2 film, Sampler& sampler) const {
  const glm::vec3 through = film.x * right_ + film.y * up_ + forward_;
  if (lens_radius_ <= 0) return {position_, glm::normalize(through)};
  const glm::vec3 origin = lens_point(sampler.next2());
  return {origin, glm::normalize(position_ + focus_distance_ * through - origin)};
}

glm::vec3 Eye::lens_point(glm::vec2 u) const {
  const glm::vec2 lens = lens_radius_ * uniform_disk(u);
  return position_ + lens.x * right_ + lens.y * up_;
}

float Eye::lens_area() const {
  return kPi * lens_radius_ * lens_radius_;
}

float Eye::cosine(glm::vec3 direction) const {
  return std::abs(glm::dot(direction, forward_));
}

float Eye::pixels_along(glm::vec3 direction) const {
  const float per_film = 1.0f / std::abs(pixel_.x * pixel_.y);
  switch (projection_) {
    case Projection::Perspective: {
      const float cosine = glm::dot(direction, forward_);
      return per_film / (cosine * cosine * cosine);
    }
    case Projection::Orthographic:
      return per_film;
    case Projection::Panoramic:
      break;
  }
  const float sine = glm::dot(direction, up_);
  return per_film / std::sqrt(std::max(1e-12f, 1.0f - sine * sine));
}

Sight Eye::sight_of(glm::vec3 point, Sampler& sampler) const {
  const glm::vec3 to_point = point - position_;
  if (projection_ == Projection::Orthographic) {
    const float depth = glm::dot(to_point, forward_);
    if (!(depth > 0)) return {};
    const glm::vec2 film(glm::dot(to_point, right_), glm::dot(to_point, up_));
    return {point - depth * forward_, forward_, place_of(film), pixels_along(forward_)};
  }
  const glm::vec3 lens = seen_from(sampler);
  return point == lens ? Sight{} : sight(lens, glm::normalize(point - lens));
}

Sight Eye::sight_along(glm::vec3 direction, Sampler& sampler) const {
  if (projection_ == Projection::Orthographic) return {};
  return sight(seen_from(sampler), direction);
}

Sight Eye::sight_met_by(const Ray& ray, float farthest) const {
  if (!has_lens()) return {};
  const float approach = glm::dot(ray.direction, forward_);
  if (!(approach < 0)) return {};
  const float distance = glm::dot(position_ - ray.origin, forward_) / approach;
  if (!(distance > 0 && distance < farthest)) return {};
  const glm::vec3 lens = ray.origin + distance * ray.direction;
  if (!(glm::distance(lens, position_) < lens_radius_)) return {};
  return sight(lens, -ray.direction);
}

Sight Eye::sight(glm::vec3 lens, glm::vec3 direction) const {
  const float depth = glm::dot(direction, forward_), x = glm::dot(direction, right_), y = glm::dot(direction, up_);
  if (projection_ == Projection::Panoramic) {
    const glm::vec2 film(std::atan2(x, depth), std::asin(std::clamp(y, -1.0f, 1.0f)));
    return {lens, direction, place_of(film), pixels_along(direction)};
  }
  if (!(depth > 0)) return {};
  glm::vec2 film = glm::vec2(x, y) / depth;
  // Rays through one point of the picture meet in the plane that is in focus.
  if (has_lens()) {
    const glm::vec3 off_axis = lens - position_;
    film += glm::vec2(glm::dot(off_axis, right_), glm::dot(off_axis, up_)) / focus_distance_;
  }
  return {lens, direction, place_of(film), pixels_along(direction)};
}

}  // namespace heckbert::transport
