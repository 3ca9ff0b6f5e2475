#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#ifdef __SANITIZE_THREAD__
#include <oneapi/tbb/global_control.h>
#endif
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <heckbert/taxonomy/error.h>
#include <heckbert/transport/emitter.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/large_pages.h>
#include <heckbert/transport/texture.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

namespace {

float max_component(glm::vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, Release>;

/// What the shading of a triangle needs, before its shape is placed, in one cache line: read through the lists of the
/// mesh it would be five.
struct alignas(64) Face {
  glm::vec3 corner, edge1, edge2;
  glm::vec3 normal;  ///< unit
  float size = 0;    ///< largest offset along an edge
  std::uint32_t material = 0;
};

using Faces = std::vector<Face, LargePages<Face>>;

/// A placed shape: what the shading of a hit needs, found by instance and geometry id.
struct Placed {
  const Shape* shape = nullptr;
  std::uint32_t number = 0;     ///< as Hit::shape
  const Face* faces = nullptr;  ///< of a mesh
  bool is_moved = false;        ///< `to_world` is not the identity
  glm::mat4 to_world{1};
  glm::mat3 normal_to_world{1};
  float flip = 1;                       ///< -1 when the transform mirrors, which turns the front of triangles round
  float scale = 1;                      ///< of a similarity; only spheres and disks read it
  float extent = 0;                     ///< largest offset of the transform: what its rounding is relative to
  std::vector<std::uint32_t> emitters;  ///< by primitive; empty: none emits
  bool needs_coordinates = false;       ///< some material of the shape reads texture coordinates or a tangent
};

/// A shape whose material may have holes, as the filter functions find it.
struct CutOut {
  const Scene* scene = nullptr;
  const Shape* shape = nullptr;
};

}  // namespace

struct Tracer::Impl {
  Device device;
  EmbreeScene scene;
  std::vector<EmbreeScene> group_scenes;
  std::map<const Shape*, Faces> faces;  ///< of the meshes
  std::vector<Placed> placed;
  std::vector<std::uint32_t> first_of_instance;  ///< of the top-level geometry id: where its shapes begin in `placed`
  std::uint32_t top_level_shapes = 0;
  std::vector<Emitter> emitters;
  std::vector<std::unique_ptr<CutOut>> cut_outs;

  explicit Impl(const Scene& source);
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void attach(RTCScene target, const Scene& source, const Shape& shape);
  void place(const Scene& source, const Shape& shape, std::uint32_t number, const glm::mat4& to_world);
  void commit(RTCScene target) const;
  const Placed& placed_at(const RTCHit& hit) const {
    const bool instanced = hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
    return placed[instanced ? first_of_instance[hit.instID[0] - top_level_shapes] + hit.geomID : hit.geomID];
  }
};

namespace {

void check_shape(const Scene& scene, const Shape& shape) {
  const auto check_material = [&](std::uint32_t material) {
    if (material >= scene.materials.size())
      throw std::invalid_argument(fmt::format("shape '{}': there is no material {}", shape.name, material));
  };
  check_material(shape.material);
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
    if (mesh->triangles.empty()) throw std::invalid_argument(fmt::format("shape '{}': has no triangles", shape.name));
    for (const glm::uvec3& t : mesh->triangles)
      if (std::max({t.x, t.y, t.z}) >= mesh->positions.size())
        throw std::invalid_argument(fmt::format("shape '{}': a triangle names a vertex that is not there", shape.name));
    if (!mesh->normals.empty() && mesh->normals.size() != mesh->positions.size())
      throw std::invalid_argument(fmt::format("shape '{}': needs one normal per position", shape.name));
    if (!mesh->texcoords.empty() && mesh->texcoords.size() != mesh->positions.size())
      throw std::invalid_argument(fmt::format("shape '{}': needs texture coordinates for every position", shape.name));
    if (!mesh->face_materials.empty() && mesh->face_materials.size() != mesh->triangles.size())
      throw std::invalid_argument(fmt::format("shape '{}': needs one material per triangle", shape.name));
    for (std::uint32_t material : mesh->face_materials) check_material(material);
  } else if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
    if (!(disk->radius > 0) || !(glm::length(disk->normal) > 0))
      throw std::invalid_argument(fmt::format("shape '{}': a disk needs a radius above zero and a normal", shape.name));
  } else if (!(std::get<Sphere>(shape.geometry).radius > 0)) {
    throw std::invalid_argument(fmt::format("shape '{}': a sphere needs a radius above zero", shape.name));
  }
}

