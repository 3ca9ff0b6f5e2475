#include <heckbert/import/mitsuba_shapes.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <heckbert/import/mesh.h>
#include <heckbert/import/mitsuba_bsdfs.h>
#include <heckbert/import/mitsuba_textures.h>
#include <heckbert/import/obj_file.h>
#include <heckbert/import/ply_file.h>
#include <heckbert/import/scene_format.h>
#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

using namespace transport;

constexpr float kPi = std::numbers::pi_v<float>;

// ---- geometry in its own coordinates --------------------------------------------------------------------------------

/// A point for each (u, v) of a grid, with normals; the front is the side of dP/du x dP/dv.
template <class Point>
Mesh make_grid(unsigned across, unsigned along, const Point& point) {
  Mesh mesh;
  for (unsigned j = 0; j <= along; ++j) {
    for (unsigned i = 0; i <= across; ++i) {
      const glm::vec2 uv(static_cast<float>(i) / static_cast<float>(across),
                         static_cast<float>(j) / static_cast<float>(along));
      const auto [position, normal] = point(uv);
      mesh.positions.push_back(position);
      mesh.normals.push_back(normal);
      mesh.texcoords.push_back(uv);
    }
  }
  const auto add = [&](unsigned a, unsigned b, unsigned c) {
    if (has_area(mesh, {a, b, c})) {
      mesh.triangles.emplace_back(a, b, c);
    }
  };
  for (unsigned j = 0; j < along; ++j) {
    for (unsigned i = 0; i < across; ++i) {
      const unsigned corner = j * (across + 1) + i;
      add(corner, corner + 1, corner + across + 2);
      add(corner, corner + across + 2, corner + across + 1);
    }
  }
  return mesh;
}

constexpr unsigned kAround = 128;

struct Surfel {
  glm::vec3 position, normal;
};

void flip_v(Mesh& mesh) {
  for (glm::vec2& uv : mesh.texcoords) {
    uv.y = 1 - uv.y;
  }
}

/// v runs from +z down.
Mesh make_sphere(glm::vec3 center, float radius) {
  Mesh mesh = make_grid(kAround, kAround / 2, [&](glm::vec2 uv) {
    const float theta = kPi * (1 - uv.y), phi = 2 * kPi * uv.x;
    const float across = std::max(0.0f, std::sin(theta));  // at the pole a rounded pi would cross to the other side
    const glm::vec3 n(across * std::cos(phi), across * std::sin(phi), std::cos(theta));
    return Surfel{center + radius * n, n};
  });
  flip_v(mesh);
  return mesh;
}

Mesh make_disk() {
  Mesh mesh;
  mesh.positions.emplace_back(0.0f);
  mesh.texcoords.emplace_back(0.0f);
  for (unsigned i = 0; i < kAround; ++i) {
    const float phi = 2 * kPi * static_cast<float>(i) / static_cast<float>(kAround);
    mesh.positions.emplace_back(std::cos(phi), std::sin(phi), 0.0f);
    mesh.texcoords.emplace_back(1.0f, phi / (2 * kPi));
    mesh.triangles.emplace_back(0u, i + 1, i + 1 == kAround ? 1u : i + 2);
  }
  return mesh;
}

Mesh make_cylinder(glm::vec3 from, glm::vec3 to, float radius) {
  const glm::vec3 axis = glm::normalize(to - from);
  const glm::vec3 other = std::abs(axis.x) > 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 across = glm::normalize(glm::cross(axis, other));
  const glm::vec3 second = glm::cross(axis, across);
  return make_grid(kAround, 1, [&](glm::vec2 uv) {
    const float phi = 2 * kPi * uv.x;
    const glm::vec3 n = std::cos(phi) * across + std::sin(phi) * second;
    return Surfel{from + uv.y * (to - from) + radius * n, n};
  });
}

/// The box from -1 to 1 with texture coordinates from 0 to 1 on each side.
Mesh make_cube() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0), u(0);
      n[axis] = side;
      u[(axis + 1) % 3] = 1;
      const glm::vec3 v = glm::cross(n, u);
      append(mesh, make_quad(n - u - v, 2.0f * u, 2.0f * v));
    }
  }
  return mesh;
}

// ---- plugins --------------------------------------------------------------------------------------------------------

struct ReadShape {
  MitsubaObject& o;
  glm::mat4 to_world;
  bool flip = false;          ///< normals turned round
  bool face_normals = false;  ///< no smoothing
  bool as_mesh = false;       ///< a sphere or disk is wanted as triangles
};

