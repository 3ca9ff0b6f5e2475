#pragma once
// Which bodies a point lies in. A body is what a closed surface encloses (Material::interior): glass in water, smoke
// around both. Where bodies overlap, the one of higher priority is there and hides the others' surfaces (Schmidt and
// Budge 2002, "Simple Nested Dielectrics in Ray Traced Images"); among equals the one entered last, so that bodies that
// are properly nested need no priorities. A walk carries this list along; it is plain data of a few words.

#include <array>
#include <cstdint>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

class Bodies {
 public:
  /// Bodies deeper than this are not entered.
  static constexpr std::size_t kMost = 7;

  /// A ray went through a surface of this material from the given side. Surfaces that enclose nothing change nothing;
  /// so does leaving what was never entered.
  void cross(const Scene& scene, std::uint32_t material, bool from_front);
  /// Is a surface of this material, met from the given side, there to be seen? Not where a body of higher priority
  /// hides it, or where both its sides lie in bodies of its own material.
  bool shows(const Scene& scene, std::uint32_t material, bool from_front) const;
  /// The medium here: the innermost body's, or the scene's outside of all. Null: empty space.
  const Medium* medium(const Scene& scene) const;
  /// Index of refraction in front of a surface of this material: of the innermost other body that has one; else 1.
  float index_in_front(const Scene& scene, std::uint32_t material) const;

 private:
  std::size_t place_of(std::uint32_t material) const;  ///< count_ when absent
  bool hides(const Scene& scene, std::uint32_t body, std::uint32_t material) const;

  std::array<std::uint32_t, kMost> materials_{};  ///< by rising priority, the innermost last
  std::uint32_t count_ = 0;
};

}  // namespace heckbert::transport
