#include <heckbert/import/obj_materials.h>

#include <algorithm>
#include <cmath>

#include <tiny_obj_loader.h>

#include <heckbert/import/scene_format.h>
#include <heckbert/import/words.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/material.h>

namespace heckbert::import {
namespace {

using namespace transport;

constexpr float kDefaultIor = 1.5f;
constexpr float kMinIor = 0.2f;
constexpr float kMaxIor = 5;
constexpr float kMaxExponent = 1e5f;

/// Maps one material; holds what is said about it.
class Mapper {
 public:
  Mapper(const tinyobj::material_t& from, Account& account)
      : from_(from), account_(account), prefix_("material \"" + from.name + "\": ") {}

  Material map() {
    const auto rule = std::find_if(kIllumRules.begin(), kIllumRules.end(),
                                   [&](const IllumRule& r) { return r.illum == from_.illum; });
    if (rule == kIllumRules.end()) {
      guess("illum " + std::to_string(from_.illum) + " is unknown, read as illum 2");
    }
    material_.name = from_.name;
    add_lobes(rule == kIllumRules.end() ? Highlight::Phong : rule->highlight);
    conserve_energy();
    add_emission();
    note_unread();
    account_.understood.push_back(prefix_ + "illum " + std::to_string(from_.illum) + ", " + describe(material_));
    return std::move(material_);
  }

 private:
  void guess(const std::string& what) { account_.guessed.push_back(prefix_ + what); }
  void ignore(const std::string& what) { account_.ignored.push_back(prefix_ + what); }

  /// A reflectance: finite and from 0 to 1.
  Rgb share(const tinyobj::real_t (&c)[3], const char* key) {
    const Rgb read(c[0], c[1], c[2]);
    const auto limit = [](float x) { return std::isfinite(x) ? std::clamp(x, 0.0f, 1.0f) : 0.0f; };
    const Rgb limited(limit(read.r), limit(read.g), limit(read.b));
    if (!(limited == read)) {
      guess(std::string(key) + " " + to_text(read) + " is not from 0 to 1, read as " + to_text(limited));
    }
    return limited;
  }

  /// Only the hue: Fresnel says how much a dielectric reflects and transmits, so the file's amounts would count twice.
  Rgb tint(Rgb colour, const char* key) {
    if (is_black(colour)) {
      return Rgb(1);
    }
    const Rgb hue = colour / max_channel(colour);
    if (!(hue == colour)) {
      guess(std::string(key) + " " + to_text(colour) + " read as the tint " + to_text(hue) +
            ": Fresnel says how much is reflected and transmitted");
    }
    return hue;
  }

  void add_lobes(Highlight highlight) {
    const Rgb diffuse = share(from_.diffuse, "Kd");
    const Rgb specular = share(from_.specular, "Ks");
    if (highlight == Highlight::Glass) {
      add_glass(specular);
      if (!is_black(diffuse)) {
        ignore("Kd " + to_text(diffuse) + ": smooth glass does not scatter");
      }
      return;
    }
    if (!is_black(diffuse)) {
      material_.lobes.emplace_back(Lambert{diffuse});
    }
    if (is_black(specular)) {
      return;
    }
    if (highlight == Highlight::None) {
      ignore("Ks " + to_text(specular) + ": illum " + std::to_string(from_.illum) + " has no highlight");
    } else if (highlight == Highlight::Mirror) {
      material_.lobes.emplace_back(Mirror{specular});
    } else {
      add_phong(specular);
    }
  }

  void add_phong(Rgb specular) {
    const float exponent = std::isfinite(from_.shininess) ? std::clamp(from_.shininess, 0.0f, kMaxExponent) : 0.0f;
    if (exponent != from_.shininess) {
      guess("Ns " + to_text(static_cast<double>(from_.shininess)) + " read as " +
            to_text(static_cast<double>(exponent)));
    } else if (exponent == 0) {
      guess("Ns 0 or missing: a highlight as wide as the hemisphere");
    }
    material_.lobes.emplace_back(Phong{specular, exponent});
  }

