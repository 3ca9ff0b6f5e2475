#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <heckbert/import/mesh.h>
#include <heckbert/import/obj_file.h>
#include <heckbert/import/scene_format.h>
#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

using namespace transport;

/// What the keys of every type of shape fill in; each type reads its own.
struct ShapeDraft {
  std::string name, label;
  const JsonNode* material = nullptr;
  const JsonNode* transform = nullptr;

  glm::vec3 corner{0}, edge_u{0}, edge_v{0};
  glm::vec3 low{0}, high{0};
  bool inward = false;
  glm::vec3 center{0};
  glm::vec3 normal{0};
  float radius = 0;
  Mesh mesh;
  std::string file;
};

struct BuildContext {
  Reader& in;
  const JsonNode& node;
  const ShapeDraft& draft;
  const std::filesystem::path& directory;
  Account& account;
};

struct ShapeKind {
  std::string name;
  std::string meaning;
  std::vector<Key<ShapeDraft>> keys;
  Geometry (*build)(const BuildContext&);  ///< only called when the keys were read without errors
};

void read_points(Reader& in, const JsonNode& node, std::vector<glm::vec3>& out) {
  read_list(in, node, "a list of [x, y, z]",
            [&](const JsonNode& item) { Vector::read(in, item, out.emplace_back(0.0f)); });
}

void read_texcoords(Reader& in, const JsonNode& node, std::vector<glm::vec2>& out) {
  read_list(in, node, "a list of [u, v]", [&](const JsonNode& item) { read_pair(in, item, out.emplace_back(0.0f)); });
}

void read_mesh(Reader& in, const JsonNode& node, std::vector<glm::uvec3>& out) {
  read_list(in, node, "a list of [i, j, k]", [&](const JsonNode& item) {
    glm::uvec3& triangle = out.emplace_back(0u);
    if (item.kind != JsonNode::Kind::List || item.items.size() != 3) {
      in.error_expected(item, "a triangle [i, j, k]");
      return;
    }
    for (int i = 0; i < 3; ++i) {
      std::optional<std::uint32_t> index;
      Integer{0, 0xFFFFFFFE}.read(in, item.items[static_cast<std::size_t>(i)], index);
      triangle[i] = index.value_or(0);
    }
  });
}

Geometry build_mesh(const BuildContext& b) {
  const Mesh& mesh = b.draft.mesh;
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) {
    b.in.error(*b.node.find("normals"), "expected one normal per position, " + std::to_string(mesh.positions.size()) +
                                            ", found " + std::to_string(mesh.normals.size()));
  }
  if (!mesh.texcoords.empty() && mesh.texcoords.size() != mesh.positions.size()) {
    b.in.error(*b.node.find("texcoords"), "expected one [u, v] per position, " + std::to_string(mesh.positions.size()) +
                                              ", found " + std::to_string(mesh.texcoords.size()));
  }
  const JsonNode& triangles = *b.node.find("triangles");
  if (mesh.triangles.empty()) {
    b.in.error(triangles, "a mesh needs at least one triangle");
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3 t = mesh.triangles[i];
    const auto size = mesh.positions.size();
    if (t.x >= size || t.y >= size || t.z >= size) {
      b.in.error(triangles.items[i], "this triangle refers to a position that is not there: there are " +
                                         count(size, "position") + ", counted from 0");
    } else if (!has_area(mesh, t)) {
      b.in.error(triangles.items[i], "this triangle has no area");
    }
  }
  return mesh;
}

Geometry build_disk(const BuildContext& b) {
  if (b.draft.normal == glm::vec3(0)) {
    b.in.error(*b.node.find("normal"), "a disk needs a normal that is not zero");
  }
  return Disk{b.draft.center, b.draft.normal, b.draft.radius};
}

Geometry build_obj(const BuildContext& b) {
  const std::filesystem::path path = b.directory / b.draft.file;
  Mesh all;
  try {
    const ObjFile file = read_obj_file(path);
    for (const ObjPart& part : file.parts) {
      append(all, part.mesh);
    }
    for (const std::string& note : file.notes) {
      b.account.ignored.push_back(b.draft.file + ": " + note);
    }
  } catch (const InputError& problem) {
    b.in.error(*b.node.find("file"), "this OBJ file has errors of its own");
    b.in.adopt(problem.diagnostics());
  } catch (const ReadError& problem) {
    b.in.error(*b.node.find("file"), problem.what());
  }
  return all;
}

