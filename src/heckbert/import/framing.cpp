#include <heckbert/import/framing.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/import/mesh.h>

namespace heckbert::import {
namespace {

using namespace transport;

/// Area of the triangles that lie within a thin slab about the plane z = `z`: how much of that end is walled in.
float wall_area(const std::vector<Shape>& shapes, float z, float thickness) {
  float area = 0;
  for (const Shape& shape : shapes) {
    if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
      for (const glm::uvec3 t : mesh->triangles) {
        const glm::vec3 a = mesh->positions[t.x], b = mesh->positions[t.y], c = mesh->positions[t.z];
        if (std::max({std::abs(a.z - z), std::abs(b.z - z), std::abs(c.z - z)}) <= thickness) {
          area += 0.5f * glm::length(glm::cross(b - a, c - a));
        }
      }
    }
  }
  return area;
}

}  // namespace

Camera frame(const std::vector<Shape>& shapes) {
  constexpr float kMargin = 1.02f;
  constexpr float kSlab = 0.02f;
  const Bounds box = bounds_of(shapes);
  const glm::vec3 size = box.high - box.low;
  const glm::vec3 middle = 0.5f * (box.low + box.high);
  const float thickness = kSlab * size.z;
  const bool from_high = wall_area(shapes, box.high.z, thickness) <= wall_area(shapes, box.low.z, thickness);

  Camera camera;
  // A box without width and height, seen end on, still needs a distance.
  const float half = 0.5f * std::max({size.x, size.y, 1e-3f * size.z});
  const float back = kMargin * half / std::tan(0.5f * glm::radians(camera.vertical_fov_degrees));
  camera.look_at = middle;
  camera.position = {middle.x, middle.y, from_high ? box.high.z + back : box.low.z - back};
  camera.focus_distance = std::abs(camera.position.z - middle.z);
  return camera;
}

}  // namespace heckbert::import
