#pragma once
// Meshes in PLY (Turk 1994), as text or binary of either byte order: positions, normals, texture coordinates, polygons.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/transport/scene.h>

namespace heckbert::import {

struct PlyMesh {
  transport::Mesh mesh;
  std::vector<std::string> notes;  ///< what was left out, in sentences
};

/// Reads the whole mesh; polygons become fans of triangles. Memory stays in proportion to the file, whatever its header
/// claims. Errors: ReadError when the file cannot be read; InputError, with line or element, when it is no PLY, ends
/// early, has numbers that are none or corners that are not there.
PlyMesh read_ply_file(const std::filesystem::path& path);
/// The same from memory; `source` names the text in errors.
PlyMesh read_ply(std::string_view bytes, std::string_view source);

}  // namespace heckbert::import