std::array<glm::vec2, 3> texcoords(const Mesh& mesh, const glm::uvec3& t) {
  if (mesh.texcoords.empty()) return {{{0, 0}, {1, 0}, {0, 1}}};
  return {mesh.texcoords[t.x], mesh.texcoords[t.y], mesh.texcoords[t.z]};
}

glm::vec2 interpolate(const std::array<glm::vec2, 3>& at, float u, float v) {
  return (1.0f - u - v) * at[0] + u * at[1] + v * at[2];
}

/// How the position moves with the texture coordinates of a triangle: the inverse of how they move with it.
void set_tangents(Hit& hit, const std::array<glm::vec2, 3>& at, glm::vec3 edge1, glm::vec3 edge2) {
  const glm::vec2 d1 = at[1] - at[0], d2 = at[2] - at[0];
  const float determinant = d1.x * d2.y - d1.y * d2.x;
  hit.along_u = hit.along_v = glm::vec3(0);
  if (determinant == 0) return;
  hit.along_u = (d2.y * edge1 - d1.y * edge2) / determinant;
  hit.along_v = (d1.x * edge2 - d2.x * edge1) / determinant;
}

/// Longitude and latitude of a point on the unit sphere.
glm::vec2 sphere_uv(glm::vec3 n) {
  const float longitude = std::atan2(n.y, n.x) / (2.0f * kPi);
  return {longitude < 0 ? longitude + 1.0f : longitude, std::acos(std::clamp(-n.z, -1.0f, 1.0f)) / kPi};
}

/// Distance from the centre over the radius, and the turn about the normal; `s` and `t` span the disk and are as long
/// as its radius.
glm::vec2 disk_uv(glm::vec3 from_center, glm::vec3 s, glm::vec3 t) {
  const float radius2 = glm::dot(s, s);
  const float x = glm::dot(from_center, s) / radius2, y = glm::dot(from_center, t) / radius2;
  const float turn = std::atan2(y, x) / (2.0f * kPi);
  return {std::sqrt(x * x + y * y), turn < 0 ? turn + 1.0f : turn};
}

/// Uniform in [0, 1), a hash of the ray and of the primitive. A ray that meets the same primitive twice in the tree
/// (which has spatial splits) must decide the same both times; two rays of a render never are the same to the last bit,
/// because each starts from a point that was drawn at random (as in pbrt-v4, which does likewise).
float uniform_hash(const RTCRay& ray, const RTCHit& hit) {
  std::uint64_t state = 0x9e3779b97f4a7c15u;
  const auto mix_in = [&](std::uint32_t bits) {
    state = (state ^ bits) * 0xbf58476d1ce4e5b9u;
    state ^= state >> 29;
  };
  for (const float f : {ray.org_x, ray.org_y, ray.org_z, ray.dir_x, ray.dir_y, ray.dir_z})
    mix_in(std::bit_cast<std::uint32_t>(f));
  for (const std::uint32_t id : {hit.primID, hit.geomID, hit.instID[0]}) mix_in(id);
  state = (state ^ (state >> 30)) * 0x94d049bb133111ebu;
  return static_cast<float>((state ^ (state >> 31)) >> 40) * 0x1p-24f;
}

/// Embree's filter: a hit counts with the probability that its surface is there, so that light goes straight through
/// the rest, on paths and shadow rays alike.
void let_through_holes(const RTCFilterFunctionNArguments* args) {
  const auto& cut_out = *static_cast<const CutOut*>(args->geometryUserPtr);
  const auto& ray = *reinterpret_cast<const RTCRay*>(args->ray);
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const Shape& shape = *cut_out.shape;
  std::uint32_t material = shape.material;
  glm::vec2 uv;
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
    if (!mesh->face_materials.empty()) material = mesh->face_materials[hit.primID];
    uv = interpolate(texcoords(*mesh, mesh->triangles[hit.primID]), hit.u, hit.v);
  } else if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
    const glm::vec3 at(ray.org_x + ray.tfar * ray.dir_x, ray.org_y + ray.tfar * ray.dir_y,
                       ray.org_z + ray.tfar * ray.dir_z);
    const Frame frame = Frame::around(glm::normalize(disk->normal));
    uv = disk_uv(at - disk->center, disk->radius * frame.s, disk->radius * frame.t);
  } else {
    uv = sphere_uv(glm::normalize(glm::vec3(hit.Ng_x, hit.Ng_y, hit.Ng_z)));
  }
  const Material& m = cut_out.scene->materials[material];
  if (m.opacity && uniform_hash(ray, hit) >= opacity(*cut_out.scene, m, uv)) args->valid[0] = 0;
}

