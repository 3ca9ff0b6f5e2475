#include <algorithm>
#include <cmath>

#include <heckbert/import/scene_format.h>
#include <heckbert/import/words.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/material.h>
#include <heckbert/transport/overload.h>

namespace heckbert::import {
namespace {

using namespace transport;

/// The parameters of every type of lobe; each type reads its own.
struct LobeDraft {
  Rgb albedo, reflectance{1.0f}, transmittance, f0, base;
  Rgb reflection_tint{1.0f}, transmission_tint{1.0f}, tint{1.0f};
  float ior = 1.5f;
  std::optional<Rgb> eta, k;
  const JsonNode* metal = nullptr;
  std::optional<float> roughness, alpha, alpha_across;
  std::size_t distribution = 0;
  float exponent = 0, metallic = 0;
  bool saturates = false;
  const JsonNode* colour_texture = nullptr;
  const JsonNode* roughness_texture = nullptr;
  const JsonNode* metallic_texture = nullptr;
  float weight = 1;
  const JsonNode* weight_texture = nullptr;
  bool weight_inverted = false;
};

/// What building a lobe may look at.
struct LobeContext {
  Reader& in;
  const JsonNode& node;
  const LobeDraft& draft;
  const Names& textures;
};

struct LobeKind {
  std::string name;
  std::string meaning;
  std::vector<Key<LobeDraft>> keys;
  void (*build)(const LobeContext&, Material&);  ///< appends one lobe or several, and their textures
};

// Below these a rough surface is a smooth one in all but letter, and numerically worse.
constexpr Range kAlpha{0.001, 1};
constexpr Range kRoughness{0.03, 1};
// Above the index of a coat its table ends; at 1 there is no surface.
constexpr Range kCoatIor{1, static_cast<double>(kHighestCoatIor)};
constexpr Range kIor{0.2, 5};

struct ChannelDraft {
  const JsonNode* name = nullptr;
  Channel channel = Channel::R;
};

const std::vector<Key<ChannelDraft>>& channel_keys() {
  using D = ChannelDraft;
  static const std::vector<Key<D>> keys{
      key("name", Later{"name of a texture"}, &D::name, kRequired, "of the texture"),
      key("channel", Choice{{"r", "g", "b", "a"}}, &D::channel, "r", "which of its channels; `a` is opacity")};
  return keys;
}

const Later kTextureName{"name of a texture"};
const Later kTextureChannel{"name of a texture, or a texture channel object"};

/// One channel of a texture, by its name alone or by name and channel.
std::optional<ScalarTexture> find_channel(Reader& in, const JsonNode* node, const Names& textures) {
  if (node == nullptr) {
    return {};
  }
  ChannelDraft draft{.name = node};
  if (node->kind == JsonNode::Kind::Object) {
    draft.name = nullptr;
    read_object(in, *node, "texture channel", channel_keys(), draft);
  }
  const auto texture = textures.find(in, draft.name);
  return texture ? std::optional(ScalarTexture{*texture, draft.channel}) : std::nullopt;
}

void add_texture(Material& material, LobeTexture::Parameter parameter, std::optional<ScalarTexture> texture) {
  if (texture) {
    material.textures.push_back(
        {.lobe = static_cast<std::uint32_t>(material.lobes.size() - 1), .parameter = parameter, .texture = *texture});
  }
}

/// Appends a lobe with its textures, as far as its type has the keys.
void add_lobe(const LobeContext& c, Material& material, const Lobe& lobe) {
  material.lobes.push_back(lobe);
  if (const auto colour = c.textures.find(c.in, c.draft.colour_texture)) {
    add_texture(material, LobeTexture::Parameter::Colour, ScalarTexture{*colour});
  }
  add_texture(material, LobeTexture::Parameter::Roughness, find_channel(c.in, c.draft.roughness_texture, c.textures));
}

bool is_given(const JsonNode& node, std::string_view key) {
  return node.find(key) != nullptr;
}

Microfacets::Distribution distribution(const LobeDraft& d) {
  return static_cast<Microfacets::Distribution>(d.distribution);
}

/// Width of the facets from `roughness` or `alpha`; nothing when neither is there.
std::optional<float> facet_width(const LobeContext& c) {
  if (is_given(c.node, "roughness") && is_given(c.node, "alpha")) {
    c.in.error(c.node, "a lobe takes \"roughness\" or \"alpha\", not both: alpha is roughness squared");
  }
  return c.draft.roughness ? *c.draft.roughness * *c.draft.roughness : c.draft.alpha;
}

Microfacets facets(const LobeContext& c, std::string_view type) {
  if (!is_given(c.node, "roughness") && !is_given(c.node, "alpha")) {
    c.in.error(c.node, "a " + std::string(type) + " lobe needs \"roughness\" or \"alpha\"");
  }
  const float alpha = facet_width(c).value_or(1.0f);
  return {alpha, c.draft.alpha_across.value_or(alpha), distribution(c.draft)};
}

/// A metal by `metal` or by `eta` and `k`; else `otherwise`, whose key is `colour`.
Fresnel reflectance(const LobeContext& c, std::string_view colour, const Fresnel& otherwise) {
  const bool named = is_given(c.node, "metal"), measured = is_given(c.node, "eta") || is_given(c.node, "k");
  if (int{named} + int{measured} + int{is_given(c.node, colour)} != 1) {
    c.in.error(c.node, "expected one of \"" + std::string(colour) + "\", \"metal\", or \"eta\" and \"k\"");
    return otherwise;
  }
  if (measured) {
    if (!is_given(c.node, "eta") || !is_given(c.node, "k")) {
      c.in.error(c.node, "\"eta\" and \"k\" make a metal together");
    }
    return ConductorFresnel{c.draft.eta.value_or(Rgb(1)), c.draft.k.value_or(Rgb(0))};
  }
  if (c.draft.metal == nullptr) {
    return otherwise;
  }
  std::vector<std::string> names;
  for (const Metal& metal : metals()) {
    names.emplace_back(metal.name);
  }
  if (c.draft.metal->kind != JsonNode::Kind::Text) {
    c.in.error_expected(*c.draft.metal, "the chemical symbol of a metal");
  } else if (const auto found = find_metal(c.draft.metal->text)) {
    return *found;
  } else {
    c.in.error(*c.draft.metal, "there is no metal \"" + c.draft.metal->text + "\"",
               Reader::suggest(c.draft.metal->text, names));
  }
  return otherwise;
}

// ---- keys that several types share --------------------------------------------------------------------------------

using LobeKey = Key<LobeDraft>;

std::string metal_names() {
  std::string out;
  for (const Metal& metal : metals()) {
    out += (out.empty() ? "" : ", ") + std::string(metal.name);
  }
  return out;
}

std::vector<LobeKey> operator+(std::vector<LobeKey> a, const std::vector<LobeKey>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

LobeKey colour_texture_key(std::string_view name) {
  return key(name, kTextureName, &LobeDraft::colour_texture, "none", "multiplies the colour before it");
}

std::vector<LobeKey> width_keys(std::string_view otherwise) {
  using D = LobeDraft;
  return {key("roughness", Number{kRoughness}, &D::roughness, otherwise, "what artists call roughness"),
          key("alpha", Number{kAlpha}, &D::alpha, otherwise, "roughness squared: width parameter of the distribution")};
}

std::vector<LobeKey> facet_keys() {
  using D = LobeDraft;
  return width_keys("one of the two is required") +
         std::vector{
             key("alpha_across", Number{kAlpha}, &D::alpha_across, "the other width",
                 "width across the tangent, which follows u of the texture coordinates: brushed metal"),
             key("roughness_texture", kTextureChannel, &D::roughness_texture, "none", "multiplies the roughness")};
}

LobeKey distribution_key() {
  return key("distribution", Choice{{"ggx", "beckmann"}}, &LobeDraft::distribution, "ggx", "how facets are spread");
}

std::vector<LobeKey> metal_keys() {
  using D = LobeDraft;
  return {key("metal", Later{"one of " + metal_names()}, &D::metal, "none", "chemical symbol of a measured metal"),
          key("eta", Colour{{0, 20}}, &D::eta, "none", "real part of a metal's index, with `k`"),
          key("k", Colour{{0, 20}}, &D::k, "none", "imaginary part of a metal's index"),
          key("tint", Colour{kUnit}, &D::tint, "1", "multiplies the whole lobe")};
}

std::vector<LobeKey> glass_keys() {
  using D = LobeDraft;
  return {key("reflection_tint", Colour{kUnit}, &D::reflection_tint, "1", "multiplies what Fresnel reflects"),
          key("transmission_tint", Colour{kUnit}, &D::transmission_tint, "1", "multiplies what Fresnel transmits")};
}

LobeKey ior_key(const Range& range, std::string_view meaning) {
  return key("ior", Number{range}, &LobeDraft::ior, "1.5", meaning);
}

std::vector<LobeKey> reflectance_keys() {
  return {key("f0", Colour{kUnit}, &LobeDraft::f0, "from `metal`, or `eta` and `k`",
              "reflectance at normal incidence; from there by Schlick's Fresnel"),
          colour_texture_key("f0_texture")};
}

void build_microfacets(const LobeContext& c, Material& material, Microfacets::Distribution distribution) {
  const bool ggx = distribution == Microfacets::Distribution::Ggx;
  MicrofacetReflection lobe{.fresnel = reflectance(c, "f0", SchlickFresnel{c.draft.f0}),
                            .facets = facets(c, ggx ? "ggx" : "beckmann"),
                            .tint = c.draft.tint};
  lobe.facets.distribution = distribution;
  add_lobe(c, material, lobe);
}

const std::vector<LobeKind>& lobe_kinds() {
  using D = LobeDraft;
  static const std::vector<LobeKind> kinds{
      {"lambert",
       "Diffuse reflection. Letter D.",
       {key("albedo", Colour{kUnit}, &D::albedo, kRequired, "share of the light that is reflected"),
        colour_texture_key("albedo_texture")},
       [](const LobeContext& c, Material& m) { add_lobe(c, m, Lambert{c.draft.albedo}); }},
      {"oren-nayar",
       "Rough diffuse reflection, by Fujii's improvement of Oren and Nayar's qualitative model. Letter D.",
       {key("albedo", Colour{kUnit}, &D::albedo, kRequired, "share of the light that is reflected at grazing angles"),
        colour_texture_key("albedo_texture"),
        key("roughness", Number{kUnit}, &D::roughness, kRequired, "0 is Lambert's law")},
       [](const LobeContext& c, Material& m) {
         add_lobe(c, m, OrenNayar{c.draft.albedo, c.draft.roughness.value_or(0.0f)});
       }},
      {"diffuse-transmission",
       "Diffuse light on the far side: paper, leaves. Letter D, transmitted.",
       {key("transmittance", Colour{kUnit}, &D::transmittance, kRequired, "share of the light that is transmitted"),
        colour_texture_key("transmittance_texture")},
       [](const LobeContext& c, Material& m) { add_lobe(c, m, DiffuseTransmission{c.draft.transmittance}); }},
      {"mirror", "Perfect mirror, of a colour or of metal. Letter S.",
       std::vector{key("reflectance", Colour{kUnit}, &D::reflectance, "from `metal`, or `eta` and `k`",
                       "share of the light that is reflected"),
                   colour_texture_key("reflectance_texture")} +
           metal_keys(),
       [](const LobeContext& c, Material& m) {
         add_lobe(c, m, Mirror{reflectance(c, "reflectance", c.draft.reflectance), c.draft.tint});
       }},
      {"dielectric",
       "Smooth glass, water, air bubble: exact Fresnel and Snell, vacuum in front of the surface. Letter S.",
       std::vector{ior_key(kIor, "index of refraction behind the surface; below 1 for a bubble")} + glass_keys(),
       [](const LobeContext& c, Material& m) {
         add_lobe(c, m, Dielectric{c.draft.ior, c.draft.reflection_tint, c.draft.transmission_tint});
       }},
      {"thin-dielectric", "A pane of glass without thickness, which light passes straight. Letter S.",
       std::vector{ior_key(kIor, "index of refraction of the pane")} + glass_keys(),
       [](const LobeContext& c, Material& m) {
         add_lobe(c, m, ThinDielectric{c.draft.ior, c.draft.reflection_tint, c.draft.transmission_tint});
       }},
      {"rough-dielectric",
       "Rough glass: facets that reflect and refract. Letter G. Takes `roughness` or `alpha`, not both.",
       std::vector{ior_key(kIor, "index of refraction behind the surface, other than 1"), distribution_key()} +
           facet_keys() + glass_keys(),
       [](const LobeContext& c, Material& m) {
         if (std::abs(c.draft.ior - 1) <= kLeastRefraction) {
           c.in.error(*c.node.find("ior"), "rough glass needs an index of refraction other than 1");
         }
         add_lobe(c, m,
                  RoughDielectric{c.draft.ior, facets(c, "rough-dielectric"), c.draft.reflection_tint,
                                  c.draft.transmission_tint});
       }},
      {"ggx",
       "Rough metal: GGX microfacets. Letter G. Takes `roughness` or `alpha`, not both; for a perfectly smooth one use "
       "`mirror`.",
       reflectance_keys() + facet_keys() + metal_keys(),
       [](const LobeContext& c, Material& m) { build_microfacets(c, m, Microfacets::Distribution::Ggx); }},
      {"beckmann", "The same with Beckmann's distribution, which has no long tails. Letter G.",
       reflectance_keys() + facet_keys() + metal_keys(),
       [](const LobeContext& c, Material& m) { build_microfacets(c, m, Microfacets::Distribution::Beckmann); }},
      {"phong",
       "Normalised Phong lobe around the mirror direction. Letter G.",
       {key("reflectance", Colour{kUnit}, &D::reflectance, kRequired, "share of the light that is reflected"),
        colour_texture_key("reflectance_texture"),
        key("exponent", Number{{0, 1e5}}, &D::exponent, kRequired, "higher is sharper")},
       [](const LobeContext& c, Material& m) {
         add_lobe(c, m, Phong{c.draft.reflectance, c.draft.exponent});
       }},
      {"plastic",
       "A clear coat over a diffuse base, as two lobes: S when neither `roughness` nor `alpha` is given, else G; and "
       "D.",
       std::vector{key("albedo", Colour{kUnit}, &D::albedo, kRequired, "of the base"),
                   colour_texture_key("albedo_texture"), ior_key(kCoatIor, "index of refraction of the coat")} +
           width_keys("smooth") +
           std::vector{distribution_key(), key("saturates", Flag{}, &D::saturates, "false",
                                               "light that bounces below the coat takes the base's colour each time")},
       [](const LobeContext& c, Material& m) {
         const Coat coat{c.draft.ior, facet_width(c).value_or(0.0f), distribution(c.draft)};
         const std::vector<Lobe> lobes = plastic(c.draft.albedo, coat, !c.draft.saturates);
         m.lobes.push_back(lobes.front());
         add_lobe(c, m, lobes.back());
       }},
      {"metallic-roughness",
       "The material model of glTF, as three lobes: coat G and base D of plastic, and metal G.",
       {key("base", Colour{kUnit}, &D::base, kRequired, "colour of plastic and metal"),
        colour_texture_key("base_texture"), key("metallic", Number{kUnit}, &D::metallic, "0", "share of metal"),
        key("metallic_texture", kTextureChannel, &D::metallic_texture, "none", "multiplies the share of metal"),
        key("roughness", Number{kRoughness}, &D::roughness, kRequired, "what artists call roughness"),
        key("roughness_texture", kTextureChannel, &D::roughness_texture, "none", "multiplies the roughness"),
        ior_key(kCoatIor, "index of refraction of the plastic's coat")},
       [](const LobeContext& c, Material& m) {
         add_metallic_roughness(m, {.base = c.draft.base,
                                    .metallic = c.draft.metallic,
                                    .roughness = c.draft.roughness.value_or(1.0f),
                                    .ior = c.draft.ior,
                                    .base_texture = c.textures.find(c.in, c.draft.colour_texture),
                                    .metallic_texture = find_channel(c.in, c.draft.metallic_texture, c.textures),
                                    .roughness_texture = find_channel(c.in, c.draft.roughness_texture, c.textures)});
       }}};
  return kinds;
}

/// Keys of every type of lobe: how much of it there is.
const std::vector<LobeKey>& weight_keys() {
  using D = LobeDraft;
  static const std::vector<LobeKey> keys{
      key("weight", Number{kUnit}, &D::weight, "1", "multiplies the lobe, for mixtures"),
      key("weight_texture", kTextureChannel, &D::weight_texture, "none", "multiplies the lobe from place to place"),
      key("weight_inverted", Flag{}, &D::weight_inverted, "false", "one minus `weight_texture` instead")};
  return keys;
}

void weigh(const LobeContext& c, Material& material, std::size_t first) {
  const auto texture = find_channel(c.in, c.draft.weight_texture, c.textures);
  for (std::size_t i = first; i < material.lobes.size(); ++i) {
    scale(material.lobes[i], Rgb(c.draft.weight));
    if (texture) {
      using Parameter = LobeTexture::Parameter;
      material.textures.push_back({.lobe = static_cast<std::uint32_t>(i),
                                   .parameter = c.draft.weight_inverted ? Parameter::OneMinusWeight : Parameter::Weight,
                                   .texture = *texture});
    }
  }
}

const Choice& lobe_types() {
  static const Choice types = [] {
    Choice choice;
    for (const LobeKind& kind : lobe_kinds()) {
      choice.words.push_back(kind.name);
    }
    return choice;
  }();
  return types;
}

const std::vector<Key<LobeDraft>>& lobe_type_key() {
  static const std::vector<Key<LobeDraft>> keys{type_key<LobeDraft>(lobe_types(), "the kind of lobe")};
  return keys;
}

struct Emission {
  Rgb radiance;
  Sides sides = Sides::Front;
  const JsonNode* texture = nullptr;
};

const std::vector<Key<Emission>>& emission_keys() {
  static const std::vector<Key<Emission>> keys{
      key("radiance", Colour{kNotNegative}, &Emission::radiance, kRequired, "emitted in every direction"),
      key("sides", Choice{{"front", "both"}}, &Emission::sides, "front", "which sides of the surface emit"),
      key("texture", kTextureName, &Emission::texture, "none", "multiplies the radiance from place to place")};
  return keys;
}

void read_emission(Reader& in, const JsonNode& node, Emission& out) {
  if (node.kind == JsonNode::Kind::Object) {
    read_object(in, node, "emission", emission_keys(), out);
  } else {
    Colour{kNotNegative}.read(in, node, out.radiance);
  }
}

struct MaterialDraft {
  std::string name, label, light_group;
  const JsonNode* type = nullptr;
  const JsonNode* lobes = nullptr;
  Emission emission;
  Rgb phantom_reflectance;
  std::optional<Rgb> ambient_reflectance;
  const JsonNode* medium = nullptr;
  std::optional<int> priority;
  bool is_index_matched = false;
  Sides lobe_sides = Sides::Both;
  const JsonNode* opacity = nullptr;
  const JsonNode* normal_map = nullptr;
  float normal_strength = 1;
};

const std::vector<Key<MaterialDraft>>& material_keys() {
  using D = MaterialDraft;
  static const std::vector<Key<D>> keys{
      key("name", Text{}, &D::name, kRequired, "what shapes call it"),
      key("label", Text{}, &D::label, "its name", "what words recorded with `--labels material` call it"),
      key("light_group", Text{}, &D::light_group, "name of the shape",
          "what words recorded with `--labels light-group` call the light that it emits"),
      key("type", Later{lobe_types().describe()}, &D::type, "from `lobes`",
          "one lobe, whose keys stand beside this one"),
      key("lobes", Later{"list of lobes, at most " + std::to_string(kMaxLobes)}, &D::lobes, "from `type`",
          "reflection as a sum of lobes; `[]` for a black surface"),
      key("emission",
          Custom<Emission>{"colour, each " + kNotNegative.describe() + ", or an emission object", read_emission},
          &D::emission, "0", "radiance that the surface emits; it reflects all the same"),
      key("phantom_reflectance", Colour{kUnit}, &D::phantom_reflectance, "0",
          "weight of the mirror ray that the lecture's tracer follows where no mirror or glass does; no light path"),
      key("ambient_reflectance", Colour{kUnit}, &D::ambient_reflectance, "sum of the Lambert albedos",
          "factor of the ambient term of the recursive tracers; no light path"),
      key("medium", Later{"name of a medium"}, &D::medium, "nothing", "what fills the body that the surface encloses"),
      key("priority", Integer{0, 1000}, &D::priority, "0",
          "where bodies overlap, the higher one is there; among equals the one entered last"),
      key("index_matched", Flag{}, &D::is_index_matched, "false",
          "the surface is the boundary of its medium and nothing else: light goes straight through, without a letter"),
      key("lobe_sides", Choice{{"front", "both"}}, &D::lobe_sides, "both", "from which sides the lobes are seen"),
      key("opacity_texture", kTextureChannel, &D::opacity, "none",
          "share of the surface that is there; through the rest light goes straight, without a letter"),
      key("normal_map", kTextureName, &D::normal_map, "none",
          "x along u, y along v and z along the normal, from -1 to 1 stored as 0 to 1"),
      key("normal_strength", Number{{0, 10}}, &D::normal_strength, "1", "multiplies x and y of the normal map")};
  return keys;
}

/// Appends what `node` describes; `beside` are keys that may stand in the same object. False when it has no type.
bool read_lobe(Reader& in, const JsonNode& node, const std::string& what, std::vector<BoundKey> beside,
               const Names& textures, Material& out) {
  const auto type = read_type(in, node, what, lobe_types());
  if (!type) {
    return false;
  }
  const LobeKind& kind = lobe_kinds()[*type];
  LobeDraft draft;
  bind(kind.keys, draft, beside);
  bind(weight_keys(), draft, beside);
  read_object(in, node, what + " of type " + kind.name, beside);
  const LobeContext context{in, node, draft, textures};
  const std::size_t first = out.lobes.size();
  kind.build(context, out);
  weigh(context, out, first);
  return true;
}

void read_lobes(Reader& in, const JsonNode& node, const Names& textures, Material& out) {
  read_list(in, node, "a list of lobes", [&](const JsonNode& item) {
    LobeDraft unused;
    std::vector<BoundKey> type;
    bind(lobe_type_key(), unused, type);
    read_lobe(in, item, "lobe", type, textures, out);
  });
}

void check_energy(Reader& in, const JsonNode& node, const Material& material) {
  constexpr float kRounding = 1e-4f;
  const Rgb sum = max_albedo(material);
  if (max_channel(sum) > 1 + kRounding) {
    in.error(node, "material \"" + material.name + "\" reflects more light than it receives: " + describe(material) +
                       " add up to " + to_text(sum) + ", expected at most 1 in each channel");
  }
}

}  // namespace

Material read_material(Reader& in, const JsonNode& node, const Names& media, const Names& textures) {
  MaterialDraft draft;
  std::vector<BoundKey> keys;
  bind(material_keys(), draft, keys);
  Material material;
  if (node.kind == JsonNode::Kind::Object && node.find("type") != nullptr) {
    if (!read_lobe(in, node, "material", keys, textures, material)) {
      if (const JsonNode* name = node.find("name")) {
        Text::read(in, *name, draft.name);
      }
    }
  } else {
    read_object(in, node, "material", keys);
  }
  if (draft.type != nullptr && draft.lobes != nullptr) {
    in.error(*draft.lobes, "a material takes \"type\" or \"lobes\", not both");
  } else if (draft.lobes != nullptr) {
    read_lobes(in, *draft.lobes, textures, material);
  } else if (node.kind == JsonNode::Kind::Object && node.find("type") == nullptr && node.find("emission") == nullptr &&
             !draft.is_index_matched) {
    in.error(node, "this material says nothing about light: give it \"type\", \"lobes\" or \"emission\"",
             "\"lobes\": [] makes a black surface");
  }
  if (material.lobes.size() > kMaxLobes) {
    in.error(node, "a material has at most " + std::to_string(kMaxLobes) + " lobes, found " +
                       std::to_string(material.lobes.size()));
  }
  material.name = draft.name;
  material.label = draft.label;
  material.light_group = draft.light_group;
  material.emission = draft.emission.radiance;
  material.emission_sides = draft.emission.sides;
  material.emission_texture = textures.find(in, draft.emission.texture);
  material.phantom_reflectance = draft.phantom_reflectance;
  material.ambient_reflectance = draft.ambient_reflectance;
  if (draft.medium != nullptr || draft.priority) {
    material.interior = Interior{media.find(in, draft.medium), draft.priority.value_or(0)};
  }
  material.is_index_matched = draft.is_index_matched;
  if (material.is_index_matched && (!material.lobes.empty() || !is_black(material.emission))) {
    in.error(*node.find("index_matched"), "an index-matched boundary has no lobes and emits nothing",
             "leave out \"index_matched\", or the rest");
  }
  material.lobe_sides = draft.lobe_sides;
  material.opacity = find_channel(in, draft.opacity, textures);
  if (const auto map = textures.find(in, draft.normal_map)) {
    material.normal_map = NormalMap{*map, draft.normal_strength};
  }
  check_energy(in, node, material);
  return material;
}

namespace {

std::string number(float value) {
  return to_text(static_cast<double>(value));
}

std::string describe(const Fresnel& fresnel) {
  return std::visit(
      Overload{
          [](const Rgb& constant) { return to_text(constant); },
          [](const SchlickFresnel& f) { return to_text(f.f0); },
          [](const ConductorFresnel& f) { return "metal of index " + to_text(f.eta) + " + i " + to_text(f.k); },
          [](const DielectricFresnel& f) { return "coat of index " + number(f.ior); },
      },
      fresnel);
}

std::string describe(const Microfacets& facets) {
  const bool ggx = facets.distribution == Microfacets::Distribution::Ggx;
  std::string out = std::string(ggx ? "GGX" : "Beckmann") + " of alpha " + number(facets.alpha_x);
  return facets.alpha_x == facets.alpha_y ? out : out + " by " + number(facets.alpha_y);
}

std::string tinted(Rgb tint) {
  return tint == Rgb(1) ? "" : " times " + to_text(tint);
}

template <class Glass>
std::string tinted(const Glass& glass) {
  if (glass.reflection_tint == Rgb(1) && glass.transmission_tint == Rgb(1)) {
    return "";
  }
  return " tinted " + to_text(glass.reflection_tint) + " and " + to_text(glass.transmission_tint);
}

std::string describe(const Lobe& lobe) {
  return std::visit(
      Overload{
          [](const Lambert& l) { return "Lambert " + to_text(l.albedo); },
          [](const OrenNayar& l) { return "Oren-Nayar " + to_text(l.albedo) + " of roughness " + number(l.roughness); },
          [](const DiffuseTransmission& l) { return "diffuse transmission " + to_text(l.transmittance); },
          [](const CoatedDiffuse& l) {
            return "diffuse " + to_text(l.albedo) + " below a coat of index " + number(l.coat.ior) + tinted(l.tint);
          },
          [](const Mirror& l) { return "mirror " + describe(l.fresnel) + tinted(l.tint); },
          [](const Dielectric& l) { return "dielectric of index " + number(l.ior) + tinted(l); },
          [](const ThinDielectric& l) { return "thin dielectric of index " + number(l.ior) + tinted(l); },
          [](const MicrofacetReflection& l) { return describe(l.facets) + " " + describe(l.fresnel) + tinted(l.tint); },
          [](const RoughDielectric& l) {
            return "rough dielectric of index " + number(l.ior) + ", " + describe(l.facets) + tinted(l);
          },
          [](const Phong& l) { return "Phong " + to_text(l.reflectance) + " of exponent " + number(l.exponent); },
      },
      lobe);
}

}  // namespace

std::string describe(const Material& material) {
  std::vector<std::string> parts;
  for (const Lobe& lobe : material.lobes) {
    parts.push_back(describe(lobe));
  }
  if (!is_black(material.emission)) {
    parts.push_back("emits " + to_text(material.emission) + (material.emission_texture ? " times a texture" : "") +
                    (material.emission_sides == Sides::Both ? " on both sides" : ""));
  }
  if (material.is_index_matched) {
    parts.emplace_back("index-matched boundary");
  }
  if (material.interior) {
    parts.push_back("encloses a body of priority " + std::to_string(material.interior->priority));
  }
  return parts.empty() ? "black" : join(parts);
}

std::vector<ObjectFacts> material_format() {
  std::vector<ObjectFacts> out{
      facts_of("material",
               "How a surface reflects and emits: one lobe by `type`, or several by `lobes`. Reflectances may not add "
               "up to more than 1.",
               material_keys()),
      facts_of("emission", "Emission that says which sides emit.", emission_keys()),
      facts_of("texture channel", "One number of a texture.", channel_keys())};
  for (const LobeKind& kind : lobe_kinds()) {
    out.push_back(facts_of("lobe of type " + kind.name, kind.meaning, lobe_type_key()));
    for (const Key<LobeDraft>& k : kind.keys + weight_keys()) {
      out.back().keys.push_back(k.facts);
    }
  }
  return out;
}

}  // namespace heckbert::import
