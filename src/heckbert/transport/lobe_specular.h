#pragma once
// Dirac lobes: ideal mirrors and panes, which send light into one or two directions and no other. Letters Sr and St.

#include <optional>

#include <glm/vec3.hpp>

#include <heckbert/record/rgb.h>
#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// One branch of a delta lobe: where it goes, and the factor that its radiance takes.
struct DeltaBranch {
  taxonomy::Symbol event = taxonomy::Symbol::Sr;
  glm::vec3 wi{0};
  Rgb weight;
  float radiance_scale = 1;  ///< the part of `weight` that is compression of radiance and comes back on the way out
};

struct DeltaBranches {
  DeltaBranch reflected;
  std::optional<DeltaBranch> transmitted;
};

/// wo as an ideal mirror sends it on.
inline glm::vec3 mirrored(glm::vec3 wo) {
  return {-wo.x, -wo.y, wo.z};
}

DeltaBranches branches_of(const Mirror& lobe, glm::vec3 wo);

/// Snell's law; the transmitted weight carries the compression of radiance, (eta_o / eta_i)^2 (Veach 1997, 5.2).
DeltaBranches branches_of(const Dielectric& lobe, glm::vec3 wo, bool front);

/// With R for one face and T = 1 - R, the sheet reflects R + T^2 R + T^2 R^3 + ... = 2R / (1 + R).
DeltaBranches branches_of(const ThinDielectric& lobe, glm::vec3 wo);

}  // namespace heckbert::transport
