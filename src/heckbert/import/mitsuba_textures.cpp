#include <heckbert/import/mitsuba_textures.h>

#include <algorithm>

#include <heckbert/import/picture_file.h>
#include <heckbert/import/words.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

using namespace transport;

struct Draft {
  Texture texture;
  bool from_top = false;  ///< v runs downwards
};

std::optional<Draft> read_checkerboard(MitsubaObject& o, TextureUse) {
  Draft out;
  Checkerboard squares;
  squares.first = o.colour("color0", squares.first);
  squares.second = o.colour("color1", squares.second);
  out.texture.source = squares;
  return out;
}

/// Pictures follow the sRGB curve unless they are data, `raw`, or of gamma 1 in old files.
std::optional<Draft> read_bitmap(MitsubaObject& o, TextureUse use) {
  const bool linear = o.flag("raw", use == TextureUse::Data) || o.number("gamma", 0) == 1;
  if (const std::string wrap = o.text("wrap_mode", "repeat"); wrap != "repeat") {
    o.in().ignored(o.place(), o.describe() + ": wrap_mode \"" + wrap + "\" is not read, the picture is repeated");
  }
  o.skip({"filter_type", "max_anisotropy", "cache"});
  const std::filesystem::path path = o.file("filename");
  if (path.empty()) {
    return {};
  }
  try {
    Draft out;
    out.texture.source = read_picture(path, !linear);
    out.from_top = true;
    return out;
  } catch (const ReadError& problem) {
    o.in().error(o.place(), problem.what());
  }
  return {};
}

struct TextureKind {
  std::string_view type, meaning;
  std::optional<Draft> (*read)(MitsubaObject&, TextureUse);
};

constexpr TextureKind kTextures[] = {
    {"bitmap", "a picture, repeated and filtered bilinearly: PNG, JPEG, BMP, TGA, HDR or EXR", read_bitmap},
    {"checkerboard", "squares of two colours", read_checkerboard},
};

/// `to_uv`, or `uscale`, `vscale`, `uoffset`, `voffset` in old files.
void read_placement(MitsubaObject& o, Texture& out) {
  const glm::mat4 to_uv = o.transform("to_uv");
  if (to_uv[0][1] != 0 || to_uv[1][0] != 0) {
    o.in().ignored(o.place(), o.describe() + ": the rotation of \"to_uv\" is not read");
  }
  out.scale = {to_uv[0][0] * o.number("uscale", 1), to_uv[1][1] * o.number("vscale", 1)};
  out.offset = {to_uv[3][0] + o.number("uoffset", 0), to_uv[3][1] + o.number("voffset", 0)};
}

bool is_texture(const XmlNode* node) {
  return node != nullptr && node->tag == "texture";
}

}  // namespace

std::optional<std::uint32_t> read_texture(MitsubaReader& in, const XmlNode& node, TextureUse use) {
  if (const auto known = in.textures.find({&node, use == TextureUse::Data}); known != in.textures.end()) {
    return known->second;
  }
  std::optional<std::uint32_t>& index = in.textures[{&node, use == TextureUse::Data}];
  MitsubaObject object(in, node);
  const auto kind = std::find_if(std::begin(kTextures), std::end(kTextures),
                                 [&](const TextureKind& k) { return k.type == object.type(); });
  if (kind == std::end(kTextures)) {
    std::vector<std::string> known;
    for (const TextureKind& k : kTextures) {
      known.emplace_back(k.type);
    }
    tell_unknown(object, known, "the constant that Mitsuba takes without it is used");
    return {};
  }
  std::optional<Draft> draft = kind->read(object, use);
  if (!draft) {
    return {};
  }
  Texture& texture = draft->texture;
  texture.name = node["id"];
  read_placement(object, texture);
  if (draft->from_top) {
    texture.scale.y = -texture.scale.y;
    texture.offset.y = 1 - texture.offset.y;
  }
  in.imported.scene.textures.push_back(std::move(texture));
  index = static_cast<std::uint32_t>(in.imported.scene.textures.size() - 1);
  return index;
}

ColourOrTexture read_colour_or_texture(MitsubaObject& object, std::string_view name, Rgb otherwise) {
  const XmlNode* node = object.find(name);
  if (!is_texture(node)) {
    return {object.colour(name, otherwise)};
  }
  const auto texture = read_texture(object.in(), *node, TextureUse::Colour);
  return {texture ? Rgb(1) : otherwise, texture};
}

ColourOrTexture read_share(MitsubaObject& object, std::string_view name, Rgb otherwise) {
  const ColourOrTexture said = read_colour_or_texture(object, name, otherwise);
  const Rgb read = said.colour;
  const Rgb limited(std::min(read.r, 1.0f), std::min(read.g, 1.0f), std::min(read.b, 1.0f));
  if (!(limited == read)) {
    object.in().guessed(object.find(name)->place, object.describe() + ": \"" + std::string(name) + "\" " +
                                                      to_text(read) + " is above 1, read as " + to_text(limited));
  }
  return {limited, said.texture};
}

NumberOrTexture read_number_or_texture(MitsubaObject& object, std::string_view name, float otherwise,
                                       const Range& range) {
  const XmlNode* node = object.find(name);
  if (is_texture(node)) {
    const auto texture = read_texture(object.in(), *node, TextureUse::Data);
    return {texture ? 1 : otherwise, texture};
  }
  if (node != nullptr && (node->tag == "rgb" || node->tag == "spectrum")) {
    const Rgb colour = object.colour(name, Rgb(otherwise), range);
    return {(colour.r + colour.g + colour.b) / 3};
  }
  return {object.number(name, otherwise, range)};
}

std::vector<MitsubaPluginFacts> texture_facts() {
  std::vector<MitsubaPluginFacts> out;
  for (const TextureKind& kind : kTextures) {
    out.push_back({"texture", kind.type, kind.meaning});
  }
  return out;
}

}  // namespace heckbert::import
