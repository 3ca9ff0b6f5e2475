#include <heckbert/transport/scene.h>

#include <glm/common.hpp>

namespace heckbert::transport {

Mesh make_quad(glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v) {
  return {.positions = {corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v},
          .triangles = {{0, 1, 2}, {0, 2, 3}},
          .texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
}

Mesh make_box(glm::vec3 low, glm::vec3 high, bool inward) {
  Mesh box;
  for (unsigned corner = 0; corner < 8; ++corner)
    box.positions.emplace_back((corner & 1u) != 0 ? high.x : low.x, (corner & 2u) != 0 ? high.y : low.y,
                               (corner & 4u) != 0 ? high.z : low.z);
  box.triangles = {{0, 4, 6}, {0, 6, 2},   // x low
                   {1, 3, 7}, {1, 7, 5},   // x high
                   {0, 1, 5}, {0, 5, 4},   // y low
                   {2, 6, 7}, {2, 7, 3},   // y high
                   {0, 2, 3}, {0, 3, 1},   // z low
                   {4, 5, 7}, {4, 7, 6}};  // z high
  if (inward)
    for (glm::uvec3& t : box.triangles) std::swap(t.y, t.z);
  return box;
}

}  // namespace heckbert::transport
