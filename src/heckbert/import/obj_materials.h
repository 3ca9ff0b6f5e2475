#pragma once
// What an MTL material means here. The rule is one table over illum, and this function; docs/obj-import.md shows both.

#include <array>
#include <string>
#include <string_view>

#include <heckbert/import/import.h>

namespace tinyobj {
struct material_t;
}

namespace heckbert::import {

/// What Ks becomes.
enum class Highlight : std::uint8_t { None, Phong, Mirror, Glass };

struct IllumRule {
  int illum;
  std::string_view published;  ///< what the MTL specification says
  Highlight highlight;
};

inline constexpr std::array<IllumRule, 10> kIllumRules{{
    {0, "colour", Highlight::None},
    {1, "colour and ambient", Highlight::None},
    {2, "highlight", Highlight::Phong},
    {3, "reflection, ray traced", Highlight::Mirror},
    {4, "glass, ray traced", Highlight::Glass},
    {5, "reflection with Fresnel, ray traced", Highlight::Mirror},
    {6, "refraction, ray traced", Highlight::Glass},
    {7, "refraction with Fresnel, ray traced", Highlight::Glass},
    {8, "reflection, not ray traced", Highlight::Mirror},
    {9, "glass, not ray traced", Highlight::Glass},
}};

/// What a Highlight does, for the reference.
std::string_view describe(Highlight highlight);
/// kIllumRules as a Markdown table; stands in docs/obj-import.md word for word.
std::string obj_rule_reference();

/// The material, and in `account` how it was understood, what was guessed and what was ignored. Conserves energy.
transport::Material map_material(const tinyobj::material_t& from, Account& account);

}  // namespace heckbert::import
