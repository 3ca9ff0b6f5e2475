#pragma once
// What one lobe does at one vertex. All directions are local, the normal along +z on the side of wo, both wo and wi
// pointing away from the surface; so wo.z > 0, wi.z > 0 is reflection and wi.z < 0 transmission. `front` says that wo
// is on the front side of the surface, which tells an interface which of its two media is where.
//
// The letter belongs to the lobe that was evaluated (design decision 2), so there is no whole-material value here: a
// caller that wants the sum adds the lobes and keeps their letters apart.
//
// Each family of lobes has its formulas in a file of its own, lobe_*.h; this one only chooses among them.

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/record/rgb.h>
#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/lobe_specular.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// A Dirac lobe: nothing to evaluate, only to follow.
bool is_delta(const Lobe& lobe);

/// May evaluate() be more than black below the horizon?
bool transmits(const Lobe& lobe);

/// Has it two events, of which following it chooses one?
bool is_branching(const Lobe& lobe);

/// The letter of a lobe without a Dirac. Delta lobes name their events themselves.
taxonomy::Symbol letter(const Lobe& lobe, bool transmitted = false);

/// What a lobe does with radiance that arrives from wi.
struct LobeValue {
  Rgb f;                      ///< f(wo, wi) per steradian, without the cosine; with the compression of radiance
  float pdf_solid_angle = 0;  ///< with which sample_direction picks wi, per steradian
};
/// Black and 0 for delta lobes.
LobeValue value_and_pdf(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi, bool front = true);

inline Rgb evaluate(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi, bool front = true) {
  return value_and_pdf(lobe, wo, wi, front).f;
}
float pdf_solid_angle(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi, bool front = true);

/// A direction drawn by pdf_solid_angle; its z is 0 when the draw falls on the wrong side or the lobe is a delta.
glm::vec3 sample_direction(const Lobe& lobe, glm::vec3 wo, glm::vec3 u, bool front = true);

/// Share of the light that the lobe scatters towards wo, for choosing among lobes; an estimate is enough, but zero only
/// where the lobe is black.
float selection_weight(const Lobe& lobe, glm::vec3 wo);

/// The colour of a lobe that reflects diffusely, black for any other: what the ambient term multiplies.
Rgb diffuse_albedo(const Lobe& lobe);

/// The part of evaluate() that is compression of radiance when light is transmitted, and comes back on the way out:
/// one over the squared relative index for an interface, else 1.
float radiance_compression(const Lobe& lobe, bool front);

/// Multiplies the whole lobe, by a weight or a colour from 0 to 1.
void scale(Lobe& lobe, Rgb factor);

/// Both branches of a delta lobe: reflection, and transmission when there is any.
DeltaBranches delta_branches(const Lobe& lobe, glm::vec3 wo, bool front);

}  // namespace heckbert::transport
