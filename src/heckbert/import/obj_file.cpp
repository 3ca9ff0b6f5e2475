#include <heckbert/import/obj_file.h>

#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include <tiny_obj_loader.h>
#include <glm/geometric.hpp>

#include <heckbert/import/mesh.h>
#include <heckbert/import/obj_check.h>
#include <heckbert/import/text_file.h>
#include <heckbert/import/words.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

/// A diagnostic about the file as a whole.
Diagnostic about(const std::filesystem::path& path, const std::string& message) {
  Diagnostic diagnostic;
  diagnostic.source = path.string();
  diagnostic.message = message;
  return diagnostic;
}

/// The loader's messages, one sentence each.
std::vector<std::string> sentences(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && (line.back() == '.' || line.back() == ' ')) {
      line.pop_back();
    }
    if (line.size() > 1) {
      out.push_back(line);
    }
  }
  return out;
}

glm::vec3 triple(const std::vector<tinyobj::real_t>& values, int index) {
  const auto at = 3 * static_cast<std::size_t>(index);
  return {values[at], values[at + 1], values[at + 2]};
}

/// OBJ indexes positions and normals apart, a Mesh together: one vertex for each pair that occurs.
class PartBuilder {
 public:
  PartBuilder(const tinyobj::attrib_t& attrib, ObjPart& part) : attrib_(attrib), part_(part) {}

  /// Adds a triangle; false when it has no area.
  bool add(const tinyobj::index_t* corners, int material) {
    glm::uvec3 triangle;
    for (int i = 0; i < 3; ++i) {
      triangle[i] = vertex(corners[i]);
    }
    if (!has_area(part_.mesh, triangle)) {
      return false;
    }
    part_.mesh.triangles.push_back(triangle);
    part_.face_materials.push_back(material);
    return true;
  }

  /// Shading normals hold for a part as a whole, so one corner without takes them from all.
  void finish() {
    if (!all_normals_) {
      part_.mesh.normals.clear();
    }
  }

 private:
  std::uint32_t vertex(const tinyobj::index_t& corner) {
    const auto next = static_cast<std::uint32_t>(part_.mesh.positions.size());
    const auto [entry, is_new] = vertices_.try_emplace({corner.vertex_index, corner.normal_index}, next);
    if (is_new) {
      part_.mesh.positions.push_back(triple(attrib_.vertices, corner.vertex_index));
      glm::vec3 normal(0);
      if (corner.normal_index >= 0) {
        normal = triple(attrib_.normals, corner.normal_index);
      }
      const float length = glm::length(normal);
      all_normals_ = all_normals_ && length > 0 && std::isfinite(length);
      part_.mesh.normals.push_back(all_normals_ ? normal / length : normal);
    }
    return entry->second;
  }

  const tinyobj::attrib_t& attrib_;
  ObjPart& part_;
  std::map<std::pair<int, int>, std::uint32_t> vertices_;
  bool all_normals_ = true;
};

}  // namespace

ObjFile::ObjFile() = default;
ObjFile::~ObjFile() = default;
ObjFile::ObjFile(ObjFile&&) noexcept = default;
ObjFile& ObjFile::operator=(ObjFile&&) noexcept = default;

ObjFile read_obj_file(const std::filesystem::path& path) {
  const std::string text = read_text_file(path);
  if (std::vector<Diagnostic> problems = check_obj_text(text, path.string()); !problems.empty()) {
    throw InputError(std::move(problems));
  }

  ObjFile file;
  tinyobj::attrib_t attrib;
  std::vector<tinyobj::shape_t> shapes;
  std::string warnings;
  std::string errors;
  std::istringstream stream(text);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  tinyobj::MaterialFileReader materials(folder.string() + "/");
  constexpr bool kTriangulate = true;
  if (!tinyobj::LoadObj(&attrib, &shapes, &file.materials, &warnings, &errors, &stream, &materials, kTriangulate) ||
      !errors.empty()) {
    std::vector<Diagnostic> problems;
    for (const std::string& sentence : sentences(errors.empty() ? "cannot be read" : errors)) {
      problems.push_back(about(path, sentence));
    }
    throw InputError(std::move(problems));
  }
  file.notes = sentences(warnings);

  std::size_t flat = 0;
  std::size_t not_surfaces = 0;
  for (const tinyobj::shape_t& shape : shapes) {
    not_surfaces += shape.lines.num_line_vertices.size() + shape.points.indices.size();
    ObjPart part{shape.name, {}, {}};
    PartBuilder builder(attrib, part);
    for (std::size_t i = 0; i < shape.mesh.num_face_vertices.size(); ++i) {
      flat += builder.add(&shape.mesh.indices[3 * i], shape.mesh.material_ids[i]) ? 0 : 1;
    }
    builder.finish();
    if (!part.mesh.triangles.empty()) {
      file.parts.push_back(std::move(part));
    }
  }
  if (flat > 0) {
    file.notes.push_back(count(flat, "triangle") + " without area");
  }
  if (not_surfaces > 0) {
    file.notes.push_back(count(not_surfaces, "line or point") + ": only surfaces are read");
  }
  if (file.parts.empty()) {
    throw InputError(about(path, "this file has no triangles that have an area"));
  }
  return file;
}

}  // namespace heckbert::import
