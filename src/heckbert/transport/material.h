#pragma once
// Materials that authors know by one name, written as what they are here: sums of lobes. Also what a sum may add up to.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// The albedo of a material's lobes at normal incidence, per channel; more than 1 cannot conserve energy. Textures
/// count as 1, except that those which mix lobes count as whatever mixture is brightest.
Rgb max_albedo(const Material& material);

/// Facets between media of nearly equal index bend light so little that the facet cannot be told from the two rays:
/// rough glass needs an index that differs from 1 by more.
inline constexpr float kLeastRefraction = 1e-3f;

/// Errors: std::invalid_argument for a material that breaks the rules of scene.h, named in the message.
void check_material(const Scene& scene, const Material& material);

/// Rough metal by its colour: GGX with Schlick's Fresnel.
Lobe ggx(Rgb f0, float alpha);

/// A coat alone, S when smooth and G when rough.
Lobe coat_lobe(const Coat& coat, Rgb tint = Rgb(1.0f));

/// A coat over a diffuse base; `linear` as in CoatedDiffuse.
std::vector<Lobe> plastic(Rgb albedo, const Coat& coat, bool linear = true, Rgb coat_tint = Rgb(1.0f));

/// The metallic-roughness model of glTF 2.0: between plastic of the base colour and metal of the base colour. All three
/// lobes are there, whatever `metallic` is, so that a texture can mix them; textures multiply the numbers beside them.
struct MetallicRoughness {
  Rgb base{0.8f};
  float metallic = 0;   ///< 0 to 1
  float roughness = 1;  ///< above 0; alpha is its square
  float ior = 1.5f;
  std::optional<std::uint32_t> base_texture{};
  std::optional<ScalarTexture> metallic_texture{};
  std::optional<ScalarTexture> roughness_texture{};
};
/// Appends three lobes and their textures.
void add_metallic_roughness(Material& material, const MetallicRoughness& model);

/// A metal by its chemical symbol.
struct Metal {
  std::string_view name;
  ConductorFresnel fresnel;
};

/// Complex indices of measured metals, as red, green and blue (spectra of Palik and others, projected to Rec. 709; the
/// figures that scenes exported from Tungsten carry).
std::span<const Metal> metals();
/// Nothing when there is no metal of that name; letters of either case.
std::optional<ConductorFresnel> find_metal(std::string_view name);

}  // namespace heckbert::transport
