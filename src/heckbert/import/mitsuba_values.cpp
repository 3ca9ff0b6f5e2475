// Numbers, colours and transforms of Mitsuba's XML.

#include <algorithm>
#include <charconv>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/import/mitsuba_reader.h>
#include <heckbert/import/spectrum_colour.h>
#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

constexpr std::string_view kSeparators = " ,\t\r\n";

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t at = 0; (at = text.find_first_not_of(kSeparators, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end;
  }
  return out;
}

/// #rrggbb, each 0 to 1.
std::optional<Rgb> parse_hex(std::string_view text) {
  unsigned value = 0;
  if (text.size() != 7 || text.front() != '#') {
    return {};
  }
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size()) {
    return {};
  }
  const auto channel = [&](unsigned shift) { return static_cast<float>((value >> shift) & 255u) / 255.0f; };
  return Rgb(channel(16), channel(8), channel(0));
}

std::optional<Rgb> parse_rgb(std::string_view text) {
  if (const auto hex = parse_hex(text)) {
    return hex;
  }
  const auto values = parse_numbers(text);
  if (values && values->size() == 1) {
    return Rgb((*values)[0]);
  }
  if (values && values->size() == 3) {
    return Rgb((*values)[0], (*values)[1], (*values)[2]);
  }
  return {};
}

/// One value, or pairs wavelength:value in nanometres.
std::optional<Rgb> parse_spectrum(std::string_view text) {
  if (text.find(':') == std::string_view::npos) {
    return parse_rgb(text);
  }
  std::vector<SpectrumSample> samples;
  for (const std::string_view pair : split(text)) {
    const std::size_t colon = std::min(pair.find(':'), pair.size());
    const auto wavelength = parse_number(pair.substr(0, colon));
    const auto value = parse_number(pair.substr(std::min(colon + 1, pair.size())));
    if (!wavelength || !value || (!samples.empty() && *wavelength <= samples.back().nanometres)) {
      return {};
    }
    samples.push_back({*wavelength, *value});
  }
  return colour_of(samples);
}

struct Steps {
  MitsubaReader& in;

  float attribute(const XmlNode& node, std::string_view name, float otherwise) {
    const XmlAttribute* found = node.find(name);
    if (found == nullptr) {
      return otherwise;
    }
    const auto value = parse_number(found->value);
    if (!value) {
      in.error(found->place, "expected a number, found \"" + found->value + "\"");
    }
    return value.value_or(otherwise);
  }

  /// From "x", "y", "z", or all three in one attribute.
  glm::vec3 vector(const XmlNode& node, std::string_view together, float otherwise) {
    if (const XmlAttribute* all = node.find(together)) {
      const auto values = parse_numbers(all->value);
      if (values && values->size() == 3) {
        return {(*values)[0], (*values)[1], (*values)[2]};
      }
      if (values && values->size() == 1 && node.tag == "scale") {
        return glm::vec3((*values)[0]);
      }
      in.error(all->place, "expected three numbers, found \"" + all->value + "\"");
      return glm::vec3(1, 2, 3);  // anything that makes no error of its own
    }
    return {attribute(node, "x", otherwise), attribute(node, "y", otherwise), attribute(node, "z", otherwise)};
  }

