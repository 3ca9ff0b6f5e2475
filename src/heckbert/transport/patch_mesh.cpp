#include <heckbert/transport/patch_mesh.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <heckbert/taxonomy/error.h>
#include <heckbert/transport/frame.h>

namespace heckbert::transport {

namespace {

class Cutter {
 public:
  explicit Cutter(PatchMesh mesh) : mesh_(std::move(mesh)) {
    for (std::uint32_t i = 0; i < mesh_.positions.size(); ++i) known_.emplace(key(mesh_.positions[i]), i);
  }

  std::uint32_t part(const PatchPart& part) {
    mesh_.parts.push_back(part);
    return static_cast<std::uint32_t>(mesh_.parts.size() - 1);
  }
  std::uint32_t corner(glm::vec3 position) {
    const auto [at, is_new] = known_.try_emplace(key(position), static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) mesh_.positions.push_back(position);
    return at->second;
  }

  /// Patches of no area are left out: no light meets them.
  void add(const std::array<std::uint32_t, 3>& corners, std::uint32_t part) {
    Patch patch{.corners = corners, .part = part};
    const glm::vec3 a = mesh_.corner(patch, 0);
    const glm::vec3 cross = glm::cross(mesh_.corner(patch, 1) - a, mesh_.corner(patch, 2) - a);
    const float length = glm::length(cross);
    if (!(length > 0)) return;
    if (mesh_.patches.size() == kMostPatches)
      throw LimitError(fmt::format("radiosity would need more than {} patches; use larger ones", kMostPatches));
    patch.normal = cross / length;
    patch.area = 0.5f * length;
    mesh_.patches.push_back(patch);
  }

  void add_quarters(const Patch& patch) {
    const auto [a, b, c] = patch.corners;
    const std::uint32_t ab = between(a, b, patch.part), bc = between(b, c, patch.part), ca = between(c, a, patch.part);
    add({a, ab, ca}, patch.part);
    add({ab, b, bc}, patch.part);
    add({ca, bc, c}, patch.part);
    add({ab, bc, ca}, patch.part);
  }

  PatchMesh mesh() && { return std::move(mesh_); }

 private:
  using Key = std::array<std::uint32_t, 3>;
  static Key key(glm::vec3 p) {
    const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f + 0.0f); };  // no zero of its own below zero
    return {bits(p.x), bits(p.y), bits(p.z)};
  }

  /// A new corner in the middle of an edge: on the ball, or on the rim of the disk when both ends are.
  std::uint32_t between(std::uint32_t a, std::uint32_t b, std::uint32_t part_number) {
    const PatchPart& part = mesh_.parts[part_number];
    const glm::vec3 from = mesh_.positions[a], to = mesh_.positions[b];
    glm::vec3 middle = 0.5f * (from + to);
    const auto is_on_rim = [&](glm::vec3 p) { return glm::distance(p, part.center) > 0.999f * part.radius; };
    const bool is_curved = part.form == PatchPart::Form::Sphere ||
                           (part.form == PatchPart::Form::Disk && is_on_rim(from) && is_on_rim(to));
    if (is_curved) middle = part.center + part.radius * glm::normalize(middle - part.center);
    return corner(middle);
  }

  PatchMesh mesh_;
  std::map<Key, std::uint32_t> known_;
};

void add_mesh(Cutter& cutter, const Mesh& mesh, const Scene& scene, const Shape& shape, std::uint32_t number,
              const glm::mat4& to_world) {
  const bool mirrors = glm::determinant(glm::mat3(to_world)) < 0;
  std::map<std::uint32_t, std::uint32_t> part_of_material;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t material = mesh.face_materials.empty() ? shape.material : mesh.face_materials[i];
    if (scene.materials[material].is_index_matched) continue;
    const auto [at, is_new] = part_of_material.try_emplace(material, 0);
    if (is_new) at->second = cutter.part({.material = material, .shape = number});
    std::array<std::uint32_t, 3> corners{};
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] =
          cutter.corner(glm::vec3(to_world * glm::vec4(mesh.positions[mesh.triangles[i][k]], 1.0f)));
    if (mirrors) std::swap(corners[1], corners[2]);
    cutter.add(corners, at->second);
  }
}

/// An octahedron: its faces are the octants.
void add_sphere(Cutter& cutter, const PatchPart& sphere) {
  const std::uint32_t part = cutter.part(sphere);
  const auto at = [&](float x, float y, float z) {
    return cutter.corner(sphere.center + sphere.radius * glm::vec3(x, y, z));
  };
  for (const float x : {1.0f, -1.0f})
    for (const float y : {1.0f, -1.0f})
      for (const float z : {1.0f, -1.0f}) {
        std::array<std::uint32_t, 3> corners{at(x, 0, 0), at(0, y, 0), at(0, 0, z)};
        if (x * y * z < 0) std::swap(corners[1], corners[2]);
        cutter.add(corners, part);
      }
}