bool emits(const Scene& scene, std::uint32_t material) {
  return !is_black(scene.materials[material].emission);
}

std::uint32_t face_material(const Shape& shape, std::size_t triangle) {
  const auto& mesh = std::get<Mesh>(shape.geometry);
  return mesh.face_materials.empty() ? shape.material : mesh.face_materials[triangle];
}

Faces faces_of(const Shape& shape) {
  const auto& mesh = std::get<Mesh>(shape.geometry);
  Faces faces(mesh.triangles.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    Face& face = faces[i];
    face.corner = mesh.positions[t.x];
    face.edge1 = mesh.positions[t.y] - face.corner;
    face.edge2 = mesh.positions[t.z] - face.corner;
    face.normal = glm::normalize(glm::cross(face.edge1, face.edge2));
    face.size = std::max(max_component(face.edge1), max_component(face.edge2));
    face.material = face_material(shape, i);
  }
  return faces;
}

/// Is any material of the shape such that the condition holds?
template <class Condition>
bool any_material(const Scene& scene, const Shape& shape, Condition condition) {
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry); mesh != nullptr && !mesh->face_materials.empty())
    return std::any_of(mesh->face_materials.begin(), mesh->face_materials.end(),
                       [&](std::uint32_t material) { return condition(scene.materials[material]); });
  return condition(scene.materials[shape.material]);
}

bool has_glass_mesh(const Scene& scene) {
  const auto is_glass = [](const Material& material) {
    return std::any_of(material.lobes.begin(), material.lobes.end(), [](const Lobe& lobe) {
      return std::holds_alternative<Dielectric>(lobe) || std::holds_alternative<RoughDielectric>(lobe);
    });
  };
  const auto any_glass = [&](const std::vector<Shape>& shapes) {
    return std::any_of(shapes.begin(), shapes.end(), [&](const Shape& shape) {
      return std::holds_alternative<Mesh>(shape.geometry) && any_material(scene, shape, is_glass);
    });
  };
  for (const Group& group : scene.groups)
    if (any_glass(group.shapes)) return true;
  return any_glass(scene.shapes);
}

}  // namespace

Tracer::Impl::Impl(const Scene& source) {
  for (const Shape& shape : source.shapes) check_shape(source, shape);
  for (const Group& group : source.groups)
    for (const Shape& shape : group.shapes) check_shape(source, shape);

  device.reset(rtcNewDevice(nullptr));
  if (device == nullptr) throw LimitError("Embree could not be started on this machine");
  // Watertight edges matter where a ray must cross a closed surface in pairs; elsewhere the faster test will do.
  const RTCSceneFlags flags = has_glass_mesh(source) ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE;
  const auto new_scene = [&] {
    EmbreeScene made(rtcNewScene(device.get()));
    rtcSetSceneFlags(made.get(), flags);
    rtcSetSceneBuildQuality(made.get(), RTC_BUILD_QUALITY_MEDIUM);  // measured: docs/performance.md
    return made;
  };

  scene = new_scene();
  std::uint32_t number = 0;  // of the next shape
  for (const Shape& shape : source.shapes) {
    attach(scene.get(), source, shape);
    place(source, shape, number++, glm::mat4(1));
  }
  top_level_shapes = number;
  std::vector<std::uint32_t> first_of_group;
  for (const Group& group : source.groups) {
    first_of_group.push_back(number);
    number += static_cast<std::uint32_t>(group.shapes.size());
    group_scenes.push_back(new_scene());
    for (const Shape& shape : group.shapes) attach(group_scenes.back().get(), source, shape);
    commit(group_scenes.back().get());
  }
  for (const Instance& instance : source.instances) {
    if (instance.group >= source.groups.size())
      throw std::invalid_argument(fmt::format("there is no group {}", instance.group));
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, group_scenes[instance.group].get());
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &instance.to_world[0][0]);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    first_of_instance.push_back(static_cast<std::uint32_t>(placed.size()));
    std::uint32_t of_group = first_of_group[instance.group];
    for (const Shape& shape : source.groups[instance.group].shapes) place(source, shape, of_group++, instance.to_world);
  }
  commit(scene.get());
}

