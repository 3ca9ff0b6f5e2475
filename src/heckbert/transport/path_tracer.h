#pragma once
// The reference: a path tracer (Kajiya 1986) with next-event estimation, lobe sampling, multiple importance weights
// (Veach and Guibas 1995) and Russian roulette, that names every path it finds.
//
// What is unusual is the care for the classes. At a vertex with several lobes the direction is drawn from their mixture
// and every weight sees the density of the mixture; the path then goes on as *one* lobe, chosen in proportion to what
// each sends along that direction, with that lobe's own value. So each word's buffer converges to that word's integral,
// not merely their sum to the picture's (design decision 2).

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

void trace_path(const World& world, Walk& walk, Ray ray);

}  // namespace heckbert::transport
