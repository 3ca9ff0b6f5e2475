#pragma once
// Mitsuba's textures, and parameters that may be a texture instead of a value.

#include <optional>

#include <heckbert/import/mitsuba_reader.h>

namespace heckbert::import {

enum class TextureUse : std::uint8_t { Colour, Data };  ///< data has no sRGB curve: roughness, normals, opacity

/// The texture's index in the scene; it is read once, however often it is used. Nothing when it is not understood,
/// which is told.
std::optional<std::uint32_t> read_texture(MitsubaReader& in, const XmlNode& node, TextureUse use);

/// A parameter that is a constant, or a texture that multiplies one.
struct ColourOrTexture {
  Rgb colour;
  std::optional<std::uint32_t> texture{};
};
ColourOrTexture read_colour_or_texture(MitsubaObject& object, std::string_view name, Rgb otherwise);
/// A share of light: what is above 1 is read as 1, which is told as a guess.
ColourOrTexture read_share(MitsubaObject& object, std::string_view name, Rgb otherwise);

struct NumberOrTexture {
  float number = 0;
  std::optional<std::uint32_t> texture{};
};
NumberOrTexture read_number_or_texture(MitsubaObject& object, std::string_view name, float otherwise,
                                       const Range& range);

/// What is said in the reference about this tag.
std::vector<MitsubaPluginFacts> texture_facts();

}  // namespace heckbert::import
