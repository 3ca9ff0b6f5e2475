#include <heckbert/import/mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace heckbert::import {

using transport::Mesh;

bool has_area(const Mesh& mesh, glm::uvec3 triangle) {
  const glm::vec3 a = mesh.positions[triangle.x];
  const glm::vec3 u = mesh.positions[triangle.y] - a;
  const glm::vec3 v = mesh.positions[triangle.z] - a;
  return glm::length(glm::cross(u, v)) > 0;
}

Bounds bounds_of(const std::vector<transport::Shape>& shapes) {
  Bounds box;
  const auto add = [&](glm::vec3 p) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  };
  for (const transport::Shape& shape : shapes) {
    if (const auto* sphere = std::get_if<transport::Sphere>(&shape.geometry)) {
      add(sphere->center - sphere->radius);
      add(sphere->center + sphere->radius);
    } else if (const auto* disk = std::get_if<transport::Disk>(&shape.geometry)) {
      const glm::vec3 n = glm::normalize(disk->normal);
      const glm::vec3 half = disk->radius * glm::sqrt(glm::max(1.0f - n * n, glm::vec3(0)));
      add(disk->center - half);
      add(disk->center + half);
    } else {
      for (const glm::vec3 p : std::get<Mesh>(shape.geometry).positions) {
        add(p);
      }
    }
  }
  return box;
}

void transform(Mesh& mesh, const glm::mat4& to_world) {
  for (glm::vec3& p : mesh.positions) {
    p = glm::vec3(to_world * glm::vec4(p, 1));
  }
  const glm::mat3 linear(to_world);
  const glm::mat3 of_normals = glm::transpose(glm::inverse(linear));
  for (glm::vec3& n : mesh.normals) {
    n = of_normals * n;
    if (const float length = glm::length(n); length > 0) {
      n /= length;
    }
  }
  if (glm::determinant(linear) < 0) {
    for (glm::uvec3& t : mesh.triangles) {
      std::swap(t.y, t.z);
    }
  }
}

void compute_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  for (const glm::uvec3 t : mesh.triangles) {
    const glm::vec3 corner[] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const glm::vec3 normal = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 a = glm::normalize(corner[(i + 1) % 3] - corner[i]);
      const glm::vec3 b = glm::normalize(corner[(i + 2) % 3] - corner[i]);
      mesh.normals[t[i]] += std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)) * normal;
    }
  }
  for (glm::vec3& n : mesh.normals) {
    const float length = glm::length(n);
    n = length > 0 ? n / length : glm::vec3(0, 0, 1);
  }
}

bool has_placeholder_normals(const Mesh& mesh) {
  constexpr float kTilted = 0.866f;  // cosine of 30 degrees: more than rounding, less than any wave or corner
  if (mesh.normals.empty()) {
    return false;
  }
  const glm::vec3 n = mesh.normals.front();
  return std::all_of(mesh.normals.begin(), mesh.normals.end(), [&](glm::vec3 other) { return other == n; }) &&
         std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](glm::uvec3 t) {
           const glm::vec3 face =
               glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
           return std::abs(glm::dot(face, n)) < kTilted * glm::length(face) * glm::length(n);
         });
}

void append(Mesh& mesh, const Mesh& more) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  const bool keep_normals = !more.normals.empty() && (base == 0 || !mesh.normals.empty());
  const bool keep_texcoords = !more.texcoords.empty() && (base == 0 || !mesh.texcoords.empty());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const glm::uvec3 t : more.triangles) {
    mesh.triangles.push_back(t + base);
  }
  if (keep_normals) {
    mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  } else {
    mesh.normals.clear();
  }
  if (keep_texcoords) {
    mesh.texcoords.insert(mesh.texcoords.end(), more.texcoords.begin(), more.texcoords.end());
  } else {
    mesh.texcoords.clear();
  }
}

}  // namespace heckbert::import
