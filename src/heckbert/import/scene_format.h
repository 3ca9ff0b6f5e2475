#pragma once
// The native scene format, object by object. Each part lists its keys in one table (see object_reader.h);
// scene_format() collects the tables for the reference in docs/scene-format.md.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <heckbert/import/import.h>
#include <heckbert/import/object_reader.h>

namespace heckbert::import {

/// One object of the format, as the reference shows it.
struct ObjectFacts {
  std::string name;     ///< "camera", "shape of type quad"
  std::string meaning;  ///< one sentence
  std::vector<KeyFacts> keys;
};

template <class T>
ObjectFacts facts_of(std::string name, std::string meaning, const std::vector<Key<T>>& keys) {
  ObjectFacts facts{std::move(name), std::move(meaning), {}};
  for (const Key<T>& k : keys) {
    facts.keys.push_back(k.facts);
  }
  return facts;
}

/// Every object of the format, in the order of the reference.
std::vector<ObjectFacts> scene_format();
/// The reference as Markdown; stands in docs/scene-format.md word for word.
std::string scene_format_reference();

/// Things that shapes and instances refer to by name.
struct Names {
  std::string what;  ///< "material", "group"
  std::vector<std::string> names;

  /// Adds a name; one that is there already is an error at `node`.
  void add(Reader& in, const JsonNode& node, const std::string& name);
  std::optional<std::uint32_t> find(Reader& in, const JsonNode* node) const;
};

transport::Material read_material(Reader& in, const JsonNode& node, const Names& media, const Names& textures);
/// Texture coordinates, [u, v].
void read_pair(Reader& in, const JsonNode& node, glm::vec2& out);

/// Relative file names resolve against `directory`.
transport::Texture read_texture(Reader& in, const JsonNode& node, const std::filesystem::path& directory);
std::vector<ObjectFacts> texture_format();

/// "Lambert 0.7, mirror 0.2", for accounts.
std::string describe(const transport::Material& material);
std::vector<ObjectFacts> material_format();

/// Affine; the first step of the list acts first.
glm::mat4 read_transform(Reader& in, const JsonNode& node);
/// Does it move, turn, mirror and scale evenly, and no more?
bool is_similarity(const glm::mat4& transform);
std::vector<ObjectFacts> transform_format();

/// Nothing when the shape has errors. Relative file names resolve against `directory`.
std::optional<transport::Shape> read_shape(Reader& in, const JsonNode& node, const Names& materials,
                                           const std::filesystem::path& directory, Account& account);
std::vector<ObjectFacts> shape_format();

}  // namespace heckbert::import
