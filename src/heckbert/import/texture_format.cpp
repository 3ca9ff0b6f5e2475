#include <heckbert/import/picture_file.h>
#include <heckbert/import/scene_format.h>

namespace heckbert::import {
namespace {

using namespace transport;

struct TextureDraft {
  std::string name;
  glm::vec2 scale{1}, offset{0};
  std::string file;
  bool srgb = true;
  Checkerboard checkerboard;
};

struct TextureKind {
  std::string name;
  std::string meaning;
  std::vector<Key<TextureDraft>> keys;
  /// Only called when the keys were read without errors.
  std::variant<Image, Checkerboard> (*build)(Reader&, const JsonNode&, const TextureDraft&,
                                             const std::filesystem::path& directory);
};

template <class Member>
Key<TextureDraft> square_key(std::string_view name, Member Checkerboard::*member, std::string_view otherwise) {
  KeyFacts facts{std::string(name), Colour{kUnit}.describe(), std::string(otherwise), "of every other square"};
  return {std::move(facts), [member](Reader& in, const JsonNode& node, TextureDraft& out) {
            Colour{kUnit}.read(in, node, out.checkerboard.*member);
          }};
}

const std::vector<TextureKind>& texture_kinds() {
  using D = TextureDraft;
  static const std::vector<TextureKind> kinds{
      {"image",
       "A picture, filtered bilinearly and repeated: PNG, JPEG, BMP, TGA, Radiance HDR or OpenEXR.",
       {key("file", Text{}, &D::file, kRequired, "relative to the scene"),
        key("srgb", Flag{}, &D::srgb, "true",
            "the file has sRGB colours; false for roughness, normals and other data. HDR and EXR are linear always")},
       [](Reader& in, const JsonNode& node, const TextureDraft& draft,
          const std::filesystem::path& directory) -> std::variant<Image, Checkerboard> {
         try {
           return read_picture(directory / draft.file, draft.srgb);
         } catch (const ReadError& problem) {
           in.error(*node.find("file"), problem.what());
           return Checkerboard{};
         }
       }},
      {"checkerboard",
       "Squares of half a unit of u and v.",
       {square_key("first", &Checkerboard::first, "0.4"), square_key("second", &Checkerboard::second, "0.2")},
       [](Reader&, const JsonNode&, const TextureDraft& draft,
          const std::filesystem::path&) -> std::variant<Image, Checkerboard> { return draft.checkerboard; }}};
  return kinds;
}

const Choice& texture_types() {
  static const Choice types = [] {
    Choice choice;
    for (const TextureKind& kind : texture_kinds()) {
      choice.words.push_back(kind.name);
    }
    return choice;
  }();
  return types;
}

const std::vector<Key<TextureDraft>>& common_keys() {
  using D = TextureDraft;
  static const std::vector<Key<D>> keys{
      type_key<D>(texture_types(), "the kind of texture"),
      key("name", Text{}, &D::name, kRequired, "what materials call it"),
      key("scale", Custom<glm::vec2>{"[u, v]", read_pair}, &D::scale, "[1, 1]",
          "the texture coordinates are multiplied by it: how often it repeats"),
      key("offset", Custom<glm::vec2>{"[u, v]", read_pair}, &D::offset, "[0, 0]", "and this is added to them")};
  return keys;
}

}  // namespace

void read_pair(Reader& in, const JsonNode& node, glm::vec2& out) {
  if (node.kind != JsonNode::Kind::List || node.items.size() != 2) {
    in.error_expected(node, "[u, v]");
    return;
  }
  for (int i = 0; i < 2; ++i) {
    Number{kCoordinate}.read(in, node.items[static_cast<std::size_t>(i)], out[i]);
  }
}

Texture read_texture(Reader& in, const JsonNode& node, const std::filesystem::path& directory) {
  Texture texture;
  const auto type = read_type(in, node, "texture", texture_types());
  if (!type) {
    return texture;
  }
  const TextureKind& kind = texture_kinds()[*type];
  TextureDraft draft;
  std::vector<BoundKey> keys;
  bind(common_keys(), draft, keys);
  bind(kind.keys, draft, keys);
  const std::size_t errors_before = in.error_count();
  read_object(in, node, "texture of type " + kind.name, keys);
  texture.name = draft.name;
  texture.scale = draft.scale;
  texture.offset = draft.offset;
  if (in.error_count() == errors_before) {
    texture.source = kind.build(in, node, draft, directory);
  }
  return texture;
}

std::vector<ObjectFacts> texture_format() {
  std::vector<ObjectFacts> out;
  for (const TextureKind& kind : texture_kinds()) {
    out.push_back(facts_of("texture of type " + kind.name, kind.meaning, common_keys()));
    for (const Key<TextureDraft>& k : kind.keys) {
      out.back().keys.push_back(k.facts);
    }
  }
  return out;
}

}  // namespace heckbert::import
