#pragma once
// A Wavefront OBJ file as tinyobjloader reads it, made safe: what is out of range, not finite or without area is left
// out and counted, so that nobody downstream needs to check again. Knows nothing of materials; see obj_materials.h.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <heckbert/transport/scene.h>

namespace tinyobj {
struct material_t;
}

namespace heckbert::import {

/// One object or group of the file.
struct ObjPart {
  std::string name;
  transport::Mesh mesh;             ///< face_materials stay empty
  std::vector<int> face_materials;  ///< per triangle, index into ObjFile::materials, or -1
};

struct ObjFile {
  std::vector<ObjPart> parts;  ///< with at least one triangle each
  std::vector<tinyobj::material_t> materials;
  std::vector<std::string> notes;  ///< what was left out, and the loader's warnings, in sentences

  ObjFile();
  ~ObjFile();
  ObjFile(ObjFile&&) noexcept;
  ObjFile& operator=(ObjFile&&) noexcept;
};

/// Errors: ReadError when the file cannot be read; InputError, with the line, when it has no usable triangle or the
/// loader rejects it.
ObjFile read_obj_file(const std::filesystem::path& path);

}  // namespace heckbert::import
