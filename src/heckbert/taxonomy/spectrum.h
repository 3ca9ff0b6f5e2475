#pragma once
// How much of a language lies at each length. With weight 1 for some letters and 0 for the others this counts words;
// with the albedos of a furnace (a closed box whose every surface emits 1 and reflects diffusely and specularly) it is
// the energy that the language captures, its generating function cut by length (A2 of docs/anchors.md).

#include <array>
#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// By index(symbol).
using SymbolWeights = std::array<double, kSymbolCount>;

/// Element n is the sum, over the unlabelled words of the language with n scatterings, of the products of their
/// letters' weights, ends included; n = 0 .. max_length. Cost: states times max_length.
std::vector<double> length_spectrum(const Language& language, const SymbolWeights& weights, std::size_t max_length);

}  // namespace heckbert::taxonomy
