#pragma once
// The surfaces of a scene cut into patches, the flat triangles over which radiosity is constant or linear. Corners are
// shared, so that values can be interpolated. A patch has two sides, each with light of its own; side 2 i is the front
// of patch i, side 2 i + 1 its back.
//
// Balls and disks are cut as polyhedra whose corners lie on them; new corners are put there when patches are split, so
// that the surface is approached as patches become smaller. A surface with holes is cut as if it had none.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

struct Patch {
  std::array<std::uint32_t, 3> corners{};  ///< indices into PatchMesh::positions, counter-clockwise seen from the front
  std::uint32_t part = 0;                  ///< index into PatchMesh::parts
  glm::vec3 normal{0};                     ///< unit, on the front
  float area = 0;
};

/// What a patch was cut from.
struct PatchPart {
  enum class Form : std::uint8_t { Flat, Sphere, Disk } form = Form::Flat;
  glm::vec3 center{0};  ///< of a sphere or disk
  float radius = 0;     ///< of a sphere or disk
  std::uint32_t material = 0;
  std::uint32_t shape = 0;  ///< as Hit::shape
};

struct PatchMesh {
  std::vector<glm::vec3> positions;
  std::vector<PatchPart> parts;
  std::vector<Patch> patches;

  std::size_t side_count() const { return 2 * patches.size(); }
  glm::vec3 corner(const Patch& patch, int i) const { return positions[patch.corners[static_cast<std::size_t>(i)]]; }
  /// The point with these barycentric coordinates of the second and third corner.
  glm::vec3 point(const Patch& patch, float u, float v) const {
    return (1 - u - v) * corner(patch, 0) + u * corner(patch, 1) + v * corner(patch, 2);
  }
  /// The barycentric coordinates of a point of the patch, for all three corners.
  std::array<float, 3> barycentric(const Patch& patch, glm::vec3 position) const;
};

/// More patches than this are refused: what they exchange would not fit into memory.
inline constexpr std::size_t kMostPatches = 200'000;

/// Patches without an edge longer than this. What lets all light straight through is left out.
/// Errors: LimitError when they would be more than kMostPatches.
PatchMesh cut_into_patches(const Scene& scene, float longest_edge);

/// Each patch that is marked becomes four. Neighbours that are not marked keep an edge with a corner in its middle.
/// Errors: as cut_into_patches.
PatchMesh split(const PatchMesh& mesh, const std::vector<bool>& marked);

/// As a scene of its own: one mesh, whose triangle i is patch i.
Scene scene_of(const PatchMesh& mesh);

}  // namespace heckbert::transport
