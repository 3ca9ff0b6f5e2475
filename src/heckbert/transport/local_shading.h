#pragma once
// Local shading, as in fixed-function graphics: the nearest surface is lit by every point, spot and distant light, by
// its diffuse lobes and with the highlight of its glossy ones (Phong 1975, "Illumination for Computer Generated
// Pictures"), as if nothing ever stood between a light and a surface. It finds L(D|G)E of such lights and gives it too
// much energy wherever there should be shadow: the right words with wrong values. Lamps with a surface do not exist for
// it. The ambient term is no light path and goes to its own buffer.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

void shade_locally(const World& world, Walk& walk, Ray ray);

}  // namespace heckbert::transport
