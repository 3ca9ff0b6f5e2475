#include <heckbert/import/ply_file.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include <glm/geometric.hpp>

#include <heckbert/import/mesh.h>
#include <heckbert/import/object_reader.h>
#include <heckbert/import/text_file.h>
#include <heckbert/import/words.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

using transport::Mesh;

constexpr std::string_view kBlanks = " \t\r";

enum class Kind : std::uint8_t { Signed, Unsigned, Float };

struct Type {
  Kind kind = Kind::Float;
  std::size_t bytes = 0;
};

std::optional<Type> type_of(std::string_view name) {
  static constexpr struct {
    std::string_view name, alias;
    Type type;
  } kTypes[] = {{"char", "int8", {Kind::Signed, 1}},    {"uchar", "uint8", {Kind::Unsigned, 1}},
                {"short", "int16", {Kind::Signed, 2}},  {"ushort", "uint16", {Kind::Unsigned, 2}},
                {"int", "int32", {Kind::Signed, 4}},    {"uint", "uint32", {Kind::Unsigned, 4}},
                {"float", "float32", {Kind::Float, 4}}, {"double", "float64", {Kind::Float, 8}}};
  for (const auto& row : kTypes) {
    if (name == row.name || name == row.alias) {
      return row.type;
    }
  }
  return {};
}

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count{};  ///< of a list: the type of its length
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties{};

  /// The least number of bytes that one of them takes in the file.
  std::size_t least_bytes(bool text) const {
    std::size_t bytes = 0;
    for (const Property& p : properties) {
      bytes += text ? 2 : p.count ? p.count->bytes : p.type.bytes;
    }
    return bytes;
  }
};

enum class Encoding : std::uint8_t { Text, LittleEndian, BigEndian };

