#pragma once
// Which of the techniques that a word allows an algorithm has: in how many ways it joins a walk from the light to one
// from the eye.

#include <cstddef>
#include <cstdint>

#include <heckbert/taxonomy/word.h>

namespace heckbert::transport {

enum class Reach : std::uint8_t {
  Hit,        ///< walks from the eye that run into a light
  NextEvent,  ///< walks from the eye that ask for a light at a surface
  Eye,        ///< both of these
  Shiny,      ///< both of these, but walks end at the first diffuse surface
  Matt,       ///< walks through mirrors to a light, or to the first other surface, where a light is asked for
  Light,      ///< walks from the light that run into the lens or ask for the eye
  Both,       ///< all pairs of walks
  /// Walks through mirrors to a light, or to the first other surface, which a light is asked for and walks from the
  /// light are joined to.
  VirtualLights,
  Merging  ///< the same, but walks from the light must come near, and no light is asked for
};

/// Does it find such words by a walk of so many vertices from the light, joined to one from the eye? Both ends count;
/// `light_vertices` is one of the word's strategies. Vertices that are near each other are not asked about.
bool has_technique(Reach reach, const taxonomy::Word& word, std::size_t light_vertices);

}  // namespace heckbert::transport
