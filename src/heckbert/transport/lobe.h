#pragma once
// What one lobe does at one vertex. All directions are local, the normal along +z on the side of wo, both wo and wi
// pointing away from the surface; so wo.z > 0, wi.z > 0 is reflection and wi.z < 0 transmission.
//
// The letter belongs to the lobe that was evaluated (design decision 2), so there is no whole-material value here: a
// caller that wants the sum adds the lobes and keeps their letters apart.

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/record/rgb.h>
#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// A Dirac lobe: nothing to evaluate, only to follow.
bool is_delta(const Lobe& lobe);

/// The letter of a lobe that reflects light without a Dirac: Dr or Gr. Delta lobes name their events themselves.
taxonomy::Symbol letter(const Lobe& lobe);

/// f(wo, wi) per steradian, without the cosine; black for delta lobes and below the horizon.
Rgb evaluate(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi);

/// Density with which sample_direction picks wi, per steradian; 0 for delta lobes.
float pdf_solid_angle(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi);

/// A direction drawn by pdf_solid_angle; nothing when the draw falls below the horizon or the lobe is a delta.
std::optional<glm::vec3> sample_direction(const Lobe& lobe, glm::vec3 wo, glm::vec2 u);

/// Reflectance towards wo, for choosing among lobes; an estimate is enough, but zero only where the lobe is black.
float selection_weight(const Lobe& lobe, glm::vec3 wo);

/// One branch of a delta lobe: where it goes, and the factor that its radiance takes.
struct DeltaBranch {
  taxonomy::Symbol event = taxonomy::Symbol::Sr;
  glm::vec3 wi{0};
  Rgb weight;
  float radiance_scale = 1;  ///< the part of `weight` that is compression of radiance and comes back on the way out
};

/// Both branches of a delta lobe: reflection, and transmission when there is any. `entering` says that wo is on the
/// front (outer) side. The transmitted weight carries the compression of radiance, (eta_o / eta_i)^2 (Veach 1997, 5.2).
struct DeltaBranches {
  DeltaBranch reflected;
  std::optional<DeltaBranch> transmitted;
};
DeltaBranches delta_branches(const Lobe& lobe, glm::vec3 wo, bool entering);

/// Exact Fresnel reflectance of a dielectric for unpolarised light; `eta` is the index on the far side over the near.
float fresnel_dielectric(float cos_incident, float eta);

}  // namespace heckbert::transport
