#pragma once
// With which strategies can a path of this word be found? A path is joined where two neighbouring vertices can both
// choose a direction at will; a mirror, a point light's place and a pinhole's place cannot be met by chance. So write
// each end as place and direction, D where it is spread out and S where it is a Dirac, read G and V as D, and every
// pair DD of neighbours is one strategy of bidirectional path tracing, that with so many vertices from the light. No
// pair: no local sampling ever finds the path. Source: the extended path notation of Veach 1997, chapter 8.

#include <cstddef>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/word.h>

namespace heckbert::taxonomy {

struct Strategy {
  std::size_t light_vertices = 0;  ///< s of the pair (s, t)
  std::size_t eye_vertices = 0;    ///< t
  std::string_view name;           ///< what programs call it: "hit the light", "next event", ...
  bool operator==(const Strategy&) const = default;
};

/// All of them, by light_vertices.
std::vector<Strategy> strategies(const Word& word);

}  // namespace heckbert::taxonomy
