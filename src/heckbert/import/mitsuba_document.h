#pragma once
// A Mitsuba scene file as a tree in which everything knows its place: included files spliced in, $parameters replaced
// by their defaults, names brought to one spelling. pugixml reads the XML and is seen in no other file.
//
// Versions before 2 write `toWorld` and `intIOR`, later ones `to_world` and `int_ior`; the tree has the later spelling.

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/error.h>

namespace heckbert::import {

struct XmlSource {
  std::string name;  ///< as in messages
  std::string text;
};

/// Some characters of a file.
struct XmlPlace {
  const XmlSource* source = nullptr;
  std::size_t offset = 0, length = 1;  ///< in bytes
};

Diagnostic diagnose(const XmlPlace& place, std::string message, std::string suggestion = {});
/// "scene.xml:12"
std::string to_text(const XmlPlace& place);

struct XmlAttribute {
  std::string name;
  std::string value;  ///< parameters replaced
  XmlPlace place;     ///< of the value
};

struct XmlNode {
  std::string tag;
  XmlPlace place;  ///< of the tag
  std::vector<XmlAttribute> attributes;
  std::vector<XmlNode> children;

  const XmlAttribute* find(std::string_view attribute) const;
  /// The attribute's value, or nothing.
  std::string_view operator[](std::string_view attribute) const;
};

struct XmlDocument {
  std::deque<XmlSource> sources;               ///< the file, then what it includes
  XmlNode root;                                ///< <scene>
  std::vector<std::filesystem::path> folders;  ///< where files are looked for, in this order

  /// The first of the folders that has the file; else its place in the first one.
  std::filesystem::path find_file(std::string_view name) const;
};

/// Reads the file and what it includes. Errors: ReadError when the file cannot be read; InputError with all errors of
/// the text: XML that is none, includes that are missing or circular, parameters without a default.
XmlDocument read_mitsuba_document(const std::filesystem::path& path);

/// "toWorld" to "to_world", "intIOR" to "int_ior".
std::string snake_case(std::string_view name);

}  // namespace heckbert::import
