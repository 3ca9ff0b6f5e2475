#pragma once
// Vertex connection and merging (Georgiev, Krivanek, Davidovic and Slusallek 2012, "Light Transport Simulation with
// Vertex Connection and Merging"; Hachisuka, Pantaleoni and Jensen 2012, "A Path Space Extension for Robust Light
// Transport Simulation"): bidirectional path tracing with one more family of techniques. Where a vertex of a walk from
// the light lies within a radius r of a vertex of the walk from the eye, the two are taken for one. The light's walks
// of all pixels are there to merge with, n of them, so that this finds what no two walks can be joined to: a caustic in
// a mirror, lit by a point (LSDSE).
//
// Weights. To merge at x_m both walks must come there, the one from the light to within r of the other's end. By the
// names of light_walk.h its density is that of joined walks, times the chance of coming near, times the number of
// walks:
//
//     q_m = p_(m+1) p<-(x_m) e = p_m p->(x_m) e,    e = pi r^2 n
//
// (e is eta of Georgiev 2012, "Implementing Vertex Connection and Merging", equation 20). Since q_(s-1) / p_s =
// p<-(x_(s-1)) e, merging at x_(s-1) counts e^2 in A_s where being joined to x_(s-2) counts `near`. So walks add e^2 to
// `near` at every vertex, and all else of the recursion, and of the weights of joined walks, stays as it is. An event
// of a Dirac, at which nothing can be merged, drops `near`, and e^2 with it.
//
// Against merging at x_m the techniques with fewer vertices from the light, and this one itself, have squared ratios
// that add up to (near + pdf<-^2 far) / e^2; those with more, and itself, from the other end likewise.
//
// Nothing is merged at particles of media: that takes photons in space (Jarosz, Nowrouzezahrai, Sadeghi and Jensen
// 2011). There walks add no e^2, and what only merging could find is not found: LSVSE, of a point seen by a pinhole.
//
// The radius shrinks from pass to pass (pass.cpp), so that the blur goes to zero.

#include <heckbert/transport/eye_vertex.h>

namespace heckbert::transport {

/// The weight of merging where a walk from the light and one from the eye both end. They would go on along each other
/// with these densities per steradian. Takes: `merging`, which is e, above 0.
constexpr double weight_of_merging(double merging, const Rivals& light, double pdf_to_light, const Rivals& eye,
                                   double pdf_to_eye) {
  return 1 / ((light.sum(1, pdf_to_light) + eye.sum(1, pdf_to_eye)) / squared(merging) - 1);  // itself is in both
}

/// Merges a surface that a walk from the eye came to with the photons near it. Takes world.photons.
void merge(const World& world, Walk& walk, const EyeVertex& at);

}  // namespace heckbert::transport
