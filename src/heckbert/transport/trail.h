#pragma once
// Where a walk went. Nobody wants to know while a picture is made; paths that are traced again to be shown
// (retrace.h) are followed vertex by vertex.

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include <heckbert/record/rgb.h>

namespace heckbert::transport {

struct TrailVertex {
  glm::vec3 position;
  Rgb throughput;             ///< of the way from the eye up to here, before what happens here
  bool is_direction = false;  ///< infinitely far away: `position` is the direction towards it, unit
};

struct Trail {
  std::vector<TrailVertex> vertices;               ///< of the branch that is being walked, from the eye
  std::vector<std::vector<TrailVertex>> of_found;  ///< by number in Walk::found: from the eye, the light last

  void arrive(int depth, const TrailVertex& vertex) {
    vertices.resize(static_cast<std::size_t>(depth));
    vertices.push_back(vertex);
  }
};

}  // namespace heckbert::transport