  glm::mat4 matrix(const XmlNode& node) {
    const XmlAttribute* value = node.find("value");
    const auto numbers = value == nullptr ? std::nullopt : parse_numbers(value->value);
    if (!numbers || (numbers->size() != 16 && numbers->size() != 9)) {
      in.error(value == nullptr ? node.place : value->place, "expected a matrix of 16 or 9 numbers, row by row");
      return glm::mat4(1);
    }
    const int size = numbers->size() == 16 ? 4 : 3;
    glm::mat4 out(1);
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        out[column][row] = (*numbers)[static_cast<std::size_t>(row * size + column)];
      }
    }
    if (out[0][3] != 0 || out[1][3] != 0 || out[2][3] != 0 || out[3][3] != 1) {
      in.error(value->place, "expected 0 0 0 1 in the last row of the matrix");
      return glm::mat4(1);
    }
    return out;
  }

  /// The columns are left, up, towards the target and the origin: Mitsuba's cameras look along +z, with x to the left.
  glm::mat4 look_at(const XmlNode& node) {
    for (const char* name : {"origin", "target"}) {
      if (node.find(name) == nullptr) {
        in.error(node.place, "<lookat> needs the attribute \"" + std::string(name) + "\"");
        return glm::mat4(1);
      }
    }
    const glm::vec3 origin = vector(node, "origin", 0);
    const glm::vec3 direction = vector(node, "target", 0) - origin;
    glm::vec3 up = node.find("up") == nullptr ? glm::vec3(0) : vector(node, "up", 0);
    if (glm::length(glm::cross(up, direction)) == 0) {
      // Mitsuba takes any direction across when there is no "up".
      up = std::abs(direction.x) > std::abs(direction.y) ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    }
    if (glm::length(direction) == 0) {
      in.error(node.place, "the target is where the origin is");
      return glm::mat4(1);
    }
    const glm::vec3 forward = glm::normalize(direction);
    const glm::vec3 left = glm::normalize(glm::cross(up, forward));
    return {glm::vec4(left, 0), glm::vec4(glm::cross(forward, left), 0), glm::vec4(forward, 0), glm::vec4(origin, 1)};
  }

  glm::mat4 rotate(const XmlNode& node) {
    const glm::vec3 axis = vector(node, "value", 0);
    if (node.find("angle") == nullptr || glm::length(axis) == 0) {
      in.error(node.place, "a rotation needs an angle in degrees and an axis: x, y, z");
      return glm::mat4(1);
    }
    return glm::rotate(glm::mat4(1), glm::radians(attribute(node, "angle", 0)), axis);
  }

  glm::mat4 read(const XmlNode& node) {
    if (node.tag == "translate") {
      return glm::translate(glm::mat4(1), vector(node, "value", 0));
    }
    if (node.tag == "scale") {
      return glm::scale(glm::mat4(1), vector(node, "value", 1));
    }
    if (node.tag == "rotate") {
      return rotate(node);
    }
    if (node.tag == "matrix") {
      return matrix(node);
    }
    if (node.tag == "lookat" || node.tag == "look_at") {
      return look_at(node);
    }
    in.error(node.place, "expected translate, scale, rotate, lookat or matrix, found <" + node.tag + ">");
    return glm::mat4(1);
  }
};

}  // namespace

std::optional<float> parse_number(std::string_view text) {
  const std::vector<std::string_view> tokens = split(text);
  if (tokens.size() != 1) {
    return {};
  }
  std::string_view token = tokens.front();
  if (token.starts_with('+')) {
    token.remove_prefix(1);
  }
  float value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  // Too small for a float is zero.
  const bool tiny = error == std::errc::result_out_of_range && token.find("e-") != std::string_view::npos;
  if (end != token.data() + token.size() || (error != std::errc() && !tiny) || !std::isfinite(value)) {
    return {};
  }
  return tiny ? 0.0f : value;
}

std::optional<std::vector<float>> parse_numbers(std::string_view text) {
  std::vector<float> out;
  for (const std::string_view token : split(text)) {
    const auto value = parse_number(token);
    if (!value) {
      return {};
    }
    out.push_back(*value);
  }
  return out;
}

Rgb read_colour(MitsubaReader& in, const XmlNode& node, const Range& range) {
  if (node.tag == "blackbody") {
    const auto scale = node.find("scale") == nullptr ? std::optional(1.0f) : parse_number(node["scale"]);
    std::string_view kelvin = node["temperature"];
    if (kelvin.ends_with('K') || kelvin.ends_with('k')) {
      kelvin.remove_suffix(1);
    }
    const auto temperature = parse_number(kelvin);
    if (!temperature || !(*temperature > 0) || !scale || !(*scale >= 0)) {
      in.error(node.place, "expected <blackbody temperature=\"kelvin\" scale=\"1\"/>");
      return {};
    }
    return *scale * blackbody_colour(*temperature);
  }
  const XmlAttribute* value = node.find("value");
  if (value == nullptr) {
    in.error(node.place, node.find("filename") == nullptr ? "<" + node.tag + "> needs the attribute \"value\""
                                                          : "spectra in files of their own are not read");
    return {};
  }
  const std::optional<Rgb> colour = node.tag == "spectrum" ? parse_spectrum(value->value) : parse_rgb(value->value);
  if (!colour) {
    in.error(value->place, node.tag == "spectrum"
                               ? "expected one number, three numbers or pairs wavelength:value in rising order"
                               : "expected one number, three numbers or #rrggbb");
    return {};
  }
  const auto outside = [&](float x) { return !range.contains(static_cast<double>(x)); };
  if (outside(colour->r) || outside(colour->g) || outside(colour->b)) {
    in.error(value->place, "expected numbers " + range.describe() + ", found " + to_text(*colour));
    return {};
  }
  return node.tag == "srgb" ? linear_of_srgb(*colour) : *colour;
}

glm::mat4 read_transform(MitsubaReader& in, const XmlNode& node) {
  glm::mat4 out(1);
  Steps steps{in};
  for (const XmlNode& step : node.children) {
    out = steps.read(step) * out;
  }
  return out;
}

}  // namespace heckbert::import
