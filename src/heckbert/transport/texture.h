#pragma once
// Looking up textures: repeated in both directions, pictures filtered bilinearly in linear light.

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <heckbert/record/rgb.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// Linear r, g, b and opacity; a checkerboard is opaque.
glm::vec4 look_up(const Texture& texture, glm::vec2 uv);

/// One channel of the texture that it names.
float look_up(const Scene& scene, const ScalarTexture& texture, glm::vec2 uv);

/// Share of the surface that is there, from 0 to 1.
float opacity(const Scene& scene, const Material& material, glm::vec2 uv);

/// The colour of a texture on average.
Rgb mean_colour(const Texture& texture);

/// Multiplies the parameter of the lobe that `use` names by its texture.
void apply_texture(const Scene& scene, const LobeTexture& use, glm::vec2 uv, Lobe& lobe);

/// The normal that the map asks for, along u, v and the surface's own normal; unit, z > 0.
glm::vec3 mapped_normal(const Scene& scene, const NormalMap& map, glm::vec2 uv);

/// Does a hit on this material need texture coordinates and a tangent?
bool needs_surface_coordinates(const Material& material);

}  // namespace heckbert::transport
