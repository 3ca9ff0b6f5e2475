#pragma once
// How many samples per pixel fit into a given time: found by rendering a little first.

#include <atomic>

#include <heckbert/transport/render.h>

namespace heckbert::cli {

struct Plan {
  int samples_per_pixel = 1;
  double samples_per_second = 0;  ///< as measured
  double seconds = 0;             ///< what the pilot renders took
};

/// Renders the same view small and then ever larger until it took long enough to tell, a small part of `seconds`.
/// What is left of `seconds` decides the samples per pixel, at least one. Errors: as transport::render.
Plan plan_for(const transport::Scene& scene, const transport::RenderSettings& settings, double seconds,
              const std::atomic<bool>& stop);

}  // namespace heckbert::cli
