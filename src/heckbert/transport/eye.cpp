#include <heckbert/transport/eye.h>

#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/transport/frame.h>

namespace heckbert::transport {

Eye::Eye(const Camera& camera, int width, int height)
    : position_(camera.position), lens_radius_(camera.lens_radius), focus_distance_(camera.focus_distance) {
  const glm::vec3 view = camera.look_at - camera.position;
  const glm::vec3 side = glm::cross(view, camera.up);
  if (!(glm::dot(view, view) > 0) || !(glm::dot(side, side) > 0))
    throw std::invalid_argument("the camera looks nowhere: position equals look_at, or up is along the view");
  forward_ = glm::normalize(view);
  right_ = glm::normalize(side);
  up_ = glm::cross(right_, forward_);
  const float half_height = std::tan(0.5f * glm::radians(camera.vertical_fov_degrees));
  const float pixel = 2.0f * half_height / static_cast<float>(height);
  pixel_ = {pixel, -pixel};
  corner_ = {-0.5f * pixel * static_cast<float>(width), half_height};
}

Ray Eye::ray(int x, int y, Sampler& sampler) const {
  const glm::vec2 film = corner_ + pixel_ * (glm::vec2(x, y) + sampler.next2());
  const glm::vec3 through = film.x * right_ + film.y * up_ + forward_;
  if (lens_radius_ <= 0) return {position_, glm::normalize(through)};
  const glm::vec2 lens = lens_radius_ * uniform_disk(sampler.next2());
  const glm::vec3 origin = position_ + lens.x * right_ + lens.y * up_;
  return {origin, glm::normalize(position_ + focus_distance_ * through - origin)};
}

}  // namespace heckbert::transport
