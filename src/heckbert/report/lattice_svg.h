#pragma once
// The order of languages as a picture: small languages at the bottom, each joined to those directly above it, the line
// labelled with the shortest word that the upper one has beyond the lower one.

#include <string>

#include <heckbert/taxonomy/lattice.h>

namespace heckbert::report {

/// A complete SVG document that needs nothing else.
std::string lattice_svg(const taxonomy::Lattice& lattice);

}  // namespace heckbert::report