void Tracer::Impl::attach(RTCScene target, const Scene& source, const Shape& shape) {
  RTCGeometry geometry = nullptr;
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
    geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh->positions.size()));
    std::copy(mesh->positions.begin(), mesh->positions.end(), vertices);
    auto* triangles = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), mesh->triangles.size()));
    std::copy(mesh->triangles.begin(), mesh->triangles.end(), triangles);
    faces.emplace(&shape, faces_of(shape));
  } else if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
    geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
    *static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                     sizeof(glm::vec4), 1)) = glm::vec4(disk->center, disk->radius);
    *static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3,
                                                     sizeof(glm::vec3), 1)) = glm::normalize(disk->normal);
  } else {
    const auto& sphere = std::get<Sphere>(shape.geometry);
    geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* data = static_cast<glm::vec4*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), 1));
    *data = glm::vec4(sphere.center, sphere.radius);
  }
  if (any_material(source, shape, [](const Material& m) { return m.opacity.has_value(); })) {
    cut_outs.push_back(std::make_unique<CutOut>(CutOut{&source, &shape}));
    rtcSetGeometryUserData(geometry, cut_outs.back().get());
    rtcSetGeometryIntersectFilterFunction(geometry, let_through_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, let_through_holes);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(target, geometry);
  rtcReleaseGeometry(geometry);
}

void Tracer::Impl::place(const Scene& source, const Shape& shape, std::uint32_t number, const glm::mat4& to_world) {
  Placed p;
  p.shape = &shape;
  p.number = number;
  p.to_world = to_world;
  p.is_moved = to_world != glm::mat4(1);
  if (const auto found = faces.find(&shape); found != faces.end()) p.faces = found->second.data();
  const glm::mat3 linear(to_world);
  p.normal_to_world = glm::transpose(glm::inverse(linear));
  p.flip = glm::determinant(linear) < 0 ? -1.0f : 1.0f;
  p.extent = max_component(glm::vec3(to_world[3]));
  p.needs_coordinates = any_material(source, shape, needs_surface_coordinates);
  const auto to_world_point = [&](glm::vec3 v) { return glm::vec3(to_world * glm::vec4(v, 1.0f)); };

  const auto add_emitter = [&](std::size_t primitives, std::size_t first, std::size_t count, const Emitter& e) {
    if (p.emitters.empty()) p.emitters.assign(primitives, kNoEmitter);
    for (std::size_t i = first; i < first + count; ++i) p.emitters[i] = static_cast<std::uint32_t>(emitters.size());
    emitters.push_back(e);
    emitters.back().shape = number;
  };
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
    const auto corner = [&](std::size_t triangle, int i) {
      // A mirroring transform turns triangles round: two corners change places, and the front stays the front.
      const int swapped = p.flip < 0 && i > 0 ? 3 - i : i;
      return to_world_point(mesh->positions[mesh->triangles[triangle][swapped]]);
    };
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
      const std::uint32_t material = face_material(shape, i);
      if (!emits(source, material)) continue;
      const Corners first{corner(i, 0), corner(i, 1), corner(i, 2)};
      std::optional<Emitter> e;
      if (i + 1 < mesh->triangles.size() && face_material(shape, i + 1) == material)
        e = rectangle_emitter(first, {corner(i + 1, 0), corner(i + 1, 1), corner(i + 1, 2)});
      const std::size_t count = e ? 2 : 1;
      if (!e) e = triangle_emitter(first);
      if (!(e->area > 0)) continue;
      e->error = clearance(e->origin, p.extent, std::max(max_component(e->edge_u), max_component(e->edge_v)));
      e->material = material;
      add_emitter(mesh->triangles.size(), i, count, *e);
      i += count - 1;
    }
  } else {
    p.scale = glm::length(linear[0]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (std::abs(glm::dot(linear[i], linear[j]) - (i == j ? p.scale * p.scale : 0.0f)) > 1e-4f * p.scale * p.scale)
          throw std::invalid_argument(fmt::format(
              "shape '{}': a sphere or disk can be moved, turned and scaled evenly, but not stretched", shape.name));
    Emitter e;
    if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
      e = disk_emitter(to_world_point(disk->center), p.normal_to_world * disk->normal, disk->radius * p.scale);
    } else {
      const auto& sphere = std::get<Sphere>(shape.geometry);
      e = sphere_emitter(to_world_point(sphere.center), sphere.radius * p.scale);
    }
    e.error = clearance(e.center, p.extent, e.radius);
    e.material = shape.material;
    if (emits(source, shape.material)) add_emitter(1, 0, 1, e);
  }
  placed.push_back(std::move(p));
}

