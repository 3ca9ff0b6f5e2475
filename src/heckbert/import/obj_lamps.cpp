#include <heckbert/import/obj_lamps.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include <heckbert/import/mesh.h>
#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

using namespace transport;

/// The triangles of one shape that are made of one material.
struct Panel {
  Mesh* mesh;
  std::vector<std::size_t> triangles;

  glm::vec3 normal(std::size_t triangle) const {
    const glm::uvec3 t = mesh->triangles[triangle];
    const glm::vec3 a = mesh->positions[t.x];
    return glm::normalize(glm::cross(mesh->positions[t.y] - a, mesh->positions[t.z] - a));
  }

  /// Whether all lie in one plane, and `middle` well to one side of it.
  bool is_flat_beside(glm::vec3 middle) const {
    constexpr float kTolerance = 1e-3f;
    const glm::vec3 n = normal(triangles.front());
    const glm::vec3 origin = mesh->positions[mesh->triangles[triangles.front()].x];
    const float distance = std::abs(glm::dot(n, middle - origin));
    return std::all_of(triangles.begin(), triangles.end(), [&](std::size_t i) {
      const glm::vec3 corner = mesh->positions[mesh->triangles[i].x];
      return std::abs(glm::dot(n, normal(i))) > 1 - kTolerance &&
             std::abs(glm::dot(n, corner - origin)) < kTolerance * distance;
    });
  }

  void turn_towards(glm::vec3 middle) {
    for (const std::size_t i : triangles) {
      glm::uvec3& t = mesh->triangles[i];
      if (glm::dot(normal(i), middle - mesh->positions[t.x]) < 0) {
        std::swap(t.y, t.z);
      }
    }
  }
};

std::vector<Panel> panels_of(Scene& scene, std::uint32_t material) {
  std::vector<Panel> out;
  for (Shape& shape : scene.shapes) {
    Panel panel{&std::get<Mesh>(shape.geometry), {}};
    for (std::size_t i = 0; i < panel.mesh->triangles.size(); ++i) {
      if (panel.mesh->face_materials[i] == material) {
        panel.triangles.push_back(i);
      }
    }
    if (!panel.triangles.empty()) {
      out.push_back(std::move(panel));
    }
  }
  return out;
}

}  // namespace

void orient_lamps(Scene& scene, Account& account) {
  const Bounds box = bounds_of(scene.shapes);
  const glm::vec3 middle = 0.5f * (box.low + box.high);
  for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
    Material& material = scene.materials[i];
    std::vector<Panel> panels = is_black(material.emission) ? std::vector<Panel>{} : panels_of(scene, i);
    if (panels.empty()) {
      continue;
    }
    const bool flat =
        std::all_of(panels.begin(), panels.end(), [&](const Panel& panel) { return panel.is_flat_beside(middle); });
    material.emission_sides = flat ? Sides::Front : Sides::Both;
    if (flat) {
      std::for_each(panels.begin(), panels.end(), [&](Panel& panel) { panel.turn_towards(middle); });
    }
    account.guessed.push_back(
        "material \"" + material.name + "\": Ke " + to_text(material.emission) +
        (flat ? " of a flat lamp emits on one side, towards the middle of the scene" : " emits on both sides"));
  }
}

}  // namespace heckbert::import
