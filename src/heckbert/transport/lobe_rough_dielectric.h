#pragma once
// Rough glass: facets that reflect or refract (Walter et al. 2007, eq. 20 and 21). Letters Gr and Gt. Reflection and
// transmission share one lobe because they share the facets, and energy that does not go one way goes the other.

#include <glm/vec3.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// Transmission carries the compression of radiance, one over the squared relative index, like smooth glass.
Rgb evaluate_lobe(const RoughDielectric& lobe, glm::vec3 wo, glm::vec3 wi, bool front);
float pdf_of_lobe(const RoughDielectric& lobe, glm::vec3 wo, glm::vec3 wi, bool front);
/// u.z chooses between reflection and transmission, by their tinted Fresnel terms. May point to the wrong side.
glm::vec3 sample_lobe(const RoughDielectric& lobe, glm::vec3 wo, glm::vec3 u, bool front);

}  // namespace heckbert::transport
