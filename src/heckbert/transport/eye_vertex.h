#pragma once
// A surface that a walk from the eye came to, as those who join it to walks from the light see it.

#include <heckbert/transport/light_walk.h>

namespace heckbert::transport {

struct EyeVertex {
  const Vertex& vertex;
  glm::vec3 to_eye;  ///< unit, towards the vertex before
  Rgb throughput;
  Rivals rivals;
  taxonomy::WordTrie::Node node = 0;  ///< the word so far, without what happens here
  int scatterings = 0;                ///< before this one

  /// With which a walk that comes from `to_light` would leave this vertex for the one before; per steradian.
  double pdf_to_eye(const Scene& scene, glm::vec3 to_light) const {
    return static_cast<double>(pdf_from_light(scene, vertex.hit, to_light, to_eye));
  }
};

}  // namespace heckbert::transport
