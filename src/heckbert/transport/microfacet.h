#pragma once
// A surface of tiny facets, described by the spread of their normals and by Smith's model of how they hide each other:
// GGX and Beckmann, after Walter et al. 2007 ("Microfacet Models for Refraction through Rough Surfaces"), anisotropic
// after Heitz 2014 ("Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs").
//
// Local directions: the normal along z, x and y along the two widths. Facet normals h have h.z > 0.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// Area of facets with normal h per area of surface and per steradian.
float facet_density(const Microfacets& facets, glm::vec3 h);

/// Smith's Lambda: hidden over visible projected area towards w, either side.
float smith_lambda(const Microfacets& facets, glm::vec3 w);

/// Share of the facets that see both directions. On the same side heights correlate (Heitz 2014, eq. 99); on opposite
/// sides the two are taken as independent (Walter et al. 2007, eq. 23).
float masking(const Microfacets& facets, glm::vec3 wo, glm::vec3 wi);

/// A facet normal for light going to wo, which is above the surface. GGX draws among the facets that wo sees (Heitz
/// 2018, "Sampling the GGX Distribution of Visible Normals"), Beckmann among all (Walter et al. 2007, eq. 28).
glm::vec3 sample_facet(const Microfacets& facets, glm::vec3 wo, glm::vec2 u);

/// Density of sample_facet, per steradian of h.
float pdf_facet(const Microfacets& facets, glm::vec3 wo, glm::vec3 h);

}  // namespace heckbert::transport