struct Header {
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements;
  std::size_t end = 0;  ///< where the data begins
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::string_view source) : bytes_(bytes), source_(source) {}

  PlyMesh read() {
    read_header();
    at_ = header_.end;
    for (const Element& element : header_.elements) {
      // Also bounds what a damaged header can make us allocate.
      const std::size_t least = element.least_bytes(header_.encoding == Encoding::Text);
      const std::size_t left = bytes_.size() - at_;
      if (least > 0 && element.count > left / least + 1) {
        fail("the file ends early: the header promises " + count(element.count, element.name) + ", and " +
             count(left, "byte") + " are left");
      }
      if (element.properties.empty()) {
        continue;
      }
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        read_other(element);
      }
    }
    finish();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    Diagnostic diagnostic;
    diagnostic.source = source_;
    diagnostic.message = message;
    throw InputError(diagnostic);
  }
  [[noreturn]] void fail_at(std::size_t offset, std::size_t length, const std::string& message) const {
    throw InputError(diagnose(source_, bytes_, offset, length, message));
  }

  // ---- header

  std::vector<std::string_view> words_of(std::string_view line) const {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; (at = line.find_first_not_of(kBlanks, at)) != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
      out.push_back(line.substr(at, end - at));
      at = end;
    }
    return out;
  }

  void read_header() {
    if (!bytes_.starts_with("ply")) {
      fail_at(0, 1, "this is no PLY file: it does not begin with \"ply\"");
    }
    bool has_format = false;
    for (std::size_t at = 0; at < bytes_.size();) {
      const std::size_t end = bytes_.find('\n', at);
      if (end == std::string_view::npos) {
        break;
      }
      const std::string_view line = bytes_.substr(at, end - at);
      const std::vector<std::string_view> words = words_of(line);
      const std::string_view key = words.empty() ? std::string_view() : words.front();
      if (key == "end_header") {
        if (!has_format) {
          fail_at(at, line.size(), "the header says no format");
        }
        header_.end = end + 1;
        return;
      }
      if (key == "format") {
        has_format = true;
        read_format(words, at, line.size());
      } else if (key == "element") {
        read_element(words, at, line.size());
      } else if (key == "property") {
        read_property(words, at, line.size());
      } else if (!key.empty() && key != "ply" && key != "comment" && key != "obj_info") {
        fail_at(at, line.size(), "expected format, element, property, comment or end_header");
      }
      at = end + 1;
    }
    fail("this PLY file ends before its end_header");
  }

  void read_format(const std::vector<std::string_view>& words, std::size_t at, std::size_t length) {
    static constexpr std::pair<std::string_view, Encoding> kFormats[] = {
        {"ascii", Encoding::Text},
        {"binary_little_endian", Encoding::LittleEndian},
        {"binary_big_endian", Encoding::BigEndian}};
    for (const auto& [name, encoding] : kFormats) {
      if (words.size() == 3 && words[1] == name) {
        header_.encoding = encoding;
        return;
      }
    }
    fail_at(at, length, "expected format ascii, binary_little_endian or binary_big_endian, and 1.0");
  }

  void read_element(const std::vector<std::string_view>& words, std::size_t at, std::size_t length) {
    std::size_t number = 0;
    if (words.size() == 3) {
      const auto [end, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), number);
      if (error == std::errc() && end == words[2].data() + words[2].size()) {
        header_.elements.push_back({std::string(words[1]), number});
        return;
      }
    }
    fail_at(at, length, "expected element, a name and a number");
  }

  void read_property(const std::vector<std::string_view>& words, std::size_t at, std::size_t length) {
    const bool list = words.size() == 5 && words[1] == "list";
    const std::optional<Type> type = list ? type_of(words[3]) : words.size() == 3 ? type_of(words[1]) : std::nullopt;
    const std::optional<Type> number = list ? type_of(words[2]) : std::nullopt;
    if (!type || list != number.has_value() || (number && number->kind == Kind::Float) || header_.elements.empty()) {
      fail_at(at, length, "expected property, a type and a name, after an element");
    }
    header_.elements.back().properties.push_back({std::string(words.back()), *type, number});
  }

  // ---- data

  double next(const Type& type, const Element& element, std::size_t index) {
    return header_.encoding == Encoding::Text ? next_token(element, index) : next_binary(type, element, index);
  }

  [[noreturn]] void fail_early(const Element& element, std::size_t index) const {
    fail("the file ends early, in " + element.name + " " + std::to_string(index + 1) + " of " +
         std::to_string(element.count));
  }

  double next_token(const Element& element, std::size_t index) {
    at_ = std::min(bytes_.find_first_not_of(" \t\r\n", at_), bytes_.size());
    const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", at_), bytes_.size());
    std::string_view token = bytes_.substr(at_, end - at_);
    if (token.empty()) {
      fail_early(element, index);
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc() || stop != token.data() + token.size() || !std::isfinite(value)) {
      fail_at(at_, token.size(), "expected a number");
    }
    at_ = end;
    return value;
  }

  double next_binary(const Type& type, const Element& element, std::size_t index) {
    std::array<unsigned char, 8> raw{};
    if (bytes_.size() - at_ < type.bytes) {
      fail_early(element, index);
    }
    std::memcpy(raw.data(), bytes_.data() + at_, type.bytes);
    at_ += type.bytes;
    const bool file_is_little = header_.encoding == Encoding::LittleEndian;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      bits |= std::uint64_t{raw[file_is_little ? i : type.bytes - 1 - i]} << (8 * i);
    }
    if (type.kind == Kind::Float) {
      return type.bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                             : std::bit_cast<double>(bits);
    }
    if (type.kind == Kind::Unsigned) {
      return static_cast<double>(bits);
    }
    const auto unused = static_cast<int>(64 - 8 * type.bytes);
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
  }

  std::size_t list_length(const Property& property, const Element& element, std::size_t index) {
    const double length = next(*property.count, element, index);
    const std::size_t least = header_.encoding == Encoding::Text ? 1 : property.type.bytes;
    if (!(length >= 0) || length > static_cast<double>((bytes_.size() - at_) / least + 1)) {
      fail_early(element, index);
    }
    return static_cast<std::size_t>(length);
  }

  void skip(const Property& property, const Element& element, std::size_t index) {
    const std::size_t values = property.count ? list_length(property, element, index) : 1;
    for (std::size_t i = 0; i < values; ++i) {
      next(property.type, element, index);
    }
  }

  void read_other(const Element& element) {
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        skip(property, element, i);
      }
    }
    out_.notes.push_back("element \"" + element.name + "\" is not read");
  }

  void read_vertices(const Element& element) {
    static constexpr std::array<std::array<std::string_view, 4>, 8> kNames{{{"x"},
                                                                            {"y"},
                                                                            {"z"},
                                                                            {"nx"},
                                                                            {"ny"},
                                                                            {"nz"},
                                                                            {"u", "s", "texture_u", "texture_s"},
                                                                            {"v", "t", "texture_v", "texture_t"}}};
    // For each property the slot that its value goes to, or none.
    std::vector<std::optional<std::size_t>> slots;
    std::array<bool, kNames.size()> present{};
    for (const Property& property : element.properties) {
      const auto row = std::find_if(kNames.begin(), kNames.end(), [&](const auto& names) {
        return !property.count && std::find(names.begin(), names.end(), property.name) != names.end();
      });
      slots.push_back(row == kNames.end() ? std::nullopt
                                          : std::optional(static_cast<std::size_t>(row - kNames.begin())));
      if (slots.back()) {
        present[*slots.back()] = true;
      }
    }
    if (!present[0] || !present[1] || !present[2]) {
      fail("the vertices of this PLY file have no x, y and z");
    }
    const bool has_normals = present[3] && present[4] && present[5];
    const bool has_texcoords = present[6] && present[7];
    std::array<float, kNames.size()> value{};
    for (std::size_t i = 0; i < element.count; ++i) {
      for (std::size_t p = 0; p < slots.size(); ++p) {
        if (slots[p]) {
          value[*slots[p]] = static_cast<float>(next(element.properties[p].type, element, i));
        } else {
          skip(element.properties[p], element, i);
        }
      }
      if (!std::all_of(value.begin(), value.end(), [](float x) { return std::abs(x) <= static_cast<float>(kHuge); })) {
        fail("vertex " + std::to_string(i + 1) + " has a number that is not from -1e+09 to 1e+09");
      }
      Mesh& mesh = out_.mesh;
      mesh.positions.emplace_back(value[0], value[1], value[2]);
      if (has_normals) {
        mesh.normals.emplace_back(value[3], value[4], value[5]);
      }
      if (has_texcoords) {
        mesh.texcoords.emplace_back(value[6], value[7]);
      }
    }
  }

  void read_faces(const Element& element) {
    std::vector<std::uint32_t> corners;
    bool has_corners = false;
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        if (!property.count || (property.name != "vertex_indices" && property.name != "vertex_index")) {
          skip(property, element, i);
          continue;
        }
        has_corners = true;
        read_corners(property, element, i, corners);
        for (std::size_t c = 2; c < corners.size(); ++c) {
          triangles_.emplace_back(corners[0], corners[c - 1], corners[c]);
        }
        short_faces_ += corners.size() < 3 ? 1 : 0;
      }
    }
    if (element.count > 0 && !has_corners) {
      fail("the faces of this PLY file have no vertex_indices");
    }
  }

  void read_corners(const Property& property, const Element& element, std::size_t index,
                    std::vector<std::uint32_t>& corners) {
    corners.clear();
    const std::size_t length = list_length(property, element, index);
    for (std::size_t c = 0; c < length; ++c) {
      const double corner = next(property.type, element, index);
      if (!(corner >= 0 && corner < 4294967295.0)) {
        fail("face " + std::to_string(index + 1) + " has the corner " + to_text(corner) + ", which is no index");
      }
      corners.push_back(static_cast<std::uint32_t>(corner));
    }
  }

  void finish() {
    Mesh& mesh = out_.mesh;
    std::size_t flat = 0;
    for (const glm::uvec3 t : triangles_) {
      if (const std::uint32_t last = std::max({t.x, t.y, t.z}); last >= mesh.positions.size()) {
        fail("there is no vertex " + std::to_string(last) + ": the file has " + std::to_string(mesh.positions.size()) +
             ", counted from 0");
      }
      if (has_area(mesh, t)) {
        mesh.triangles.push_back(t);
      } else {
        ++flat;
      }
    }
    if (flat > 0) {
      out_.notes.push_back(count(flat, "triangle") + " without area");
    }
    if (short_faces_ > 0) {
      out_.notes.push_back(count(short_faces_, "face") + " of less than three corners");
    }
    if (mesh.triangles.empty()) {
      fail("this file has no triangles that have an area");
    }
    normalize_normals();
  }

  void normalize_normals() {
    for (glm::vec3& n : out_.mesh.normals) {
      const float length = glm::length(n);
      if (!(length > 0)) {
        out_.notes.emplace_back("its normals, some of which have no length");
        out_.mesh.normals.clear();
        return;
      }
      n /= length;
    }
  }

  std::string_view bytes_;
  std::string source_;
  Header header_;
  std::size_t at_ = 0;
  PlyMesh out_;
  std::vector<glm::uvec3> triangles_;
  std::size_t short_faces_ = 0;
};

}  // namespace

PlyMesh read_ply_file(const std::filesystem::path& path) {
  return read_ply(read_text_file(path), path.string());
}

PlyMesh read_ply(std::string_view bytes, std::string_view source) {
  return PlyReader(bytes, source).read();
}

}  // namespace heckbert::import
