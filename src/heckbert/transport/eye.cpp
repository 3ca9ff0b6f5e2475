#include <heckbert/transport/eye.h>

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
  const glm::vec2 lens = lens_radius_ * uniform_disk(sampler.next2());
  const glm::vec3 origin = position_ + lens.x * right_ + lens.y * up_;
  return {origin, glm::normalize(position_ + focus_distance_ * through - origin)};
}

}  // namespace heckbert::transport
