#include <heckbert/transport/material.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <heckbert/transport/coat.h>
#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/overload.h>

namespace heckbert::transport {

namespace {

Rgb larger(Rgb a, Rgb b) {
  return {std::max(a.r, b.r), std::max(a.g, b.g), std::max(a.b, b.b)};
}

/// At normal incidence. Schlick's approximation reaches one at grazing angles whatever F0 is; there masking takes most
/// of it, and a bound at normal incidence is what authors of mixtures mean.
Rgb albedo_bound(const Lobe& lobe) {
  return std::visit(Overload{
                        [](const Lambert& l) { return l.albedo; },
                        [](const OrenNayar& l) { return l.albedo; },
                        [](const DiffuseTransmission& l) { return l.transmittance; },
                        [](const CoatedDiffuse& l) { return l.tint * l.albedo * (1.0f - coat_albedo(l.coat, 1.0f)); },
                        [](const Mirror& l) { return l.tint * fresnel(l.fresnel, 1.0f); },
                        [](const MicrofacetReflection& l) { return l.tint * fresnel(l.fresnel, 1.0f); },
                        [](const Phong& l) { return l.reflectance; },
                        // Fresnel splits one between the two parts, so the larger tint bounds their sum.
                        [](const auto& l) { return larger(l.reflection_tint, l.transmission_tint); },
                    },
                    lobe);
}

bool same(const ScalarTexture& a, const ScalarTexture& b) {
  return a.texture == b.texture && a.channel == b.channel;
}

bool is_weight(const LobeTexture& t) {
  return t.parameter == LobeTexture::Parameter::Weight || t.parameter == LobeTexture::Parameter::OneMinusWeight;
}

}  // namespace

Rgb max_albedo(const Material& material) {
  std::vector<ScalarTexture> mixers;
  for (const LobeTexture& t : material.textures)
    if (is_weight(t) && std::none_of(mixers.begin(), mixers.end(), [&](const auto& m) { return same(m, t.texture); }))
      mixers.push_back(t.texture);
  // The sum is linear in each mixing texture, so the brightest mixture has every one of them at 0 or at 1.
  Rgb brightest;
  for (std::size_t corner = 0; corner < std::size_t{1} << mixers.size(); ++corner) {
    Rgb sum;
    for (std::size_t i = 0; i < material.lobes.size(); ++i) {
      float weight = 1;
      for (const LobeTexture& t : material.textures) {
        if (t.lobe != i || !is_weight(t)) continue;
        const auto mixer =
            std::find_if(mixers.begin(), mixers.end(), [&](const auto& m) { return same(m, t.texture); });
        const float value = (corner >> (mixer - mixers.begin()) & 1u) != 0 ? t.factor : 0.0f;
        weight *= t.parameter == LobeTexture::Parameter::Weight ? value : 1.0f - value;
      }
      sum += albedo_bound(material.lobes[i]) * weight;
    }
    brightest = larger(brightest, sum);
  }
  return brightest;
}

void check_material(const Scene& scene, const Material& material) {
  const auto require = [&](bool condition, std::string_view what) {
    if (!condition) throw std::invalid_argument(fmt::format("material '{}': {}", material.name, what));
  };
  const auto has_width = [&](const Microfacets& f) {
    require(f.alpha_x > 0 && f.alpha_y > 0, "the alpha of rough lobes must be above 0");
  };
  const auto is_coat = [&](const Coat& coat) {
    require(coat.ior >= 1 && coat.ior <= kHighestCoatIor && coat.alpha >= 0 && coat.alpha <= 1,
            fmt::format("a coat has an index of 1 to {} and an alpha of 0 to 1", kHighestCoatIor));
  };
  require(material.lobes.size() <= kMaxLobes,
          fmt::format("has {} lobes, at most {} are possible", material.lobes.size(), kMaxLobes));
  for (const Lobe& lobe : material.lobes)
    std::visit(Overload{
                   [&](const MicrofacetReflection& l) { has_width(l.facets); },
                   [&](const RoughDielectric& l) {
                     has_width(l.facets);
                     require(std::abs(l.ior - 1.0f) > kLeastRefraction, "rough glass needs an index other than 1");
                   },
                   [&](const CoatedDiffuse& l) { is_coat(l.coat); },
                   [](const auto&) {},
               },
               lobe);
  const auto has_texture = [&](std::uint32_t texture) {
    require(texture < scene.textures.size(), fmt::format("there is no texture {}", texture));
  };
  for (const LobeTexture& t : material.textures) {
    require(t.lobe < material.lobes.size(), fmt::format("a texture names lobe {}, which is not there", t.lobe));
    has_texture(t.texture.texture);
  }
  if (material.normal_map) has_texture(material.normal_map->texture);
  if (material.opacity) has_texture(material.opacity->texture);
  if (material.emission_texture) has_texture(*material.emission_texture);
}

Lobe ggx(Rgb f0, float alpha) {
  return MicrofacetReflection{.fresnel = SchlickFresnel{f0}, .facets = {.alpha_x = alpha, .alpha_y = alpha}};
}

Lobe coat_lobe(const Coat& coat, Rgb tint) {
  if (coat.alpha <= 0) return Mirror{DielectricFresnel{coat.ior}, tint};
  return MicrofacetReflection{DielectricFresnel{coat.ior}, {coat.alpha, coat.alpha, coat.distribution}, tint};
}

std::vector<Lobe> plastic(Rgb albedo, const Coat& coat, bool linear, Rgb coat_tint) {
  return {coat_lobe(coat, coat_tint), CoatedDiffuse{.albedo = albedo, .coat = coat, .linear = linear}};
}

void add_metallic_roughness(Material& material, const MetallicRoughness& model) {
  using Parameter = LobeTexture::Parameter;
  const auto first = static_cast<std::uint32_t>(material.lobes.size());
  const std::uint32_t coat = first, base = first + 1, metal = first + 2;
  const float alpha = model.roughness * model.roughness;
  for (const Lobe& lobe : plastic(model.base, {.ior = model.ior, .alpha = alpha})) material.lobes.push_back(lobe);
  material.lobes.push_back(ggx(model.base, alpha));

  const auto add = [&](std::uint32_t lobe, Parameter parameter, ScalarTexture texture, float factor = 1) {
    material.textures.push_back({.lobe = lobe, .parameter = parameter, .texture = texture, .factor = factor});
  };
  if (model.base_texture)
    for (const std::uint32_t lobe : {base, metal}) add(lobe, Parameter::Colour, {.texture = *model.base_texture});
  if (model.roughness_texture)
    for (const std::uint32_t lobe : {coat, base, metal}) add(lobe, Parameter::Roughness, *model.roughness_texture);
  if (model.metallic_texture) {
    for (const std::uint32_t lobe : {coat, base})
      add(lobe, Parameter::OneMinusWeight, *model.metallic_texture, model.metallic);
    add(metal, Parameter::Weight, *model.metallic_texture, model.metallic);
  } else {
    for (const std::uint32_t lobe : {coat, base}) scale(material.lobes[lobe], Rgb(1.0f - model.metallic));
    scale(material.lobes[metal], Rgb(model.metallic));
  }
}

std::span<const Metal> metals() {
  static constexpr std::array<Metal, 16> kMetals{{
      {"Ag", {{0.1552646f, 0.1167233f, 0.1383807f}, {4.8283433f, 3.1222459f, 2.1469505f}}},
      {"Al", {{1.6574600f, 0.8803690f, 0.5212287f}, {9.2238692f, 6.2695232f, 4.8370012f}}},
      {"Au", {{0.1431190f, 0.3749570f, 1.4424786f}, {3.9831604f, 2.3857207f, 1.6032153f}}},
      {"Be", {{4.1850593f, 3.1850604f, 2.7840913f}, {3.8354398f, 3.0101260f, 2.8690089f}}},
      {"Cr", {{4.3696829f, 2.9167025f, 1.6547005f}, {5.2064338f, 4.2313645f, 3.7549468f}}},
      {"Cu", {{0.2004377f, 0.9240334f, 1.1022120f}, {3.9129485f, 2.4528477f, 2.1421880f}}},
      {"Hg", {{2.3989315f, 1.4400255f, 0.9095512f}, {6.3276269f, 4.3719414f, 3.4217899f}}},
      {"Ir", {{3.0864098f, 2.0821938f, 1.6178867f}, {5.5921510f, 4.0671757f, 3.2672611f}}},
      {"Mo", {{4.4837010f, 3.5254578f, 2.7760769f}, {4.1111307f, 3.4208716f, 3.1506031f}}},
      {"Nb", {{3.4201354f, 2.7901921f, 2.3955857f}, {3.4413817f, 2.7376438f, 2.5799133f}}},
      {"Ni", {{2.3672754f, 1.6633583f, 1.4670554f}, {4.4988330f, 3.0501644f, 2.3454274f}}},
      {"Rh", {{2.5857955f, 1.8601866f, 1.5544280f}, {6.7822927f, 4.7029501f, 3.9760892f}}},
      {"TiN", {{1.6484692f, 1.1504483f, 1.3797795f}, {3.3684596f, 1.9434889f, 1.1020123f}}},
      {"V", {{4.2775126f, 3.5131538f, 2.7611257f}, {3.4911845f, 2.8893581f, 3.1116965f}}},
      {"VN", {{2.8656012f, 2.1191818f, 1.9400767f}, {3.0323265f, 2.0561076f, 1.6162931f}}},
      {"W", {{4.3707030f, 3.3002972f, 2.9982667f}, {3.5006779f, 2.6048653f, 2.2731931f}}},
  }};
  return kMetals;
}

std::optional<ConductorFresnel> find_metal(std::string_view name) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  for (const Metal& metal : metals())
    if (std::equal(name.begin(), name.end(), metal.name.begin(), metal.name.end(),
                   [&](char a, char b) { return lower(a) == lower(b); }))
      return metal.fresnel;
  return std::nullopt;
}

}  // namespace heckbert::transport
