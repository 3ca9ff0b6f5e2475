#pragma once
// The reference: a path tracer (Kajiya 1986) with next-event estimation, lobe sampling, multiple importance weights
// (Veach and Guibas 1995, the power heuristic) and Russian roulette, that names every path it finds. Also its two
// halves, each an algorithm with words of its own: running into lights alone, which sees none that is a point, and
// next-event estimation alone, which sees no lamp in a mirror.
//
// What is unusual is the care for the classes. At a vertex with several lobes the direction is drawn from their mixture
// and every weight sees the density of the mixture; the path then goes on as *one* lobe, chosen in proportion to what
// each sends along that direction, with that lobe's own value. So each word's buffer converges to that word's integral,
// not merely their sum to the picture's (design decision 2).

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// How lights may be found; at least one of the two. Where both find a path, each is weighted.
struct PathTechniques {
  bool hits = true;        ///< by running into them
  bool next_event = true;  ///< by a shadow ray from every vertex
};

void trace_path(const World& world, Walk& walk, Ray ray, PathTechniques techniques = {});

}  // namespace heckbert::transport
