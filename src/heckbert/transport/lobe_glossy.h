#pragma once
// Lobes that spread light around the mirror direction: letter Gr. Directions as in lobe.h, both above the surface.

#include <glm/vec3.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// F D G / (4 cos cos) (Walter et al. 2007, eq. 20). Light that would hit a second facet is lost.
Rgb evaluate_lobe(const MicrofacetReflection& lobe, glm::vec3 wo, glm::vec3 wi, bool);
float pdf_of_lobe(const MicrofacetReflection& lobe, glm::vec3 wo, glm::vec3 wi, bool);
/// May point below the surface.
glm::vec3 sample_lobe(const MicrofacetReflection& lobe, glm::vec3 wo, glm::vec3 u, bool);

Rgb evaluate_lobe(const Phong& lobe, glm::vec3 wo, glm::vec3 wi, bool);
float pdf_of_lobe(const Phong& lobe, glm::vec3 wo, glm::vec3 wi, bool);
/// May point below the surface.
glm::vec3 sample_lobe(const Phong& lobe, glm::vec3 wo, glm::vec3 u, bool);

}  // namespace heckbert::transport