Geometry build_quad(const BuildContext& b) {
  const glm::vec3 normal = glm::cross(b.draft.edge_u, b.draft.edge_v);
  const float longest = glm::length(b.draft.edge_u) * glm::length(b.draft.edge_v);
  if (!(glm::length(normal) > 1e-6f * longest)) {
    b.in.error(b.node, "this quad has no area: its edges are zero or parallel");
  }
  return make_quad(b.draft.corner, b.draft.edge_u, b.draft.edge_v);
}

Geometry build_box(const BuildContext& b) {
  if (!(b.draft.low.x < b.draft.high.x && b.draft.low.y < b.draft.high.y && b.draft.low.z < b.draft.high.z)) {
    b.in.error(b.node, "expected \"low\" below \"high\" in x, y and z");
  }
  return make_box(b.draft.low, b.draft.high, b.draft.inward);
}

const std::vector<ShapeKind>& shape_kinds() {
  using D = ShapeDraft;
  static const auto mesh_key = [](std::string_view name, auto rule, auto Mesh::*member, std::string_view otherwise,
                                  std::string_view meaning) {
    KeyFacts facts{std::string(name), rule.describe(), std::string(otherwise), std::string(meaning)};
    return Key<D>{std::move(facts),
                  [rule, member](Reader& in, const JsonNode& node, D& d) { rule.read(in, node, d.mesh.*member); }};
  };
  using Points = Custom<std::vector<glm::vec3>>;
  using Triangles = Custom<std::vector<glm::uvec3>>;
  static const std::vector<ShapeKind> kinds{
      {"quad",
       "A parallelogram. Its front is the side that cross(edge_u, edge_v) points to.",
       {key("corner", Vector{}, &D::corner, kRequired, "one corner"),
        key("edge_u", Vector{}, &D::edge_u, kRequired, "from the corner to the next"),
        key("edge_v", Vector{}, &D::edge_v, kRequired, "from the corner to the previous")},
       build_quad},
      {"box",
       "A box along the axes. Its front is outside.",
       {key("low", Vector{}, &D::low, kRequired, "corner with the least coordinates"),
        key("high", Vector{}, &D::high, kRequired, "corner with the greatest coordinates"),
        key("inward", Flag{}, &D::inward, "false", "front is inside, for a room")},
       build_box},
      {"sphere",
       "A true sphere, not triangles. Its front is outside; its transform may not stretch it.",
       {key("center", Vector{}, &D::center, kRequired, "middle"),
        key("radius", Number{kPositive}, &D::radius, kRequired, "")},
       [](const BuildContext& b) -> Geometry {
         return Sphere{b.draft.center, b.draft.radius};
       }},
      {"disk",
       "Flat and round. Its front is the side that `normal` points to; its transform may not stretch it.",
       {key("center", Vector{}, &D::center, kRequired, "middle"),
        key("normal", Vector{}, &D::normal, kRequired, "at right angles to it, of any length"),
        key("radius", Number{kPositive}, &D::radius, kRequired, "")},
       build_disk},
      {"mesh",
       "Triangles in the file. The front is the side from which the corners run counter-clockwise.",
       {mesh_key("positions", Points{"list of [x, y, z]", read_points}, &Mesh::positions, kRequired, "corners"),
        mesh_key("triangles", Triangles{"list of [i, j, k]", read_mesh}, &Mesh::triangles, kRequired,
                 "three indices into `positions`, from 0"),
        mesh_key("normals", Points{"list of [x, y, z]", read_points}, &Mesh::normals, "flat",
                 "one per position, for shading"),
        mesh_key("texcoords", Custom<std::vector<glm::vec2>>{"list of [u, v]", read_texcoords}, &Mesh::texcoords,
                 "(0, 0), (1, 0), (0, 1) in every triangle", "one per position, for textures")},
       build_mesh},
      {"obj",
       "The triangles of a Wavefront OBJ file; its materials are not read (to read them, give the OBJ file to the "
       "program itself).",
       {key("file", Text{}, &D::file, kRequired, "path, from the folder of the scene file")},
       build_obj}};
  return kinds;
}