void add_disk(Cutter& cutter, const PatchPart& disk, glm::vec3 normal) {
  constexpr int kSectors = 8;
  const std::uint32_t part = cutter.part(disk);
  const Frame frame = Frame::around(glm::normalize(normal));
  const auto rim = [&](int i) {
    const float turn = 2 * kPi * static_cast<float>(i % kSectors) / kSectors;
    return cutter.corner(disk.center + disk.radius * (std::cos(turn) * frame.s + std::sin(turn) * frame.t));
  };
  for (int i = 0; i < kSectors; ++i) cutter.add({cutter.corner(disk.center), rim(i), rim(i + 1)}, part);
}

void add_shape(Cutter& cutter, const Scene& scene, const Shape& shape, std::uint32_t number,
               const glm::mat4& to_world) {
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
    return add_mesh(cutter, *mesh, scene, shape, number, to_world);
  if (scene.materials[shape.material].is_index_matched) return;
  const glm::mat3 linear(to_world);
  const float scale = glm::length(linear[0]);
  PatchPart part{.material = shape.material, .shape = number};
  const auto place = [&](PatchPart::Form form, glm::vec3 center, float radius) {
    part.form = form;
    part.center = glm::vec3(to_world * glm::vec4(center, 1.0f));
    part.radius = scale * radius;
  };
  if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
    place(PatchPart::Form::Sphere, sphere->center, sphere->radius);
    add_sphere(cutter, part);
  } else {
    const auto& disk = std::get<Disk>(shape.geometry);
    place(PatchPart::Form::Disk, disk.center, disk.radius);
    add_disk(cutter, part, glm::transpose(glm::inverse(linear)) * disk.normal);
  }
}

float longest_edge_of(const PatchMesh& mesh, const Patch& patch) {
  float longest = 0;
  for (int i = 0; i < 3; ++i)
    longest = std::max(longest, glm::distance(mesh.corner(patch, i), mesh.corner(patch, (i + 1) % 3)));
  return longest;
}

}  // namespace

std::array<float, 3> PatchMesh::barycentric(const Patch& patch, glm::vec3 position) const {
  const glm::vec3 a = corner(patch, 0), b = corner(patch, 1), c = corner(patch, 2);
  const float scale = 0.5f / patch.area;
  const float of_a = scale * glm::dot(glm::cross(c - b, position - b), patch.normal);
  const float of_b = scale * glm::dot(glm::cross(a - c, position - c), patch.normal);
  return {of_a, of_b, 1 - of_a - of_b};
}

PatchMesh cut_into_patches(const Scene& scene, float longest_edge) {
  Cutter cutter{PatchMesh{}};
  // Numbered as the tracer does it: the scene's shapes, then those of its groups.
  std::uint32_t number = 0;
  for (const Shape& shape : scene.shapes) add_shape(cutter, scene, shape, number++, glm::mat4(1));
  std::vector<std::uint32_t> first_of_group;
  for (const Group& group : scene.groups) {
    first_of_group.push_back(number);
    number += static_cast<std::uint32_t>(group.shapes.size());
  }
  for (const Instance& instance : scene.instances) {
    std::uint32_t of_group = first_of_group[instance.group];
    for (const Shape& shape : scene.groups[instance.group].shapes)
      add_shape(cutter, scene, shape, of_group++, instance.to_world);
  }
  PatchMesh mesh = std::move(cutter).mesh();
  for (;;) {
    std::vector<bool> is_too_long;
    for (const Patch& patch : mesh.patches) is_too_long.push_back(longest_edge_of(mesh, patch) > longest_edge);
    if (std::ranges::find(is_too_long, true) == is_too_long.end()) return mesh;
    mesh = split(mesh, is_too_long);
  }
}

PatchMesh split(const PatchMesh& mesh, const std::vector<bool>& marked) {
  Cutter cutter{PatchMesh{mesh.positions, mesh.parts, {}}};
  for (std::size_t i = 0; i < mesh.patches.size(); ++i)
    if (marked[i])
      cutter.add_quarters(mesh.patches[i]);
    else
      cutter.add(mesh.patches[i].corners, mesh.patches[i].part);
  return std::move(cutter).mesh();
}

Scene scene_of(const PatchMesh& mesh) {
  Mesh triangles{.positions = mesh.positions};
  for (const Patch& patch : mesh.patches)
    triangles.triangles.emplace_back(patch.corners[0], patch.corners[1], patch.corners[2]);
  Scene scene;
  scene.materials.emplace_back();
  scene.shapes.push_back({.geometry = std::move(triangles)});
  return scene;
}

}  // namespace heckbert::transport
