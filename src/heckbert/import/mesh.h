#pragma once
// Small services on meshes that more than one importer needs.

#include <limits>

#include <glm/mat4x4.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::import {

/// Whether the triangle is more than a line or a point, in float arithmetic.
bool has_area(const transport::Mesh& mesh, glm::uvec3 triangle);

/// An axis-aligned box; empty when low is above high.
struct Bounds {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};
};
Bounds bounds_of(const std::vector<transport::Shape>& shapes);

/// Moves positions and normals. A transform that mirrors also reverses the corners, so that the front stays the front.
void transform(transport::Mesh& mesh, const glm::mat4& to_world);

/// Smooth normals: those of the triangles about each position, weighted by their angles there (Thürmer and Wüthrich
/// 1998). Positions that no triangle uses get +z.
void compute_normals(transport::Mesh& mesh);

/// Whether the normals say nothing of the surface: all are the same although some triangle is tilted away from them.
/// Exporters write such placeholders for renderers that compute normals themselves.
bool has_placeholder_normals(const transport::Mesh& mesh);

/// Adds the triangles of `more`. Normals and texture coordinates survive when both have them or `mesh` is empty.
void append(transport::Mesh& mesh, const transport::Mesh& more);

}  // namespace heckbert::import
