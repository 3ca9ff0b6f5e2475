#include <heckbert/import/mitsuba_bsdfs.h>

#include <algorithm>
#include <cmath>

#include <heckbert/import/mitsuba_textures.h>
#include <heckbert/import/scene_format.h>
#include <heckbert/import/words.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/material.h>

namespace heckbert::import {
namespace {

using namespace transport;
using Parameter = LobeTexture::Parameter;

constexpr Range kIor{0.2, 5};
constexpr Range kAlpha{1e-6, 10};
// Below this a rough surface is a smooth one in all but letter, and numerically worse.
constexpr float kLeastAlpha = 1e-4f;

/// Substances whose index Mitsuba knows by name (its table, from Wikipedia's list of refractive indices).
constexpr std::pair<std::string_view, float> kSubstances[] = {
    {"vacuum", 1.0f},      {"helium", 1.000036f},        {"hydrogen", 1.000132f},
    {"air", 1.000277f},    {"carbon dioxide", 1.00045f}, {"water", 1.3330f},
    {"acetone", 1.36f},    {"ethanol", 1.361f},          {"carbon tetrachloride", 1.461f},
    {"glycerol", 1.4729f}, {"benzene", 1.501f},          {"silicone oil", 1.52045f},
    {"bromine", 1.661f},   {"water ice", 1.31f},         {"fused quartz", 1.458f},
    {"pyrex", 1.470f},     {"acrylic glass", 1.49f},     {"polypropylene", 1.49f},
    {"bk7", 1.5046f},      {"sodium chloride", 1.544f},  {"amber", 1.55f},
    {"pet", 1.5750f},      {"diamond", 2.419f}};

float index_of(MitsubaObject& o, std::string_view name, std::string_view otherwise) {
  const XmlNode* node = o.find(name);
  if (node != nullptr && node->tag != "string") {
    return o.number(name, 1.5f, kIor);
  }
  const std::string substance = o.text(name, otherwise);
  const auto row = std::find_if(std::begin(kSubstances), std::end(kSubstances),
                                [&](const auto& known) { return known.first == substance; });
  if (row != std::end(kSubstances)) {
    return row->second;
  }
  std::vector<std::string> names;
  for (const auto& [known, ior] : kSubstances) {
    names.emplace_back(known);
  }
  const std::string near = nearest(substance, names);
  const XmlAttribute* value = node->find("value");
  o.in().error(value == nullptr ? node->place : value->place, "there is no substance \"" + substance + "\"",
               near.empty() ? "give its index as a float" : "did you mean \"" + near + "\"?");
  return 1.5f;
}

/// Index behind the surface relative to that in front.
float relative_index(MitsubaObject& o, std::string_view interior) {
  const float inside = index_of(o, "int_ior", interior);
  return inside / index_of(o, "ext_ior", "air");
}

void add(Material& material, Lobe lobe, std::optional<std::uint32_t> texture = {}) {
  if (texture) {
    material.textures.push_back(
        {static_cast<std::uint32_t>(material.lobes.size()), Parameter::Colour, {*texture, Channel::R}});
  }
  material.lobes.push_back(lobe);
}

/// A texture on top of the lobe that was added last.
void add_texture(Material& material, Parameter parameter, std::optional<std::uint32_t> texture) {
  if (texture) {
    material.textures.push_back(
        {static_cast<std::uint32_t>(material.lobes.size() - 1), parameter, {*texture, Channel::R}});
  }
}

// Mitsuba's BSDFs reflect on one side only, unless `twosided` says otherwise.
Material one_sided() {
  Material material;
  material.lobe_sides = Sides::Front;
  return material;
}

// ---- diffuse --------------------------------------------------------------------------------------------------------

Material read_diffuse(MitsubaObject& o) {
  Material m = one_sided();
  const ColourOrTexture albedo = read_share(o, "reflectance", Rgb(0.5f));
  add(m, Lambert{albedo.colour}, albedo.texture);
  return m;
}

Material read_rough_diffuse(MitsubaObject& o) {
  Material m = one_sided();
  const ColourOrTexture albedo = read_share(o, "reflectance", Rgb(0.5f));
  const float alpha = o.number("alpha", 0.2f, kNotNegative);
  const float roughness = std::min(1.0f, alpha / std::sqrt(2.0f));
  o.skip({"use_fast_approx"});
  o.in().guessed(o.place(), o.describe() + ": alpha " + to_text(static_cast<double>(alpha)) + " read as roughness " +
                                to_text(static_cast<double>(roughness)) + " of Fujii's form of Oren and Nayar's model");
  add(m, OrenNayar{albedo.colour, roughness}, albedo.texture);
  return m;
}

Material read_diffuse_transmitter(MitsubaObject& o) {
  Material m;
  const ColourOrTexture share = read_share(o, "transmittance", Rgb(0.5f));
  add(m, DiffuseTransmission{share.colour}, share.texture);
  return m;
}

// ---- facets ---------------------------------------------------------------------------------------------------------

struct FacetsOfFile {
  Microfacets facets;
  std::optional<std::uint32_t> texture{};  ///< multiplies both widths
};

FacetsOfFile read_facets(MitsubaObject& o) {
  FacetsOfFile out;
  const std::string name = o.text("distribution", "beckmann");
  out.facets.distribution = name == "ggx" ? Microfacets::Distribution::Ggx : Microfacets::Distribution::Beckmann;
  if (name != "ggx" && name != "beckmann") {
    o.in().guessed(o.place(), o.describe() + ": distribution \"" + name + "\" read as beckmann");
  }
  const NumberOrTexture alpha = read_number_or_texture(o, "alpha", 0.1f, kAlpha);
  out.texture = alpha.texture;
  out.facets.alpha_x = std::max(kLeastAlpha, o.number("alpha_u", alpha.number, kAlpha));
  out.facets.alpha_y = std::max(kLeastAlpha, o.number("alpha_v", alpha.number, kAlpha));
  o.skip({"sample_visible"});
  return out;
}

Fresnel read_conductor_fresnel(MitsubaObject& o) {
  const float outside = o.has("ext_eta") ? index_of(o, "ext_eta", "air") : 1.0f;
  if (o.has("eta") || o.has("k")) {
    const Rgb eta = o.colour("eta", Rgb(0));
    const Rgb k = o.colour("k", Rgb(1));
    o.skip({"material"});
    return ConductorFresnel{eta / outside, k / outside};
  }
  const std::string material = o.text("material", "Cu");
  if (material == "none") {
    return Rgb(1);
  }
  std::optional<ConductorFresnel> metal = find_metal(material);
  if (!metal) {
    o.in().guessed(o.place(), o.describe() + ": the metal \"" + material + "\" is not known, read as copper");
    metal = find_metal("Cu");
  }
  return ConductorFresnel{metal->eta / outside, metal->k / outside};
}

Material read_conductor(MitsubaObject& o) {
  Material m = one_sided();
  const Fresnel fresnel = read_conductor_fresnel(o);
  const ColourOrTexture tint = read_share(o, "specular_reflectance", Rgb(1));
  add(m, Mirror{fresnel, tint.colour}, tint.texture);
  return m;
}

Material read_rough_conductor(MitsubaObject& o) {
  Material m = one_sided();
  const Fresnel fresnel = read_conductor_fresnel(o);
  const ColourOrTexture tint = read_share(o, "specular_reflectance", Rgb(1));
  const FacetsOfFile facets = read_facets(o);
  add(m, MicrofacetReflection{fresnel, facets.facets, tint.colour}, tint.texture);
  add_texture(m, Parameter::Alpha, facets.texture);
  return m;
}

Material read_ward(MitsubaObject& o) {
  Material m = one_sided();
  const ColourOrTexture diffuse = read_share(o, "diffuse_reflectance", Rgb(0.5f));
  const ColourOrTexture specular = read_share(o, "specular_reflectance", Rgb(0.2f));
  o.skip({"variant"});
  Microfacets facets{.distribution = Microfacets::Distribution::Beckmann};
  facets.alpha_x = o.number("alpha_u", 0.1f, kAlpha);
  facets.alpha_y = o.number("alpha_v", 0.1f, kAlpha);
  o.in().guessed(o.place(), o.describe() + ": read as Beckmann facets of the same widths");
  add(m, Lambert{diffuse.colour}, diffuse.texture);
  add(m, MicrofacetReflection{specular.colour, facets, Rgb(1)}, specular.texture);
  return m;
}

Material read_phong(MitsubaObject& o) {
  Material m = one_sided();
  const ColourOrTexture diffuse = read_share(o, "diffuse_reflectance", Rgb(0.5f));
  const ColourOrTexture specular = read_share(o, "specular_reflectance", Rgb(0.2f));
  const float exponent = o.number("exponent", 30, {0, 1e5});
  add(m, Lambert{diffuse.colour}, diffuse.texture);
  add(m, Phong{specular.colour, exponent}, specular.texture);
  return m;
}

// ---- glass ----------------------------------------------------------------------------------------------------------

template <class Interface>
Material read_interface(MitsubaObject& o, Interface lobe, const FacetsOfFile& facets = {}) {
  Material m;
  lobe.ior = relative_index(o, "bk7");
  const ColourOrTexture reflected = read_share(o, "specular_reflectance", Rgb(1));
  const ColourOrTexture transmitted = read_share(o, "specular_transmittance", Rgb(1));
  if (reflected.texture || transmitted.texture) {
    o.in().ignored(o.place(), o.describe() + ": textures on one of the two parts of glass are not read");
  }
  lobe.reflection_tint = reflected.colour;
  lobe.transmission_tint = transmitted.colour;
  add(m, lobe);
  add_texture(m, Parameter::Alpha, facets.texture);
  return m;
}

Material read_rough_dielectric(MitsubaObject& o) {
  const FacetsOfFile facets = read_facets(o);
  return read_interface(o, RoughDielectric{.facets = facets.facets}, facets);
}

// ---- coats ----------------------------------------------------------------------------------------------------------

Coat read_coat(MitsubaObject& o, std::string_view interior, const Microfacets& facets, bool rough) {
  Coat coat;
  coat.ior = relative_index(o, interior);
  if (const float limited = std::clamp(coat.ior, 1.0f, kHighestCoatIor); limited != coat.ior) {
    o.in().guessed(o.place(), o.describe() + ": a coat of relative index " + to_text(static_cast<double>(coat.ior)) +
                                  " read as " + to_text(static_cast<double>(limited)));
    coat.ior = limited;
  }
  coat.alpha = rough ? facets.alpha_x : 0.0f;
  coat.distribution = facets.distribution;
  return coat;
}

/// plastic() with its textures: the coat's lobe first, then the base.
Material plastic_material(Rgb albedo, std::optional<std::uint32_t> albedo_texture, const Coat& coat, bool linear,
                          const ColourOrTexture& coat_tint) {
  Material m = one_sided();
  for (const Lobe& lobe : plastic(albedo, coat, linear, coat_tint.colour)) {
    add(m, lobe, std::holds_alternative<CoatedDiffuse>(lobe) ? albedo_texture : coat_tint.texture);
  }
  return m;
}

Material read_plastic_with(MitsubaObject& o, const Microfacets& facets, bool rough) {
  const ColourOrTexture diffuse = read_share(o, "diffuse_reflectance", Rgb(0.5f));
  const ColourOrTexture specular = read_share(o, "specular_reflectance", Rgb(1));
  const bool linear = !o.flag("nonlinear", false);
  return plastic_material(diffuse.colour, diffuse.texture, read_coat(o, "polypropylene", facets, rough), linear,
                          specular);
}

Material read_plastic(MitsubaObject& o) {
  return read_plastic_with(o, {}, false);
}

Material read_rough_plastic(MitsubaObject& o) {
  const FacetsOfFile facets = read_facets(o);
  if (facets.texture) {
    o.in().ignored(o.place(), o.describe() + ": a texture for \"alpha\" is not read");
  }
  return read_plastic_with(o, facets.facets, true);
}

/// The one nested BSDF; grey when there is none, which is an error.
Material read_nested(MitsubaObject& o) {
  const std::vector<const XmlNode*> nested = o.nested("bsdf");
  if (nested.size() != 1) {
    o.in().error(o.place(), o.describe() + " needs one nested bsdf, found " + std::to_string(nested.size()));
  }
  return nested.empty() ? Material{} : read_bsdf(o.in(), *nested.front());
}

Material read_coating_with(MitsubaObject& o, const Microfacets& facets, bool rough) {
  Material base = read_nested(o);
  const ColourOrTexture specular = read_share(o, "specular_reflectance", Rgb(1));
  const Coat coat = read_coat(o, "bk7", facets, rough);
  const auto* diffuse = base.lobes.size() == 1 ? std::get_if<Lambert>(&base.lobes.front()) : nullptr;
  if (diffuse == nullptr) {
    o.in().ignored(o.place(), o.describe() + ": a coat on anything but a diffuse base is left out");
    return base;
  }
  std::optional<std::uint32_t> texture;
  if (!base.textures.empty()) {
    texture = base.textures.front().texture.texture;
  }
  return plastic_material(diffuse->albedo, texture, coat, false, specular);
}

Material read_coating(MitsubaObject& o) {
  return read_coating_with(o, {}, false);
}

Material read_rough_coating(MitsubaObject& o) {
  return read_coating_with(o, read_facets(o).facets, true);
}

Material read_principled(MitsubaObject& o) {
  Material m = one_sided();
  const ColourOrTexture base = read_share(o, "base_color", Rgb(0.5f));
  const NumberOrTexture metallic = read_number_or_texture(o, "metallic", 0, kUnit);
  const NumberOrTexture roughness = read_number_or_texture(o, "roughness", 0.5f, kUnit);
  MetallicRoughness model;
  model.base = base.colour;
  model.base_texture = base.texture;
  model.metallic = metallic.number;
  model.roughness = std::max(0.03f, roughness.number);
  if (metallic.texture) {
    model.metallic_texture = ScalarTexture{*metallic.texture, Channel::R};
  }
  if (roughness.texture) {
    model.roughness_texture = ScalarTexture{*roughness.texture, Channel::R};
  }
  if (o.has("eta")) {
    model.ior = std::clamp(index_of(o, "eta", "bk7"), 1.0f, kHighestCoatIor);
  }
  o.in().guessed(o.place(), o.describe() + ": read as the metallic-roughness model of glTF");
  add_metallic_roughness(m, model);
  return m;
}

// ---- BSDFs around others --------------------------------------------------------------------------------------------

Material read_two_sided(MitsubaObject& o) {
  const std::vector<const XmlNode*> nested = o.nested("bsdf");
  if (nested.empty() || nested.size() > 2) {
    o.in().error(o.place(), o.describe() + " needs one nested bsdf, found " + std::to_string(nested.size()));
    return {};
  }
  if (nested.size() == 2) {
    o.in().ignored(nested[1]->place,
                   o.describe() + ": the second bsdf, for the back, is not read; both sides are alike");
  }
  Material m = read_bsdf(o.in(), *nested.front());
  m.lobe_sides = Sides::Both;
  return m;
}

/// A texture of one value.
std::uint32_t constant_texture(MitsubaReader& in, float value) {
  Texture texture;
  texture.source = Checkerboard{Rgb(value), Rgb(value)};
  in.imported.scene.textures.push_back(std::move(texture));
  return static_cast<std::uint32_t>(in.imported.scene.textures.size() - 1);
}

Material read_mask(MitsubaObject& o) {
  Material m = read_nested(o);
  const NumberOrTexture opacity = read_number_or_texture(o, "opacity", 0.5f, kUnit);
  m.opacity = ScalarTexture{opacity.texture ? *opacity.texture : constant_texture(o.in(), opacity.number), Channel::R};
  return m;
}

Material read_null(MitsubaObject& o) {
  Material m;
  m.opacity = ScalarTexture{constant_texture(o.in(), 0), Channel::R};
  return m;
}

Material read_bump_map(MitsubaObject& o) {
  Material m = read_nested(o);
  o.skip({"scale"});
  for (const XmlNode* texture : o.nested("texture")) {
    o.in().ignored(texture->place, o.describe() + ": bumps are not read, the surface is smooth");
  }
  return m;
}

Material read_normal_map(MitsubaObject& o) {
  Material m = read_nested(o);
  for (const XmlNode* texture : o.nested("texture")) {
    if (const auto index = read_texture(o.in(), *texture, TextureUse::Data)) {
      m.normal_map = NormalMap{*index};
    }
  }
  return m;
}

/// Adds `part` with a weight that is a number, a texture, or one minus that texture.
void add_part(MitsubaObject& o, Material& sum, Material part, float weight, std::optional<std::uint32_t> texture,
              Parameter parameter) {
  const auto first = static_cast<std::uint32_t>(sum.lobes.size());
  for (Lobe& lobe : part.lobes) {
    scale(lobe, Rgb(weight));
  }
  sum.lobes.insert(sum.lobes.end(), part.lobes.begin(), part.lobes.end());
  for (LobeTexture use : part.textures) {
    use.lobe += first;
    sum.textures.push_back(use);
  }
  for (auto lobe = first; texture && lobe < sum.lobes.size(); ++lobe) {
    sum.textures.push_back({lobe, parameter, {*texture, Channel::R}});
  }
  if (part.normal_map || part.opacity) {
    o.in().ignored(o.place(), o.describe() + ": masks and normal maps of its parts are not read");
  }
  // Black from behind, if all parts are.
  sum.lobe_sides = sum.lobe_sides == Sides::Both || part.lobe_sides == Sides::Both ? Sides::Both : Sides::Front;
}

Material read_blend(MitsubaObject& o) {
  Material sum = one_sided();
  const NumberOrTexture weight = read_number_or_texture(o, "weight", 0.5f, kUnit);
  const std::vector<const XmlNode*> nested = o.nested("bsdf");
  if (nested.size() != 2) {
    o.in().error(o.place(), o.describe() + " needs two nested bsdfs, found " + std::to_string(nested.size()));
    return sum;
  }
  const bool textured = weight.texture.has_value();
  add_part(o, sum, read_bsdf(o.in(), *nested[0]), textured ? 1 : 1 - weight.number, weight.texture,
           Parameter::OneMinusWeight);
  add_part(o, sum, read_bsdf(o.in(), *nested[1]), textured ? 1 : weight.number, weight.texture, Parameter::Weight);
  return sum;
}

Material read_mixture(MitsubaObject& o) {
  Material sum = one_sided();
  const auto weights = parse_numbers(o.text("weights"));
  const std::vector<const XmlNode*> nested = o.nested("bsdf");
  float total = 0;
  for (const float weight : weights.value_or(std::vector<float>{})) {
    total += weight >= 0 ? weight : INFINITY;
  }
  if (!weights || nested.empty() || weights->size() != nested.size() || !(total <= 1 + 1e-5f)) {
    o.in().error(o.place(), o.describe() + " needs as many weights as nested bsdfs, from 0, and at most 1 together");
    return sum;
  }
  for (std::size_t i = 0; i < nested.size(); ++i) {
    add_part(o, sum, read_bsdf(o.in(), *nested[i]), (*weights)[i], {}, Parameter::Weight);
  }
  return sum;
}

// ---- the table ------------------------------------------------------------------------------------------------------

struct BsdfKind {
  std::string_view type, meaning;
  Material (*read)(MitsubaObject&);
};

constexpr BsdfKind kBsdfs[] = {
    {"diffuse", "Lambert", read_diffuse},
    {"roughdiffuse", "Oren-Nayar in Fujii's form; `alpha` over the root of 2 is its roughness (guessed)",
     read_rough_diffuse},
    {"difftrans", "diffuse transmission", read_diffuse_transmitter},
    {"conductor", "perfect mirror with the Fresnel reflectance of a metal, by `material` or `eta` and `k`",
     read_conductor},
    {"roughconductor", "the same on Beckmann or GGX facets", read_rough_conductor},
    {"dielectric", "smooth glass; `int_ior` over `ext_ior`, as numbers or names of substances",
     [](MitsubaObject& o) { return read_interface(o, Dielectric{}); }},
    {"thindielectric", "a sheet of glass without thickness",
     [](MitsubaObject& o) { return read_interface(o, ThinDielectric{}); }},
    {"roughdielectric", "rough glass on Beckmann or GGX facets", read_rough_dielectric},
    {"plastic", "smooth coat over a diffuse base, `nonlinear` or not", read_plastic},
    {"roughplastic", "rough coat over a diffuse base, `nonlinear` or not", read_rough_plastic},
    {"coating", "on a diffuse base as `plastic`; on any other the coat is ignored", read_coating},
    {"roughcoating", "on a diffuse base as `roughplastic`; on any other the coat is ignored", read_rough_coating},
    {"phong", "Lambert and normalised Phong", read_phong},
    {"ward", "Lambert and Beckmann facets of the same widths (guessed)", read_ward},
    {"principled", "the metallic-roughness model of glTF; its other parameters are ignored (guessed)", read_principled},
    {"twosided", "the nested one; all others reflect on both sides too, which in Mitsuba only glass does (guessed)",
     read_two_sided},
    {"mask", "the nested one where `opacity` says that the surface is there; elsewhere light goes straight", read_mask},
    {"null", "nothing: light goes straight", read_null},
    {"bumpmap", "the nested one; the bumps are ignored", read_bump_map},
    {"normalmap", "the nested one with a normal map", read_normal_map},
    {"blendbsdf", "a mixture of two, by a number or a texture", read_blend},
    {"mixturebsdf", "a mixture of several", read_mixture},
};

/// The parts of a mixture may add up to more than they receive; then all are scaled by the same number.
void conserve_energy(MitsubaObject& o, Material& material) {
  const float sum = max_channel(max_albedo(material));
  if (sum <= 1 + 1e-4f) {
    return;
  }
  o.in().guessed(o.place(), o.describe() + ": reflects " + to_text(static_cast<double>(sum)) +
                                " of the light that it receives, scaled by " + to_text(1 / static_cast<double>(sum)));
  for (Lobe& lobe : material.lobes) {
    scale(lobe, Rgb(1 / sum));
  }
}

Material read_anew(MitsubaReader& in, const XmlNode& node) {
  MitsubaObject object(in, node);
  const auto kind =
      std::find_if(std::begin(kBsdfs), std::end(kBsdfs), [&](const BsdfKind& k) { return k.type == object.type(); });
  if (kind == std::end(kBsdfs)) {
    std::vector<std::string> known;
    for (const BsdfKind& k : kBsdfs) {
      known.emplace_back(k.type);
    }
    tell_unknown(object, known, "read as grey, Lambert 0.5 on both sides");
    Material grey;
    grey.lobes.emplace_back(Lambert{Rgb(0.5f)});
    return grey;
  }
  Material material = kind->read(object);
  conserve_energy(object, material);
  if (material.lobes.size() > kMaxLobes) {
    in.error(node.place, object.describe() + ": this mixture has " + std::to_string(material.lobes.size()) +
                             " lobes, at most " + std::to_string(kMaxLobes) + " are possible");
    return {};
  }
  return material;
}

}  // namespace

Material read_bsdf(MitsubaReader& in, const XmlNode& node) {
  if (const auto known = in.bsdfs.find(&node); known != in.bsdfs.end()) {
    return known->second;
  }
  Material material = read_anew(in, node);
  in.bsdfs.emplace(&node, material);
  return material;
}

std::vector<MitsubaPluginFacts> bsdf_facts() {
  std::vector<MitsubaPluginFacts> out;
  for (const BsdfKind& kind : kBsdfs) {
    out.push_back({"bsdf", kind.type, kind.meaning});
  }
  return out;
}

}  // namespace heckbert::import
