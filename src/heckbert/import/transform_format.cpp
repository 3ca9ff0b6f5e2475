#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/import/scene_format.h>

namespace heckbert::import {
namespace {

struct Rotation {
  glm::vec3 axis{0};
  float degrees = 0;
};

const std::vector<Key<Rotation>>& rotation_keys() {
  static const std::vector<Key<Rotation>> keys{
      key("axis", Vector{}, &Rotation::axis, kRequired, "not zero; need not have length 1"),
      key("degrees", Number{{-36000, 36000}}, &Rotation::degrees, kRequired,
          "counter-clockwise when the axis points at you")};
  return keys;
}

struct Step {
  glm::mat4 matrix{1};
};

void read_translate(Reader& in, const JsonNode& node, glm::mat4& out) {
  glm::vec3 by(0);
  Vector::read(in, node, by);
  out = glm::translate(glm::mat4(1), by);
}

void read_scale(Reader& in, const JsonNode& node, glm::mat4& out) {
  glm::vec3 by(1);
  if (node.kind == JsonNode::Kind::Number) {
    read_number(in, node, kCoordinate, "number other than 0", by.x);
    by = glm::vec3(by.x);
  } else {
    Vector::read(in, node, by);
  }
  if (by.x == 0 || by.y == 0 || by.z == 0) {
    in.error(node, "a scale of 0 flattens the shape");
    return;
  }
  out = glm::scale(glm::mat4(1), by);
}

void read_rotate(Reader& in, const JsonNode& node, glm::mat4& out) {
  Rotation rotation;
  read_object(in, node, "rotation", rotation_keys(), rotation);
  if (const JsonNode* axis = node.find("axis"); axis != nullptr && rotation.axis == glm::vec3(0)) {
    in.error(*axis, "the axis of a rotation must not be zero");
  } else if (axis != nullptr) {
    out = glm::rotate(glm::mat4(1), glm::radians(rotation.degrees), glm::normalize(rotation.axis));
  }
}

void read_matrix(Reader& in, const JsonNode& node, glm::mat4& out) {
  const std::string what = "a list of four rows of four numbers";
  if (node.kind != JsonNode::Kind::List || node.items.size() != 4) {
    in.error_expected(node, what);
    return;
  }
  glm::mat4 matrix(1);
  for (int row = 0; row < 4; ++row) {
    const JsonNode& r = node.items[static_cast<std::size_t>(row)];
    if (r.kind != JsonNode::Kind::List || r.items.size() != 4) {
      in.error_expected(r, "a row of four numbers");
      return;
    }
    for (int column = 0; column < 4; ++column) {
      read_number(in, r.items[static_cast<std::size_t>(column)], kCoordinate, "number " + kCoordinate.describe(),
                  matrix[column][row]);
    }
  }
  if (glm::vec4(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]) != glm::vec4(0, 0, 0, 1)) {
    in.error(node.items[3], "expected 0 0 0 1 in the last row: only affine transforms are read");
  } else if (const float volume = glm::determinant(glm::mat3(matrix)); volume == 0 || !std::isfinite(volume)) {
    in.error(node, "this matrix cannot be inverted");
  }
  out = matrix;
}

const std::vector<Key<Step>>& step_keys() {
  using Rule = Custom<glm::mat4>;
  static const std::vector<Key<Step>> keys{
      key("translate", Rule{Vector::describe(), read_translate}, &Step::matrix, "", "moves by a vector"),
      key("scale", Rule{"number other than 0, or [x, y, z]", read_scale}, &Step::matrix, "", "scales about the origin"),
      key("rotate", Rule{"a rotation", read_rotate}, &Step::matrix, "", "turns about an axis through the origin"),
      key("matrix", Rule{"four rows of four numbers", read_matrix}, &Step::matrix, "",
          "any affine matrix, acting on columns; the last row is 0 0 0 1")};
  return keys;
}

}  // namespace

glm::mat4 read_transform(Reader& in, const JsonNode& node) {
  glm::mat4 out(1);
  read_list(in, node, "a list of transform steps", [&](const JsonNode& item) {
    Step step;
    read_object(in, item, "transform step", step_keys(), step);
    if (item.kind == JsonNode::Kind::Object && item.keys.size() != 1) {
      in.error(item, "a transform step has exactly one key, found " + std::to_string(item.keys.size()));
    }
    out = step.matrix * out;
  });
  return out;
}

bool is_similarity(const glm::mat4& transform) {
  const glm::mat3 linear(transform);
  const float scale = glm::length(linear[0]);
  const glm::mat3 rest = glm::transpose(linear) * linear / (scale * scale) - glm::mat3(1);
  for (int i = 0; i < 9; ++i) {
    if (std::abs(rest[i / 3][i % 3]) > 1e-4f) {
      return false;
    }
  }
  return true;
}

std::vector<ObjectFacts> transform_format() {
  return {facts_of("transform step",
                   "One step of a `transform` list; exactly one of these keys. The first step of the "
                   "list acts first.",
                   step_keys()),
          facts_of("rotation", "The value of `rotate`.", rotation_keys())};
}

}  // namespace heckbert::import
