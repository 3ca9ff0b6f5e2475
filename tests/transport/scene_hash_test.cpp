// Two scenes share a hash when they look alike and only then.

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include <heckbert/transport/scene_hash.h>

namespace heckbert::transport {
namespace {

Scene some_scene() {
  Scene scene;
  scene.materials = {{.name = "wall", .lobes = {Lambert{}, Mirror{}}}};
  scene.textures = {{.source = Image{.width = 1, .height = 1, .bytes = {1, 2, 3, 4}}}};
  scene.media = {{.scattering = Rgb(1)}};
  scene.shapes = {{.geometry = make_quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}, {.geometry = Sphere{}}};
  scene.groups = {{.shapes = {{.geometry = Disk{}}}}};
  scene.instances = {{}};
  scene.point_lights = {{}};
  scene.spot_lights = {{}};
  scene.distant_lights = {{}};
  scene.environment_image = EnvironmentImage{.width = 1, .height = 1, .pixels = {Rgb(1)}};
  return scene;
}

TEST(SceneHash, IsAnotherOneForEveryChange) {
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene&) {},
      [](Scene& s) { std::get<Lambert>(s.materials[0].lobes[0]).albedo.b = 0.51f; },
      [](Scene& s) { s.materials[0].lobes.pop_back(); },
      [](Scene& s) { std::swap(s.materials[0].lobes[0], s.materials[0].lobes[1]); },
      [](Scene& s) { s.materials[0].lobes[0] = DiffuseTransmission{}; },
      [](Scene& s) { s.materials[0].name = "floor"; },
      [](Scene& s) { s.materials[0].is_index_matched = true; },
      [](Scene& s) { s.materials[0].interior = Interior{.priority = 1}; },
      [](Scene& s) { s.materials[0].normal_map = NormalMap{}; },
      [](Scene& s) { s.materials[0].textures = {LobeTexture{}}; },
      [](Scene& s) { std::get<Image>(s.textures[0].source).bytes[3] = 5; },
      [](Scene& s) { s.textures[0].offset.y = 1; },
      [](Scene& s) { s.media[0].anisotropy = 0.1f; },
      [](Scene& s) { s.medium = 0; },
      [](Scene& s) { std::get<Mesh>(s.shapes[0].geometry).positions[2].z = 1e-7f; },
      [](Scene& s) { std::get<Mesh>(s.shapes[0].geometry).triangles[1].z = 0; },
      [](Scene& s) { std::get<Sphere>(s.shapes[1].geometry).radius = 2; },
      [](Scene& s) { std::swap(s.shapes[0], s.shapes[1]); },
      [](Scene& s) { s.groups[0].shapes[0].material = 1; },
      [](Scene& s) { s.instances[0].to_world[3].y = 1; },
      [](Scene& s) { s.point_lights[0].intensity.r = 2; },
      [](Scene& s) { s.spot_lights[0].falloff_degrees = 3; },
      [](Scene& s) { s.distant_lights.emplace_back(); },
      [](Scene& s) { s.environment.g = 1; },
      [](Scene& s) { s.environment_image->pixels[0].g = 2; },
      [](Scene& s) { s.environment_image.reset(); },
      [](Scene& s) { s.ambient.r = 1; },
      [](Scene& s) { s.camera.lens_radius = 0.1f; },
      [](Scene& s) { s.camera.mirrored = true; },
  };
  std::set<std::uint64_t> hashes;
  for (const auto& change : changes) {
    Scene scene = some_scene();
    change(scene);
    hashes.insert(hash_of(scene));
  }
  EXPECT_EQ(hashes.size(), changes.size());
}

TEST(SceneHash, KnowsNothingOfNamesAndDefaults) {
  Scene scene = some_scene();
  scene.name = "another";
  scene.title = "title";
  scene.defaults.seed = 7;
  EXPECT_EQ(hash_of(scene), hash_of(some_scene()));
}

}  // namespace
}  // namespace heckbert::transport
