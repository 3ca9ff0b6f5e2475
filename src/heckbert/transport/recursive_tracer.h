#pragma once
// The recursive ray tracers. That of Whitted 1980 ("An Improved Illumination Model for Shaded Display") and of the
// lecture: a real tree of rays. Mirrors spawn a reflected ray; every dielectric spawns a reflected and a refracted one,
// weighted by the exact Fresnel k_r and k_t; diffuse surfaces end the branch with direct light, shadow rays included.
// It finds L(D|G)?S*E (Whitted) or LD?S*E (the lecture) and nothing else.
//
// Distribution ray tracing (Cook, Porter and Carpenter 1984, "Distributed Ray Tracing") is the same tree with one more
// kind of branch: rays spread over the glossy lobes, as over the lens and the lamps. It finds LD?(G|S)*E. A light that
// a spread ray can hit is found in two ways, which are weighted against each other lobe by lobe (Veach 1997, 9.2).
//
// The tree may be followed along one branch at a time, drawn by what the branches carry (Cook et al. 1984, 3.2; Arvo
// and Kirk 1990, "Particle Transport and Image Synthesis"): the same on average, without rays that double at every
// glass.
//
// Two things it shows are no light paths and never enter a word: the ambient term (its own buffer), and, in the
// lecture's variant, the ray continued in the mirror direction at a diffuse surface, all of whose light goes to the
// phantom buffer.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

struct RecursiveOptions {
  bool glossy_highlights = true;   ///< shade glossy lobes by the direct light, as a Phong highlight
  bool spread_glossy = false;      ///< rays over glossy lobes: distribution ray tracing
  bool mirror_at_diffuse = false;  ///< the lecture's continued ray, weighted by Material::phantom_reflectance
  bool one_branch = false;         ///< of the rays that leave a surface one is followed, drawn by what it carries
};

void trace_recursively(const World& world, Walk& walk, const Ray& ray, const RecursiveOptions& options);

}  // namespace heckbert::transport