using Result = std::optional<Geometry>;

bool is_similarity(const glm::mat4& m) {
  const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
  const float size = glm::dot(x, x);
  constexpr float kTolerance = 1e-4f;
  const auto small = [&](float value) { return std::abs(value) <= kTolerance * size; };
  return small(glm::dot(y, y) - size) && small(glm::dot(z, z) - size) && small(glm::dot(x, y)) &&
         small(glm::dot(y, z)) && small(glm::dot(z, x));
}

/// Where a mesh has normals, its front is the side that they point to, whatever the order of the corners.
void turn_to_normals(Mesh& mesh) {
  for (glm::uvec3& t : mesh.triangles) {
    const glm::vec3 a = mesh.positions[t.x];
    const glm::vec3 face = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
    if (glm::dot(face, mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) < 0) {
      std::swap(t.y, t.z);
    }
  }
}

Mesh finish(Mesh mesh, const ReadShape& r) {
  transform(mesh, r.to_world);
  if (r.flip) {
    for (glm::uvec3& t : mesh.triangles) {
      std::swap(t.y, t.z);
    }
    for (glm::vec3& n : mesh.normals) {
      n = -n;
    }
  }
  return mesh;
}

/// As Mitsuba does: without normals in the file the surface is smooth, unless `face_normals` is set. Placeholders are
/// taken for none.
Mesh finish_file(Mesh mesh, const ReadShape& r, const std::string& file) {
  if (r.face_normals) {
    mesh.normals.clear();
  } else if (has_placeholder_normals(mesh)) {
    r.o.in().guessed(r.o.place(), r.o.describe() + ": " + file +
                                      ": all its normals are the same, its triangles are not; read as smooth");
    compute_normals(mesh);
  } else if (mesh.normals.empty()) {
    compute_normals(mesh);
  } else {
    turn_to_normals(mesh);
  }
  return finish(std::move(mesh), r);
}

/// Calls `read`; errors of the file become errors of the scene.
template <class Read>
Result read_mesh_file(ReadShape& r, const Read& read) {
  r.face_normals = r.o.flag("face_normals", false);
  const std::filesystem::path path = r.o.file("filename");
  if (path.empty()) {
    return {};
  }
  try {
    Mesh mesh = read(path);
    return finish_file(std::move(mesh), r, path.filename().string());
  } catch (const InputError& problem) {
    r.o.in().error(r.o.place(), r.o.describe() + ": " + path.filename().string() + " has errors of its own");
    r.o.in().adopt(problem.diagnostics());
  } catch (const ReadError& problem) {
    r.o.in().error(r.o.place(), problem.what());
  }
  return {};
}

void tell_notes(ReadShape& r, const std::filesystem::path& path, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    r.o.in().ignored(r.o.place(), r.o.describe() + ": " + path.filename().string() + ": " + note);
  }
}

Result read_obj(ReadShape& r) {
  const bool flip = r.o.flag("flip_tex_coords", true);
  r.o.skip({"max_smooth_angle", "collapse"});
  return read_mesh_file(r, [&](const std::filesystem::path& path) {
    Mesh all;
    const ObjFile file = read_obj_file(path);
    for (const ObjPart& part : file.parts) {
      append(all, part.mesh);
    }
    tell_notes(r, path, file.notes);
    if (flip) {
      flip_v(all);
    }
    return all;
  });
}

Result read_ply(ReadShape& r) {
  const bool flip = r.o.flag("flip_tex_coords", false);
  r.o.skip({"srgb"});
  return read_mesh_file(r, [&](const std::filesystem::path& path) {
    PlyMesh file = read_ply_file(path);
    tell_notes(r, path, file.notes);
    if (flip) {
      flip_v(file.mesh);
    }
    return std::move(file.mesh);
  });
}

Result read_rectangle(ReadShape& r) {
  return finish(make_quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), r);
}

Result read_cube(ReadShape& r) {
  return finish(make_cube(), r);
}

Result read_sphere(ReadShape& r) {
  const glm::vec3 center = r.o.vector("center", glm::vec3(0));
  const float radius = r.o.number("radius", 1, kPositive);
  const bool round = is_similarity(r.to_world);
  if (round && !r.flip && !r.as_mesh) {
    return Sphere{glm::vec3(r.to_world * glm::vec4(center, 1)), radius * glm::length(glm::vec3(r.to_world[0]))};
  }
  Mesh mesh = make_sphere(center, radius);
  r.o.in().guessed(r.o.place(), r.o.describe() + (round ? "" : ", stretched,") + " read as " +
                                    count(mesh.triangles.size(), "triangle"));
  return finish(std::move(mesh), r);
}

