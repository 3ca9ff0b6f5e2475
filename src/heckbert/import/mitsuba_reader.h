#pragma once
// What the readers of Mitsuba's plugins have in common: the document, what is wrong with it, what is told about it, and
// the parameters of one object, each of which is either asked for or told to be ignored.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <heckbert/import/import.h>
#include <heckbert/import/mitsuba_document.h>
#include <heckbert/import/object_reader.h>

namespace heckbert::import {

/// The state of one import.
struct MitsubaReader {
  const XmlDocument& document;
  Imported imported{};
  std::vector<Diagnostic> errors{};
  std::map<std::string, const XmlNode*, std::less<>> objects{};  ///< by id
  /// By node, and by whether it is data: what has been read already; without an index when it was not understood.
  std::map<std::pair<const XmlNode*, bool>, std::optional<std::uint32_t>> textures{};
  std::map<const XmlNode*, std::uint32_t> materials{};    ///< by bsdf: index into the scene's, without emission
  std::map<const XmlNode*, std::uint32_t> groups{};       ///< by shapegroup: index into the scene's
  std::map<const XmlNode*, transport::Material> bsdfs{};  ///< what read_bsdf has made of each
  std::vector<const XmlNode*> one_sided{};                ///< bsdfs that are black from behind in Mitsuba
  std::vector<const XmlNode*> open{};                     ///< objects being read, the outermost first

  explicit MitsubaReader(const XmlDocument& of);

  void error(const XmlPlace& place, std::string message, std::string suggestion = {});
  void adopt(const std::vector<Diagnostic>& diagnostics);
  /// Sentences of the account, each with file and line in front.
  void understood(const XmlPlace& place, const std::string& what);
  void guessed(const XmlPlace& place, const std::string& what);
  void ignored(const XmlPlace& place, const std::string& what);

  /// The object that <ref id="..."/> means. Errors: told, with the nearest id; null then, and when it is being read.
  const XmlNode* resolve(const XmlNode& ref);
};

/// An object of the scene (<bsdf type="diffuse">...) while it is read. What nobody has asked for when it is destroyed
/// is told as ignored.
class MitsubaObject {
 public:
  MitsubaObject(MitsubaReader& in, const XmlNode& node);
  ~MitsubaObject();
  MitsubaObject(const MitsubaObject&) = delete;
  MitsubaObject& operator=(const MitsubaObject&) = delete;

  const std::string& type() const { return type_; }
  const XmlPlace& place() const { return node_.place; }
  /// "bsdf \"diffuse\""
  std::string describe() const;
  MitsubaReader& in() const { return in_; }

  /// Whether the parameter is there; does not count as asking for it.
  bool has(std::string_view name) const { return peek(name) != nullptr; }

  /// Values, or `otherwise` when they are absent or wrong (which is told). A parameter of another kind is an error.
  float number(std::string_view name, float otherwise, const Range& range = kCoordinate);
  int integer(std::string_view name, int otherwise);
  bool flag(std::string_view name, bool otherwise);
  std::string text(std::string_view name, std::string_view otherwise = {});
  glm::vec3 vector(std::string_view name, glm::vec3 otherwise);
  glm::mat4 transform(std::string_view name);
  Rgb colour(std::string_view name, Rgb otherwise, const Range& range = kNotNegative);
  /// A file that exists; empty when absent or not there, which is an error.
  std::filesystem::path file(std::string_view name);

  /// The node of a parameter or a named nested object, which counts as asking for it; null when absent.
  const XmlNode* find(std::string_view name);
  /// Nested objects of a tag ("bsdf", "emitter", ...), references resolved, whatever their names.
  std::vector<const XmlNode*> nested(std::string_view tag);
  /// Asks for parameters that say nothing about light, such as the file format of the picture.
  void skip(std::initializer_list<std::string_view> names);
  /// As skip, for all.
  void skip_all();

 private:
  const XmlNode* peek(std::string_view name) const;
  const XmlNode* take(std::string_view name, std::initializer_list<std::string_view> tags);
  void wrong(const XmlNode& node, std::string_view expected);

  MitsubaReader& in_;
  const XmlNode& node_;
  std::string type_;
  std::set<const XmlNode*> asked_;
  std::set<std::string, std::less<>> names_;  ///< all names asked for, for suggestions
};

// ---- values -------------------------------------------------------------------------------------------------------

/// One number. Nothing when the text is anything else.
std::optional<float> parse_number(std::string_view text);
/// Numbers separated by commas or blanks.
std::optional<std::vector<float>> parse_numbers(std::string_view text);

/// A colour node: rgb, srgb, spectrum, blackbody, float. Wrong ones are told and black.
Rgb read_colour(MitsubaReader& in, const XmlNode& node, const Range& range);
/// A <transform>, its steps applied in the order of the text.
glm::mat4 read_transform(MitsubaReader& in, const XmlNode& node);

// ---- plugins ------------------------------------------------------------------------------------------------------

/// A plugin in docs/mitsuba-import.md.
struct MitsubaPluginFacts {
  std::string_view tag, type, meaning;
};

/// Tells that the plugin is unknown, with the nearest known one, and what happens instead.
void tell_unknown(MitsubaObject& object, const std::vector<std::string>& known, const std::string& instead);

/// The reference tables of docs/mitsuba-import.md: plugins and what they are read as.
std::string mitsuba_plugin_reference();

}  // namespace heckbert::import
