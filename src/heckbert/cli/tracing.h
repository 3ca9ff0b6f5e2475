#pragma once
// One render from its settings to its sums: what was there before, checkpoints, and the other processes it is shared
// with.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include <heckbert/cli/console.h>
#include <heckbert/cli/ranks.h>
#include <heckbert/record/sums.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {

struct TracingJob {
  transport::RenderSettings settings;
  record::RenderInfo info;             ///< of the record it makes
  std::string resume{};                ///< a file to go on from; empty: none
  std::string keep{};                  ///< where checkpoints go
  std::optional<double> checkpoint{};  ///< seconds; unset: none
};

/// What a render leaves besides its sums.
struct Work {
  double seconds = 0;
  std::uint64_t rays = 0;
};

/// Traces until it is done or stopped. Errors: ReadError for what cannot be resumed. A checkpoint that cannot be
/// written is told and not an error: the next one may.
record::Sums trace(const transport::Scene& scene, TracingJob job, const Console& console, const std::atomic<bool>& stop,
                   Work& work);

/// "room.paths.exr.part-3-of-8"
std::string name_of_part(const std::string& output, const record::Part& part);

/// The sums of all ranks at rank 0, and nothing at the others.
std::optional<record::Sums> reduce(const Ranks& ranks, record::Sums sums);

}  // namespace heckbert::cli