void Tracer::Impl::commit(RTCScene target) const {
#ifdef __SANITIZE_THREAD__
  // Embree is not instrumented: what its tasks hand to one another would be reported as races.
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
#endif
  rtcCommitScene(target);
  if (const RTCError error = rtcGetDeviceError(device.get()); error != RTC_ERROR_NONE)
    throw LimitError(error == RTC_ERROR_OUT_OF_MEMORY
                         ? std::string("the scene does not fit into memory")
                         : fmt::format("Embree could not build the scene (error {})", static_cast<int>(error)));
}

Tracer::Tracer(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Tracer::~Tracer() = default;

const std::vector<Emitter>& Tracer::emitters() const {
  return impl_->emitters;
}

glm::vec3 Tracer::bounds_low() const {
  RTCBounds b;
  rtcGetSceneBounds(impl_->scene.get(), &b);
  return {b.lower_x, b.lower_y, b.lower_z};
}

glm::vec3 Tracer::bounds_high() const {
  RTCBounds b;
  rtcGetSceneBounds(impl_->scene.get(), &b);
  return {b.upper_x, b.upper_y, b.upper_z};
}

std::optional<Hit> Tracer::intersect(const Ray& ray, float farthest) const {
  RTCRayHit query;
  query.ray.org_x = ray.origin.x;
  query.ray.org_y = ray.origin.y;
  query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x;
  query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = 0;
  query.ray.tfar = farthest;
  query.ray.mask = ~0u;
  query.ray.time = 0;
  query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(impl_->scene.get(), &context, &query);
  std::optional<Hit> met(std::in_place);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    met.reset();
    return met;
  }

  const Placed& p = impl_->placed_at(query.hit);
  Hit& hit = *met;
  hit.shape = p.number;
  hit.primitive = query.hit.primID;
  if (const auto* mesh = std::get_if<Mesh>(&p.shape->geometry)) {
    const Face& face = p.faces[query.hit.primID];
    const float u = query.hit.u, v = query.hit.v;
    float size = face.size;
    if (p.is_moved) {
      const glm::mat3 linear(p.to_world);
      const glm::vec3 edge1 = linear * face.edge1, edge2 = linear * face.edge2;
      hit.position = glm::vec3(p.to_world * glm::vec4(face.corner, 1.0f)) + u * edge1 + v * edge2;
      hit.normal_geometric = p.flip * glm::normalize(glm::cross(edge1, edge2));
      size = std::max(max_component(edge1), max_component(edge2));
    } else {
      hit.position = face.corner + u * face.edge1 + v * face.edge2;
      hit.normal_geometric = face.normal;
    }
    hit.front = glm::dot(ray.direction, hit.normal_geometric) < 0;
    hit.normal_shading = hit.normal_geometric;
    if (!mesh->normals.empty()) {
      const glm::uvec3& t = mesh->triangles[query.hit.primID];
      const glm::vec3 n =
          p.normal_to_world * ((1.0f - u - v) * mesh->normals[t.x] + u * mesh->normals[t.y] + v * mesh->normals[t.z]);
      if (const float length = glm::length(n); length > 0)
        hit.normal_shading = glm::dot(n, hit.normal_geometric) < 0 ? -n / length : n / length;
    }
    hit.error = clearance(hit.position, p.extent, size);
    hit.material = face.material;
    if (p.needs_coordinates) {
      hit.has_coordinates = true;
      const auto at = texcoords(*mesh, mesh->triangles[query.hit.primID]);
      hit.uv = interpolate(at, u, v);
      const glm::mat3 linear(p.to_world);
      set_tangents(hit, at, linear * face.edge1, linear * face.edge2);
    }
    if (!p.emitters.empty()) hit.emitter = p.emitters[query.hit.primID];
  } else if (const auto* disk = std::get_if<Disk>(&p.shape->geometry)) {
    // Put back into its plane.
    const glm::vec3 center(p.to_world * glm::vec4(disk->center, 1.0f));
    hit.normal_geometric = glm::normalize(p.normal_to_world * disk->normal);
    hit.position = ray.origin + query.ray.tfar * ray.direction;
    hit.position -= glm::dot(hit.position - center, hit.normal_geometric) * hit.normal_geometric;
    hit.front = glm::dot(ray.direction, hit.normal_geometric) < 0;
    hit.normal_shading = hit.normal_geometric;
    hit.error = clearance(hit.position, p.extent, disk->radius * p.scale);
    hit.material = p.shape->material;
    if (p.needs_coordinates) {
      hit.has_coordinates = true;
      const Frame frame = Frame::around(glm::normalize(disk->normal));
      const glm::mat3 linear(p.to_world);
      const glm::vec3 from_center = hit.position - center;
      hit.uv = disk_uv(from_center, linear * (disk->radius * frame.s), linear * (disk->radius * frame.t));
      hit.along_u = from_center;
      hit.along_v = glm::cross(hit.normal_geometric, from_center);
    }
    if (!p.emitters.empty()) hit.emitter = p.emitters.front();
  } else {
    const auto& sphere = std::get<Sphere>(p.shape->geometry);
    const glm::vec3 center(p.to_world * glm::vec4(sphere.center, 1.0f));
    const float radius = sphere.radius * p.scale;
    // The point is put back onto the sphere, and the side is told by where the ray began: near the silhouette the sign
    // of a cosine is rounding noise, the distance of a cleared origin from the centre is not.
    hit.normal_geometric = glm::normalize(ray.origin + query.ray.tfar * ray.direction - center);
    hit.position = center + radius * hit.normal_geometric;
    const glm::vec3 from_center = ray.origin - center;
    hit.front = glm::dot(from_center, from_center) > radius * radius;
    hit.normal_shading = hit.normal_geometric;
    hit.error = clearance(hit.position, p.extent, radius);
    hit.material = p.shape->material;
    if (p.needs_coordinates) {
      hit.has_coordinates = true;
      const glm::mat3 linear(p.to_world);
      const glm::vec3 n = glm::normalize(glm::transpose(linear) * hit.normal_geometric);
      hit.uv = sphere_uv(n);
      hit.along_u = linear * glm::vec3(-n.y, n.x, 0);
      hit.along_v = glm::cross(hit.normal_geometric, hit.along_u);
    }
    if (!p.emitters.empty()) hit.emitter = p.emitters.front();
  }
  return met;
}

bool Tracer::is_occluded(glm::vec3 from, glm::vec3 to) const {
  // The whole segment is (0, 1) of an unnormalised ray: no distance to round.
  const glm::vec3 d = to - from;
  RTCRay query{};
  query.org_x = from.x;
  query.org_y = from.y;
  query.org_z = from.z;
  query.dir_x = d.x;
  query.dir_y = d.y;
  query.dir_z = d.z;
  query.tfar = 1;
  query.mask = ~0u;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(impl_->scene.get(), &context, &query);
  return query.tfar < 0;
}

bool Tracer::is_occluded(const Ray& ray) const {
  RTCRay query{};
  query.org_x = ray.origin.x;
  query.org_y = ray.origin.y;
  query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x;
  query.dir_y = ray.direction.y;
  query.dir_z = ray.direction.z;
  query.tfar = std::numeric_limits<float>::infinity();
  query.mask = ~0u;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(impl_->scene.get(), &context, &query);
  return query.tfar < 0;
}

}  // namespace heckbert::transport
