#pragma once
// A corner with all kinds of surfaces, all kinds of lights for it, and all kinds of eyes.

#include "test_scenes.h"

namespace heckbert::transport {

struct LightKind {
  const char* name;
  void (*put)(Scene&);
};

inline Mesh lamp_quad() {
  return make_quad({-0.6f, 1.95f, -0.6f}, {1.2f, 0, 0}, {0, 0, 1.2f});
}

/// Enough of them to be chosen through a tree.
inline Mesh lamp_of_many_pieces() {
  constexpr unsigned kSide = 10;
  Mesh mesh;
  for (unsigned i = 0; i < kSide * kSide; ++i) {
    const Mesh piece =
        make_quad({-0.6f + 0.12f * static_cast<float>(i % kSide), 1.8f + 0.02f * static_cast<float>(i % 7),
                   -0.6f + 0.12f * static_cast<float>(i / kSide)},
                  {0.1f, 0, 0}, {0, 0, 0.1f});
    const auto first = static_cast<unsigned>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), piece.positions.begin(), piece.positions.end());
    for (const glm::uvec3 t : piece.triangles) mesh.triangles.push_back(t + first);
  }
  return mesh;
}

/// Squares of two brightnesses, and half of it holes.
inline void put_patterned_lamp(Scene& scene) {
  scene.textures = {{.name = "bright", .source = Checkerboard{Rgb(1), Rgb(0.3f)}, .scale = glm::vec2(2)},
                    {.name = "holes", .source = Checkerboard{Rgb(1), Rgb(0)}, .scale = glm::vec2(3)}};
  Material lamp = emitter(6);
  lamp.emission_texture = 0;
  lamp.opacity = ScalarTexture{1, Channel::R};
  add(scene, lamp_quad(), lamp);
}

/// All in one room, so that each scene has one kind of light and all kinds of surfaces.
inline constexpr LightKind kLights[] = {
    {"area", [](Scene& s) { add(s, lamp_quad(), emitter(5)); }},
    {"ball",
     [](Scene& s) {
       add(s, Sphere{{-0.9f, 1.3f, 0.2f}, 0.25f}, emitter(12));
     }},
    {"sheet that shines on both sides",
     [](Scene& s) {
       add(s, Disk{{-0.8f, 1.0f, 0.3f}, {1, 0.5f, 0}, 0.4f}, emitter(8, Sides::Both));
     }},
    {"pieces", [](Scene& s) { add(s, lamp_of_many_pieces(), emitter(9)); }},
    {"pattern", put_patterned_lamp},
    {"point",
     [](Scene& s) {
       s.point_lights.push_back({.position = {-0.5f, 1.5f, 0.3f}, .intensity = Rgb(4)});
     }},
    {"spot",
     [](Scene& s) {
       s.spot_lights.push_back({.position = {-0.5f, 1.8f, 0.3f},
                                .direction = {0.4f, -1, -0.2f},
                                .intensity = Rgb(9),
                                .cutoff_degrees = 40,
                                .falloff_degrees = 25});
     }},
    {"distant",
     [](Scene& s) {
       s.distant_lights.push_back({.direction = {0.3f, -1, -0.4f}, .irradiance = Rgb(3)});
     }},
    {"sky", [](Scene& s) { s.environment = Rgb(1.5f); }},
};

/// Eight triangles that are shaded as if they were a ball: nowhere do shading and geometric normals differ more.
inline Mesh pebble(glm::vec3 center, float radius) {
  Mesh mesh{.positions = {}, .triangles = {}};
  for (const glm::vec3 n : {glm::vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    mesh.positions.push_back(center + radius * n);
    mesh.normals.push_back(n);
  }
  for (const unsigned x : {0u, 1u})
    for (const unsigned y : {2u, 3u})
      for (const unsigned z : {4u, 5u})
        mesh.triangles.emplace_back((x + y + z) % 2 == 0 ? glm::uvec3(x, y, z) : glm::uvec3(x, z, y));
  return mesh;
}

/// A corner open to the sky: a diffuse wall, a floor with two lobes, a metal wall, a glass ball, paper that lets light
/// through, rough glass, and a pebble that is smoother than it is.
inline Scene corner() {
  Scene scene;
  add(scene, make_quad({-2, -1, -2}, {4, 0, 0}, {0, 3, 0}), {.name = "wall", .lobes = {Lambert{{0.7f, 0.6f, 0.5f}}}});
  add(scene, make_quad({-2, -1, 2}, {4, 0, 0}, {0, 0, -4}),
      {.name = "floor", .lobes = {Lambert{Rgb(0.4f)}, ggx(Rgb(0.4f), 0.5f)}});
  add(scene, make_quad({-2, -1, 2}, {0, 0, -4}, {0, 3, 0}),
      {.name = "metal", .lobes = {Lambert{Rgb(0.2f)}, Mirror{Rgb(0.6f)}}});
  add(scene, Sphere{{0.5f, -0.3f, -0.2f}, 0.6f}, {.name = "glass", .lobes = {Dielectric{}}});
  add(scene, make_quad({0.9f, -1, -1.6f}, {0.8f, 0, 0.6f}, {0, 1.6f, 0}),
      {.name = "paper", .lobes = {Lambert{Rgb(0.3f)}, DiffuseTransmission{Rgb(0.4f)}}});
  add(scene, Sphere{{-0.8f, -0.6f, 0.4f}, 0.4f},
      {.name = "rough glass", .lobes = {RoughDielectric{.ior = 1.5f, .facets = {.alpha_x = 0.4f, .alpha_y = 0.4f}}}});
  add(scene, pebble({0.1f, 0.6f, 0.4f}, 0.5f), {.name = "pebble", .lobes = {Lambert{Rgb(0.4f)}, Mirror{Rgb(0.3f)}}});
  scene.camera = {.position = {1.2f, 0.6f, 2.2f}, .look_at = {-0.2f, -0.3f, -0.4f}, .vertical_fov_degrees = 60};
  return scene;
}

struct EyeKind {
  const char* name;
  void (*make)(Camera&);
};
inline constexpr EyeKind kEyes[] = {{"pinhole", [](Camera&) {}},
                                    {"lens",
                                     [](Camera& c) {
                                       c.lens_radius = 0.4f;
                                       c.focus_distance = 2;
                                     }},
                                    {"orthographic",
                                     [](Camera& c) {
                                       c.projection = Projection::Orthographic;
                                       c.height = 2.5f;
                                     }},
                                    {"panoramic", [](Camera& c) { c.projection = Projection::Panoramic; }}};

}  // namespace heckbert::transport
