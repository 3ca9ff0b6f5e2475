#include <heckbert/import/spectrum_colour.h>

#include <algorithm>
#include <cmath>

namespace heckbert::import {
namespace {

constexpr double kFirst = 360, kLast = 830;  // nanometres

struct Xyz {
  double x = 0, y = 0, z = 0;
};

/// A bell whose two halves have inverse widths of their own.
double bell(double nanometres, double middle, double left, double right) {
  const double t = (nanometres - middle) * (nanometres < middle ? left : right);
  return std::exp(-0.5 * t * t);
}

Xyz observer(double l) {
  return {0.362 * bell(l, 442.0, 0.0624, 0.0374) + 1.056 * bell(l, 599.8, 0.0264, 0.0323) -
              0.065 * bell(l, 501.1, 0.0490, 0.0382),
          0.821 * bell(l, 568.8, 0.0213, 0.0247) + 0.286 * bell(l, 530.9, 0.0613, 0.0322),
          1.217 * bell(l, 437.0, 0.0845, 0.0278) + 0.681 * bell(l, 459.0, 0.0385, 0.0725)};
}

template <class Spectrum>
Xyz integrate(const Spectrum& spectrum) {
  Xyz sum;
  for (double l = kFirst + 0.5; l < kLast; l += 1) {
    const Xyz seen = observer(l);
    const double value = spectrum(l);
    sum.x += value * seen.x;
    sum.y += value * seen.y;
    sum.z += value * seen.z;
  }
  return sum;
}

struct Linear {
  double r, g, b;
};

Linear to_srgb(const Xyz& c) {
  return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z, -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
          0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

template <class Spectrum>
Rgb colour(const Spectrum& spectrum) {
  static const Linear white = to_srgb(integrate([](double) { return 1.0; }));
  const Linear c = to_srgb(integrate(spectrum));
  const auto channel = [](double value, double of_white) {
    return static_cast<float>(std::max(0.0, value / of_white));
  };
  return {channel(c.r, white.r), channel(c.g, white.g), channel(c.b, white.b)};
}

float linear_of_srgb(float x) {
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

Rgb colour_of(const std::vector<SpectrumSample>& samples) {
  return colour([&](double l) {
    const auto after = std::find_if(samples.begin(), samples.end(),
                                    [&](const SpectrumSample& s) { return static_cast<double>(s.nanometres) >= l; });
    if (after == samples.end() || after == samples.begin()) {
      return 0.0;
    }
    const SpectrumSample& a = *(after - 1);
    const SpectrumSample& b = *after;
    const double t = (l - static_cast<double>(a.nanometres)) / static_cast<double>(b.nanometres - a.nanometres);
    return (1 - t) * static_cast<double>(a.value) + t * static_cast<double>(b.value);
  });
}

Rgb blackbody_colour(float kelvin) {
  constexpr double kPlanck = 6.62607015e-34, kLight = 2.99792458e8, kBoltzmann = 1.380649e-23;
  return colour([&](double nanometres) {
    const double l = nanometres * 1e-9;
    const double per_metre = 2 * kPlanck * kLight * kLight / std::pow(l, 5) /
                             std::expm1(kPlanck * kLight / (l * kBoltzmann * static_cast<double>(kelvin)));
    return per_metre * 1e-9;
  });
}

Rgb linear_of_srgb(Rgb encoded) {
  return {linear_of_srgb(encoded.r), linear_of_srgb(encoded.g), linear_of_srgb(encoded.b)};
}

}  // namespace heckbert::import