Result read_disk(ReadShape& r) {
  if (!is_similarity(r.to_world) || r.as_mesh) {
    Mesh mesh = make_disk();
    r.o.in().guessed(r.o.place(), r.o.describe() + " read as " + count(mesh.triangles.size(), "triangle"));
    return finish(std::move(mesh), r);
  }
  const glm::vec3 normal = glm::transpose(glm::inverse(glm::mat3(r.to_world))) * glm::vec3(0, 0, r.flip ? -1 : 1);
  return Disk{glm::vec3(r.to_world[3]), normal, glm::length(glm::vec3(r.to_world[0]))};
}

Result read_cylinder(ReadShape& r) {
  const glm::vec3 from = r.o.vector("p0", {0, 0, 0});
  const glm::vec3 to = r.o.vector("p1", {0, 0, 1});
  const float radius = r.o.number("radius", 1, kPositive);
  if (!(glm::length(to - from) > 0)) {
    r.o.in().error(r.o.place(), r.o.describe() + ": its two ends are the same point");
    return {};
  }
  return finish(make_cylinder(from, to, radius), r);
}

struct ShapeKind {
  std::string_view type, meaning;
  Result (*read)(ReadShape&);  ///< null: not geometry of its own
};

constexpr ShapeKind kShapes[] = {
    {"obj", "the triangles of a Wavefront OBJ; its materials are not read", read_obj},
    {"ply", "the triangles of a PLY, text or binary", read_ply},
    {"rectangle", "two triangles", read_rectangle},
    {"cube", "twelve triangles", read_cube},
    {"sphere", "a true sphere; triangles when it is stretched, turned inside out or textured by a picture (guessed)",
     read_sphere},
    {"disk", "a true disk; triangles when it is stretched (guessed)", read_disk},
    {"cylinder", "256 triangles with smooth normals", read_cylinder},
    {"shapegroup", "a group of shapes that instances place", nullptr},
    {"instance", "a shape group, placed by `to_world`", nullptr},
};

// ---- material and light ---------------------------------------------------------------------------------------------

std::uint32_t add_material(MitsubaReader& in, Material material) {
  in.imported.scene.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(in.imported.scene.materials.size() - 1);
}

std::uint32_t material_of(MitsubaReader& in, const XmlNode& bsdf) {
  if (const auto known = in.materials.find(&bsdf); known != in.materials.end()) {
    return known->second;
  }
  Material material = read_bsdf(in, bsdf);
  if (material.lobe_sides == Sides::Front) {
    material.lobe_sides = Sides::Both;
    in.one_sided.push_back(&bsdf);
  }
  material.name = bsdf.find("id") != nullptr ? std::string(bsdf["id"]) : to_text(bsdf.place);
  in.understood(bsdf.place, "material \"" + material.name + "\": " + describe(material));
  const std::uint32_t index = add_material(in, std::move(material));
  in.materials.emplace(&bsdf, index);
  return index;
}

/// What Mitsuba takes where a shape names no material: black for a lamp, else grey.
Material default_material(bool emits) {
  Material material;
  material.name = emits ? "lamp" : "default";
  if (!emits) {
    material.lobes.emplace_back(Lambert{Rgb(0.5f)});
  }
  return material;
}

/// The radiance of the <emitter type="area"> on a shape.
ColourOrTexture read_area_light(MitsubaReader& in, const XmlNode& node) {
  MitsubaObject emitter(in, node);
  if (emitter.type() != "area") {
    tell_unknown(emitter, {"area"}, "the shape gives no light");
    return {};
  }
  emitter.skip({"sampling_weight"});
  return read_colour_or_texture(emitter, "radiance", Rgb(1));
}

