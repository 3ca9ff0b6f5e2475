#pragma once
// Errors planted on purpose, to see whether whoever compares algorithms finds them. Not installed, and no flag or
// setting leads here: a test plants one, makes its renders, and takes it out again. Every Stage made in between has it,
// and it shows where gather_direct_light is used: in the path tracer and its kin, not in joins of walks from both ends.
// Without one, next-event estimation compares a byte (docs/decisions/2026-11-28-verdicts.md).

#include <cstdint>

namespace heckbert::transport {

enum class Fault : std::uint8_t {
  None,
  HalvedLobe,        ///< glossy lobes send half of the light that next-event estimation asks them for
  DroppedWeight,     ///< next-event estimation forgets its multiple importance weight
  MissingCosine,     ///< of the surface, in next-event estimation
  WrongLightDensity  ///< the first area light is drawn with twice the density that it says
};

/// The fault of all stages made from now on. Call while nothing is rendered.
void plant(Fault fault);
Fault planted();

}  // namespace heckbert::transport
