#pragma once
// Spectra as colours, for a renderer that computes with three numbers: the observer of the CIE of 1931 in the closed
// form of Wyman, Sloan and Shirley ("Simple analytic approximations to the CIE XYZ color matching functions", JCGT
// 2(2), 2013, multi-lobe fit), then linear sRGB. White is the spectrum of equal energy: constant spectra are grey.

#include <vector>

#include <heckbert/record/rgb.h>

namespace heckbert::import {

struct SpectrumSample {
  float nanometres = 0, value = 0;
};

/// The colour of a spectrum that runs straight between its samples (rising wavelengths) and is zero outside; a constant
/// 1 from 360 to 830 nm gives 1. What lies outside the colours of sRGB is cut off at zero.
Rgb colour_of(const std::vector<SpectrumSample>& samples);

/// Planck's radiance of a black body, W sr^-1 m^-2 nm^-1.
Rgb blackbody_colour(float kelvin);

/// sRGB's curve undone (IEC 61966-2-1).
Rgb linear_of_srgb(Rgb encoded);

}  // namespace heckbert::import