const Choice& shape_types() {
  static const Choice types = [] {
    Choice choice;
    for (const ShapeKind& kind : shape_kinds()) {
      choice.words.push_back(kind.name);
    }
    return choice;
  }();
  return types;
}

const std::vector<Key<ShapeDraft>>& common_keys() {
  using D = ShapeDraft;
  static const std::vector<Key<D>> keys{
      type_key<D>(shape_types(), "the kind of shape"), key("name", Text{}, &D::name, "", "what messages call it"),
      key("label", Text{}, &D::label, "its name", "what words recorded with `--labels object` call it"),
      key("material", Later{"name of a material"}, &D::material, kRequired, "what it is made of"),
      key("transform", Later{"list of transform steps"}, &D::transform, "`[]`", "applied to the shape")};
  return keys;
}

bool is_in_range(glm::vec3 p) {
  return kCoordinate.contains(p.x) && kCoordinate.contains(p.y) && kCoordinate.contains(p.z);
}

/// Places the geometry; a sphere must stay a sphere, and everything within the range of coordinates.
void place(Reader& in, const JsonNode& node, const glm::mat4& to_world, Geometry& geometry) {
  if (Mesh* mesh = std::get_if<Mesh>(&geometry)) {
    transform(*mesh, to_world);
    if (!std::all_of(mesh->positions.begin(), mesh->positions.end(), is_in_range)) {
      in.error(node, "this transform moves the shape out of range: coordinates are " + kCoordinate.describe());
    }
    return;
  }
  const std::string what = std::holds_alternative<Disk>(geometry) ? "disk" : "sphere";
  if (!is_similarity(to_world)) {
    in.error(node, "this transform stretches the " + what,
             "move, turn or scale it evenly; a stretched one can be a mesh");
    return;
  }
  const glm::mat3 linear(to_world);
  const float scale = glm::length(linear[0]);
  const auto place_round = [&](auto& round) {
    round.center = glm::vec3(to_world * glm::vec4(round.center, 1));
    round.radius *= scale;
    if (!is_in_range(round.center) || !kPositive.contains(static_cast<double>(round.radius))) {
      in.error(node, "this transform moves the " + what + " out of range: coordinates are " + kCoordinate.describe());
    }
  };
  if (Disk* disk = std::get_if<Disk>(&geometry)) {
    disk->normal = linear * disk->normal;
    place_round(*disk);
  } else {
    place_round(std::get<Sphere>(geometry));
  }
}

}  // namespace

std::optional<Shape> read_shape(Reader& in, const JsonNode& node, const Names& materials,
                                const std::filesystem::path& directory, Account& account) {
  const auto type = read_type(in, node, "shape", shape_types());
  if (!type) {
    return {};
  }
  const ShapeKind& kind = shape_kinds()[*type];
  ShapeDraft draft;
  std::vector<BoundKey> keys;
  bind(common_keys(), draft, keys);
  bind(kind.keys, draft, keys);
  const std::size_t errors_before = in.error_count();
  read_object(in, node, kind.name, keys);
  const std::optional<std::uint32_t> material = materials.find(in, draft.material);
  const glm::mat4 to_world = draft.transform == nullptr ? glm::mat4(1) : read_transform(in, *draft.transform);
  if (in.error_count() != errors_before) {
    return {};
  }
  Geometry geometry = kind.build({in, node, draft, directory, account});
  if (draft.transform != nullptr) {
    place(in, *draft.transform, to_world, geometry);
  }
  if (in.error_count() != errors_before) {
    return {};
  }
  return Shape{draft.name, std::move(geometry), material.value_or(0), draft.label};
}

std::vector<ObjectFacts> shape_format() {
  std::vector<ObjectFacts> out;
  for (const ShapeKind& kind : shape_kinds()) {
    out.push_back(facts_of("shape of type " + kind.name, kind.meaning, common_keys()));
    for (const Key<ShapeDraft>& k : kind.keys) {
      out.back().keys.push_back(k.facts);
    }
  }
  return out;
}

}  // namespace heckbert::import
