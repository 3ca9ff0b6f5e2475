#pragma once
// What is found out by rendering a little first: how many samples per pixel fit into a given time, and where they are
// needed most.

#include <atomic>
#include <span>

#include <heckbert/taxonomy/language.h>
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

/// Two pilots take together at most this many samples for each one of the render.
inline constexpr double kPilotShare = 0.25;

/// Spends the samples where the classes are noisy, or the picture where there are none: from two pilot renders, which
/// are thrown away, a map is planned (record/sample_map.h) by which pixels repeat fewer samples more or less often. A
/// pixel has about the samples of `settings` on average. Errors: as transport::render.
transport::RenderSettings adapted(const transport::Scene& scene, transport::RenderSettings settings,
                                  std::span<const taxonomy::Language> classes, const std::atomic<bool>& stop);

}  // namespace heckbert::cli