  void add_glass(Rgb specular) {
    float ior = from_.ior;
    if (ior == 1) {
      guess("Ni 1 or missing: index " + to_text(static_cast<double>(kDefaultIor)));
      ior = kDefaultIor;
    } else if (!(ior >= kMinIor && ior <= kMaxIor)) {
      guess("Ni " + to_text(static_cast<double>(ior)) + " is no index of refraction: index " +
            to_text(static_cast<double>(kDefaultIor)));
      ior = kDefaultIor;
    }
    material_.lobes.emplace_back(Dielectric{ior, tint(specular, "Ks"), tint(share(from_.transmittance, "Tf"), "Tf")});
  }

  void conserve_energy() {
    const float sum = max_channel(max_albedo(material_));
    if (sum <= 1) {
      return;
    }
    guess("Kd and Ks add up to " + to_text(static_cast<double>(sum)) + ", both scaled by " +
          to_text(1 / static_cast<double>(sum)));
    for (Lobe& lobe : material_.lobes) {
      scale(lobe, Rgb(1 / sum));
    }
  }

  void add_emission() {
    const auto limit = [](float x) { return std::isfinite(x) ? std::clamp(x, 0.0f, static_cast<float>(kHuge)) : 0.0f; };
    material_.emission = {limit(from_.emission[0]), limit(from_.emission[1]), limit(from_.emission[2])};
  }

  void note_unread() {
    if (from_.dissolve != 1) {
      ignore("d (or Tr) of opacity " + to_text(static_cast<double>(from_.dissolve)) +
             ": surfaces are opaque or glass by illum");
    }
    const std::pair<const char*, const std::string&> maps[] = {
        {"map_Ka", from_.ambient_texname},  {"map_Kd", from_.diffuse_texname},
        {"map_Ks", from_.specular_texname}, {"map_Ns", from_.specular_highlight_texname},
        {"map_bump", from_.bump_texname},   {"disp", from_.displacement_texname},
        {"map_d", from_.alpha_texname},     {"refl", from_.reflection_texname},
        {"map_Ke", from_.emissive_texname}, {"norm", from_.normal_texname}};
    for (const auto& [key, file] : maps) {
      if (!file.empty()) {
        ignore(std::string(key) + " " + file + ": textures are not read");
      }
    }
    if (from_.roughness != 0 || from_.metallic != 0 || from_.sheen != 0 || from_.clearcoat_thickness != 0) {
      ignore("Pr, Pm, Ps and Pc: the PBR extension is not read");
    }
    for (const auto& [key, value] : from_.unknown_parameter) {
      ignore(join({key, value}, " ") + ": unknown key");
    }
  }

  const tinyobj::material_t& from_;
  Account& account_;
  std::string prefix_;
  Material material_;
};

}  // namespace

std::string_view describe(Highlight highlight) {
  switch (highlight) {
    case Highlight::None:
      return "Lambert Kd; Ks ignored";
    case Highlight::Phong:
      return "Lambert Kd and, unless Ks is black, Phong Ks with exponent Ns";
    case Highlight::Mirror:
      return "Lambert Kd and, unless Ks is black, perfect mirror Ks";
    case Highlight::Glass:
      return "smooth dielectric of index Ni, tinted by the hues of Ks and Tf; Kd ignored";
  }
  return {};
}

std::string obj_rule_reference() {
  std::string out = "| illum | in the specification | read as |\n|---|---|---|\n";
  for (const IllumRule& rule : kIllumRules) {
    out += "| " + std::to_string(rule.illum) + " | " + std::string(rule.published) + " | " +
           std::string(describe(rule.highlight)) + " |\n";
  }
  return out;
}

Material map_material(const tinyobj::material_t& from, Account& account) {
  return Mapper(from, account).map();
}

}  // namespace heckbert::import