std::uint32_t read_material(MitsubaReader& in, MitsubaObject& shape) {
  const std::vector<const XmlNode*> bsdfs = shape.nested("bsdf");
  std::vector<const XmlNode*> emitters = shape.nested("emitter");
  for (const XmlNode* old : shape.nested("luminaire")) {
    emitters.push_back(old);
  }
  for (std::size_t i = 1; i < bsdfs.size(); ++i) {
    in.ignored(bsdfs[i]->place, shape.describe() + ": its second bsdf is not read");
  }
  const ColourOrTexture emission = emitters.empty() ? ColourOrTexture{} : read_area_light(in, *emitters.front());
  std::optional<std::uint32_t> index;
  if (!bsdfs.empty()) {
    index = material_of(in, *bsdfs.front());
  }
  if (index && is_black(emission.colour)) {
    return *index;
  }
  Material material = index ? in.imported.scene.materials[*index] : default_material(!emitters.empty());
  material.emission = emission.colour;
  material.emission_texture = emission.texture;
  if (!is_black(emission.colour)) {
    in.understood(emitters.front()->place,
                  shape.describe() + " emits " + (emission.texture ? "a texture" : to_text(emission.colour)));
  }
  return add_material(in, std::move(material));
}

bool has_picture(const Scene& scene, const Material& material) {
  const auto is_picture = [&](std::uint32_t texture) {
    return std::holds_alternative<Image>(scene.textures[texture].source);
  };
  return (material.normal_map && is_picture(material.normal_map->texture)) ||
         (material.opacity && is_picture(material.opacity->texture)) ||
         (material.emission_texture && is_picture(*material.emission_texture)) ||
         std::any_of(material.textures.begin(), material.textures.end(),
                     [&](const LobeTexture& use) { return is_picture(use.texture.texture); });
}

// ---- groups ---------------------------------------------------------------------------------------------------------

void read_instance(MitsubaReader& in, MitsubaObject& shape) {
  const glm::mat4 to_world = shape.transform("to_world");
  const std::vector<const XmlNode*> groups = shape.nested("shape");
  const auto known = groups.size() == 1 ? in.groups.find(groups.front()) : in.groups.end();
  if (known == in.groups.end()) {
    in.error(shape.place(), shape.describe() + " needs a reference to one shapegroup that stands before it");
    return;
  }
  in.imported.scene.instances.push_back({known->second, to_world});
}

void read_group(MitsubaReader& in, const XmlNode& node, MitsubaObject& group) {
  // Shapes go to the scene's list; those of the group are taken off its end again.
  Scene& scene = in.imported.scene;
  const auto before = static_cast<std::ptrdiff_t>(scene.shapes.size());
  for (const XmlNode* shape : group.nested("shape")) {
    read_shape(in, *shape);
  }
  Group out{std::string(node["id"]), {}};
  std::move(scene.shapes.begin() + before, scene.shapes.end(), std::back_inserter(out.shapes));
  scene.shapes.erase(scene.shapes.begin() + before, scene.shapes.end());
  in.groups.emplace(&node, static_cast<std::uint32_t>(scene.groups.size()));
  scene.groups.push_back(std::move(out));
}

}  // namespace

void read_shape(MitsubaReader& in, const XmlNode& node) {
  MitsubaObject shape(in, node);
  const auto kind =
      std::find_if(std::begin(kShapes), std::end(kShapes), [&](const ShapeKind& k) { return k.type == shape.type(); });
  if (kind == std::end(kShapes)) {
    std::vector<std::string> known;
    for (const ShapeKind& k : kShapes) {
      known.emplace_back(k.type);
    }
    tell_unknown(shape, known, "left out");
    return;
  }
  if (kind->read == nullptr) {
    return shape.type() == "instance" ? read_instance(in, shape) : read_group(in, node, shape);
  }
  const glm::mat4 to_world = shape.transform("to_world");
  if (!(std::abs(glm::determinant(glm::mat3(to_world))) > 0)) {
    // A rectangle or disk without thickness is still a surface.
    const glm::vec3 normal = glm::cross(glm::vec3(to_world[0]), glm::vec3(to_world[1]));
    if ((shape.type() != "rectangle" && shape.type() != "disk") || !(glm::length(normal) > 0)) {
      in.error(shape.place(), shape.describe() + ": its transform flattens the shape");
      shape.skip_all();
      return;
    }
  }
  const std::uint32_t material = read_material(in, shape);
  ReadShape read{shape, to_world};
  read.flip = shape.flag("flip_normals", false);
  read.as_mesh = has_picture(in.imported.scene, in.imported.scene.materials[material]);
  if (Result geometry = kind->read(read)) {
    in.imported.scene.shapes.push_back({std::string(node["id"]), std::move(*geometry), material});
  }
}

std::vector<MitsubaPluginFacts> shape_facts() {
  std::vector<MitsubaPluginFacts> out;
  for (const ShapeKind& kind : kShapes) {
    out.push_back({"shape", kind.type, kind.meaning});
  }
  return out;
}

}  // namespace heckbert::import
