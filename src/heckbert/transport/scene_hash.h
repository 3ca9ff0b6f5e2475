#pragma once
// Which scene a record belongs to: records of different machines are added up only when their scenes are the same,
// wherever the files lay.

#include <cstdint>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// Equal for scenes with the same contents; scenes that differ in anything that can show in a picture or a word share
/// a value once in 2^64. The scene's own name, its title and its defaults do not count. Cost: about a nanosecond per
/// number in the scene.
std::uint64_t hash_of(const Scene& scene);

}  // namespace heckbert::transport
