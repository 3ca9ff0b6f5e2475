#pragma once
// Linear light in three channels (Rec. 709 primaries), the only colour type of the project.

#include <algorithm>
#include <cmath>

namespace heckbert {

struct Rgb {
  float r = 0, g = 0, b = 0;

  constexpr Rgb() = default;
  constexpr Rgb(float red, float green, float blue) : r(red), g(green), b(blue) {}
  constexpr explicit Rgb(float grey) : r(grey), g(grey), b(grey) {}

  constexpr Rgb& operator+=(Rgb o) { return *this = {r + o.r, g + o.g, b + o.b}; }
  constexpr Rgb& operator*=(Rgb o) { return *this = {r * o.r, g * o.g, b * o.b}; }
  constexpr Rgb& operator*=(float s) { return *this = {r * s, g * s, b * s}; }
  constexpr bool operator==(const Rgb&) const = default;
};

constexpr Rgb operator+(Rgb a, Rgb b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Rgb operator-(Rgb a, Rgb b) {
  return {a.r - b.r, a.g - b.g, a.b - b.b};
}
constexpr Rgb operator*(Rgb a, Rgb b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
constexpr Rgb operator*(Rgb a, float s) {
  return {a.r * s, a.g * s, a.b * s};
}
constexpr Rgb operator*(float s, Rgb a) {
  return a * s;
}
constexpr Rgb operator/(Rgb a, float s) {
  return a * (1.0f / s);
}

constexpr bool is_black(Rgb c) {
  return c.r == 0 && c.g == 0 && c.b == 0;
}
constexpr float max_channel(Rgb c) {
  return std::max({c.r, c.g, c.b});
}
inline bool is_finite(Rgb c) {
  return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}
/// Relative luminance (ITU-R BT.709).
constexpr float luminance(Rgb c) {
  return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

}  // namespace heckbert
