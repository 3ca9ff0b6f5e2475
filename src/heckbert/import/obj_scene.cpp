#include <algorithm>

#include <tiny_obj_loader.h>

#include <heckbert/import/framing.h>
#include <heckbert/import/import.h>
#include <heckbert/import/obj_file.h>
#include <heckbert/import/obj_lamps.h>
#include <heckbert/import/obj_materials.h>
#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

using namespace transport;

constexpr float kDefaultAlbedo = 0.7f;

/// The index of the material for faces that name none or one that is not there; made when first needed.
class DefaultMaterial {
 public:
  std::uint32_t index(Imported& imported) {
    if (!index_) {
      index_ = static_cast<std::uint32_t>(imported.scene.materials.size());
      Material material;
      material.name = "default";
      material.lobes.emplace_back(Lambert{Rgb(kDefaultAlbedo)});
      imported.scene.materials.push_back(std::move(material));
      imported.account.guessed.push_back("faces without a known material: Lambert " +
                                         to_text(static_cast<double>(kDefaultAlbedo)));
    }
    return *index_;
  }

 private:
  std::optional<std::uint32_t> index_;
};

bool has_ambient(const tinyobj::material_t& m) {
  return m.ambient[0] != 0 || m.ambient[1] != 0 || m.ambient[2] != 0;
}

bool gives_light(const Scene& scene) {
  for (const Shape& shape : scene.shapes) {
    for (const std::uint32_t material : std::get<Mesh>(shape.geometry).face_materials) {
      if (!is_black(scene.materials[material].emission)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

Imported read_obj_scene(const std::filesystem::path& path) {
  ObjFile file = read_obj_file(path);
  Imported imported;
  Scene& scene = imported.scene;
  Account& account = imported.account;
  account.ignored = std::move(file.notes);
  for (const tinyobj::material_t& material : file.materials) {
    scene.materials.push_back(map_material(material, account));
  }

  if (const auto with_ambient = std::count_if(file.materials.begin(), file.materials.end(), has_ambient)) {
    account.ignored.push_back("Ka of " + count(static_cast<std::size_t>(with_ambient), "material") +
                              ": ambient light is no light path");
  }

  DefaultMaterial fallback;
  std::size_t triangles = 0;
  for (ObjPart& part : file.parts) {
    triangles += part.mesh.triangles.size();
    for (const int material : part.face_materials) {
      part.mesh.face_materials.push_back(material < 0 ? fallback.index(imported)
                                                      : static_cast<std::uint32_t>(material));
    }
    const std::uint32_t first = part.mesh.face_materials.front();
    scene.shapes.push_back({part.name, std::move(part.mesh), first});
  }
  account.understood.push_back(count(scene.shapes.size(), "shape") + ", " + count(triangles, "triangle"));

  orient_lamps(scene, account);

  scene.name = path.stem().string();
  scene.title = path.filename().string();
  scene.camera = frame(scene.shapes);
  account.guessed.emplace_back("no camera: placed one in front of the bounding box, on the z axis");
  if (!gives_light(scene)) {
    scene.environment = Rgb(1);
    account.guessed.emplace_back("no light: a white environment of radiance 1");
  }
  return imported;
}

}  // namespace heckbert::import
