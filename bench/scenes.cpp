#include "scenes.h"

#include <cmath>

#include <heckbert/import/import.h>
#include <heckbert/transport/frame.h>

namespace heckbert::bench {

using transport::kPi;

transport::Scene boxes() {
  transport::Scene scene = import::load_scene_or_builtin("cornell").scene;
  for (transport::Shape& shape : scene.shapes) {
    auto& mesh = std::get<transport::Mesh>(shape.geometry);
    if (shape.name == "ceiling") {
      mesh.positions.resize(4);
      mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    }
    if (shape.name == "lamp")
      for (glm::vec3& p : mesh.positions) p.y -= 0.1f;
  }
  return scene;
}

transport::Scene ball() {
  transport::Scene scene = boxes();
  std::erase_if(scene.shapes, [](const transport::Shape& shape) { return shape.name.ends_with("block"); });
  constexpr unsigned kRows = 512, kColumns = 512;
  transport::Mesh mesh;
  for (unsigned row = 0; row <= kRows; ++row)
    for (unsigned column = 0; column < kColumns; ++column) {
      const float theta = kPi * static_cast<float>(row) / kRows;
      const float phi = 2 * kPi * static_cast<float>(column) / kColumns;
      const float dents = std::sin(19 * theta) * std::sin(23 * phi) + 0.5f * std::sin(61 * theta) * std::sin(53 * phi);
      const float radius = 180 * (1 + 0.04f * dents * std::sin(theta));
      mesh.positions.push_back(glm::vec3(278, 230, 280) + radius * glm::vec3(std::sin(theta) * std::cos(phi),
                                                                             std::cos(theta),
                                                                             std::sin(theta) * std::sin(phi)));
    }
  for (unsigned row = 0; row < kRows; ++row)
    for (unsigned column = 0; column < kColumns; ++column) {
      const unsigned a = row * kColumns + column, b = row * kColumns + (column + 1) % kColumns;
      mesh.triangles.emplace_back(a, b, b + kColumns);
      mesh.triangles.emplace_back(a, b + kColumns, a + kColumns);
    }
  scene.shapes.push_back({.name = "ball", .geometry = std::move(mesh), .material = scene.shapes.front().material});
  return scene;
}

}  // namespace heckbert::bench
