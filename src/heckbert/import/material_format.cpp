#include <algorithm>

#include <heckbert/import/scene_format.h>
#include <heckbert/import/words.h>
#include <heckbert/transport/material.h>
#include <heckbert/transport/overload.h>

namespace heckbert::import {
namespace {

using namespace transport;

/// The parameters of every kind of lobe; each kind reads its own.
struct LobeDraft {
  Rgb albedo, reflectance, f0;
  Rgb reflection_tint{1.0f}, transmission_tint{1.0f};
  float ior = 1.5f;
  std::optional<float> roughness, alpha;
  float exponent = 0;
};

struct LobeKind {
  std::string name;
  std::string meaning;
  std::vector<Key<LobeDraft>> keys;
  Lobe (*build)(Reader&, const JsonNode&, const LobeDraft&);
};

// Below these a rough mirror is a mirror in all but letter, and numerically worse.
constexpr Range kAlpha{0.001, 1};
constexpr Range kRoughness{0.03, 1};

Lobe build_ggx(Reader& in, const JsonNode& node, const LobeDraft& d) {
  if (d.roughness.has_value() == d.alpha.has_value()) {
    const bool none = !d.roughness;
    if (!none || (node.find("roughness") == nullptr && node.find("alpha") == nullptr)) {
      in.error(node, none ? "a ggx lobe needs \"roughness\" or \"alpha\""
                          : "a ggx lobe takes \"roughness\" or \"alpha\", not both: alpha is roughness squared");
    }
  }
  return ggx(d.f0, d.alpha.value_or(d.roughness.value_or(1.0f) * d.roughness.value_or(1.0f)));
}

const std::vector<LobeKind>& lobe_kinds() {
  using D = LobeDraft;
  static const std::vector<LobeKind> kinds{
      {"lambert",
       "Diffuse reflection. Letter D.",
       {key("albedo", Colour{kUnit}, &D::albedo, kRequired, "share of the light that is reflected")},
       [](Reader&, const JsonNode&, const D& d) -> Lobe { return Lambert{d.albedo}; }},
      {"mirror",
       "Perfect mirror. Letter S.",
       {key("reflectance", Colour{kUnit}, &D::reflectance, kRequired, "share of the light that is reflected")},
       [](Reader&, const JsonNode&, const D& d) -> Lobe { return Mirror{d.reflectance}; }},
      {"dielectric",
       "Smooth glass, water, air bubble: exact Fresnel and Snell, vacuum in front of the surface. Letter S.",
       {key("ior", Number{{0.2, 5}}, &D::ior, "1.5", "index of refraction behind the surface; below 1 for a bubble"),
        key("reflection_tint", Colour{kUnit}, &D::reflection_tint, "1", "multiplies what Fresnel reflects"),
        key("transmission_tint", Colour{kUnit}, &D::transmission_tint, "1", "multiplies what Fresnel transmits")},
       [](Reader&, const JsonNode&, const D& d) -> Lobe {
         return Dielectric{d.ior, d.reflection_tint, d.transmission_tint};
       }},
      {"ggx",
       "Rough metal: GGX microfacets with Schlick's Fresnel. Letter G. Takes `roughness` or `alpha`, not both; for a "
       "perfectly smooth one use `mirror`.",
       {key("f0", Colour{kUnit}, &D::f0, kRequired, "reflectance at normal incidence"),
        key("roughness", Number{kRoughness}, &D::roughness, "from `alpha`", "what artists call roughness"),
        key("alpha", Number{kAlpha}, &D::alpha, "roughness squared", "width parameter of the distribution")},
       build_ggx},
      {"phong",
       "Normalised Phong lobe around the mirror direction. Letter G.",
       {key("reflectance", Colour{kUnit}, &D::reflectance, kRequired, "share of the light that is reflected"),
        key("exponent", Number{{0, 1e5}}, &D::exponent, kRequired, "higher is sharper")},
       [](Reader&, const JsonNode&, const D& d) -> Lobe {
         return Phong{d.reflectance, d.exponent};
       }}};
  return kinds;
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
};

const std::vector<Key<Emission>>& emission_keys() {
  static const std::vector<Key<Emission>> keys{
      key("radiance", Colour{kNotNegative}, &Emission::radiance, kRequired, "emitted in every direction"),
      key("sides", Choice{{"front", "both"}}, &Emission::sides, "front", "which sides of the surface emit")};
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
  std::string name;
  const JsonNode* type = nullptr;
  const JsonNode* lobes = nullptr;
  Emission emission;
  Rgb phantom_reflectance;
  std::optional<Rgb> ambient_reflectance;
  const JsonNode* medium = nullptr;
  std::optional<int> priority;
  bool is_index_matched = false;
};

const std::vector<Key<MaterialDraft>>& material_keys() {
  using D = MaterialDraft;
  static const std::vector<Key<D>> keys{
      key("name", Text{}, &D::name, kRequired, "what shapes call it"),
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
          "the surface is the boundary of its medium and nothing else: light goes straight through, without a letter")};
  return keys;
}

/// The lobe that `node` describes; `beside` are keys that may stand in the same object.
std::optional<Lobe> read_lobe(Reader& in, const JsonNode& node, const std::string& what, std::vector<BoundKey> beside) {
  const auto type = read_type(in, node, what, lobe_types());
  if (!type) {
    return {};
  }
  const LobeKind& kind = lobe_kinds()[*type];
  LobeDraft draft;
  bind(kind.keys, draft, beside);
  read_object(in, node, what + " of type " + kind.name, beside);
  return kind.build(in, node, draft);
}

void read_lobes(Reader& in, const JsonNode& node, std::vector<Lobe>& out) {
  read_list(in, node, "a list of lobes", [&](const JsonNode& item) {
    LobeDraft unused;
    std::vector<BoundKey> type;
    bind(lobe_type_key(), unused, type);
    if (const auto lobe = read_lobe(in, item, "lobe", type)) {
      out.push_back(*lobe);
    }
  });
  if (node.items.size() > kMaxLobes) {
    in.error(node, "a material has at most " + std::to_string(kMaxLobes) + " lobes, found " +
                       std::to_string(node.items.size()));
  }
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

Material read_material(Reader& in, const JsonNode& node, const Names& media) {
  MaterialDraft draft;
  std::vector<BoundKey> keys;
  bind(material_keys(), draft, keys);
  Material material;
  if (node.kind == JsonNode::Kind::Object && node.find("type") != nullptr) {
    if (const auto lobe = read_lobe(in, node, "material", keys)) {
      material.lobes.push_back(*lobe);
    } else if (const JsonNode* name = node.find("name")) {
      Text::read(in, *name, draft.name);
    }
  } else {
    read_object(in, node, "material", keys);
  }
  if (draft.type != nullptr && draft.lobes != nullptr) {
    in.error(*draft.lobes, "a material takes \"type\" or \"lobes\", not both");
  } else if (draft.lobes != nullptr) {
    read_lobes(in, *draft.lobes, material.lobes);
  } else if (node.kind == JsonNode::Kind::Object && node.find("type") == nullptr && node.find("emission") == nullptr &&
             !draft.is_index_matched) {
    in.error(node, "this material says nothing about light: give it \"type\", \"lobes\" or \"emission\"",
             "\"lobes\": [] makes a black surface");
  }
  material.name = draft.name;
  material.emission = draft.emission.radiance;
  material.emission_sides = draft.emission.sides;
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
    parts.push_back("emits " + to_text(material.emission) +
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
      facts_of("emission", "Emission that says which sides emit.", emission_keys())};
  for (const LobeKind& kind : lobe_kinds()) {
    out.push_back(facts_of("lobe of type " + kind.name, kind.meaning, lobe_type_key()));
    for (const Key<LobeDraft>& k : kind.keys) {
      out.back().keys.push_back(k.facts);
    }
  }
  return out;
}

}  // namespace heckbert::import
