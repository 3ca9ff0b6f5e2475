#pragma once
// How finely radiosity is solved: radiosity_solution.h.

#include <cstdint>

namespace heckbert::transport {

struct RadiositySettings {
  float longest_edge = 1.0f / 16.0f;  ///< of a patch, over the diagonal of the scene; above 0
  int refinements = 1;                ///< how often patches may be split where light bends
  int rays_per_side = 256;            ///< for form factors, and for direct light; above 0
  bool shooting = false;              ///< by progressive refinement instead of the full matrix
  bool flat = false;                  ///< shown as constant over patches instead of linear
  bool operator==(const RadiositySettings&) const = default;
};

}  // namespace heckbert::transport
