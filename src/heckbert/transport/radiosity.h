#pragma once
// The picture of a radiosity solution: a ray per sample, which shows the light stored where it ends, bounce by bounce,
// as the words L D^n E. With ray-traced mirrors it goes on through mirrors and glass first, L D^n S* E: the second of
// two passes over a solution that knows nothing of mirrors, so that light which a mirror throws onto a wall is in
// neither (Rushmeier and Torrance 1990 discuss it).

#include <heckbert/transport/radiosity_solution.h>
#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// Light is solved for so many bounces past the depth limit, to tell what the limit cuts off.
inline constexpr int kBouncesPastTheLimit = 32;

/// Walks one camera ray, with or without mirrors and panes. Takes a scene without bodies.
void trace_radiosity(const World& world, Walk& walk, Ray ray, const RadiositySolution& solution, bool through_mirrors);

}  // namespace heckbert::transport
