#pragma once
// One render from its settings to what it finds, with checkpoints on the way: the record as it stands, marked partial,
// written in place of the last one every so many seconds. Whatever happens to the program, the last checkpoint can be
// read, and resumed.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include <heckbert/cli/console.h>
#include <heckbert/cli/findings.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {

struct TracingJob {
  transport::RenderSettings settings;
  record::RenderInfo info;             ///< of the record it makes
  std::string resume{};                ///< a file to go on from; empty: none
  std::string keep{};                  ///< where checkpoints go
  std::optional<double> checkpoint{};  ///< seconds; unset: none
};

/// What a render leaves besides what it finds.
struct Work {
  double seconds = 0;
  std::uint64_t rays = 0;
};

/// Traces until it is done or stopped. A checkpoint that cannot be written is told and not an error: the next one may.
/// Errors: WriteError.
void trace(const transport::Scene& scene, const TracingJob& job, const Console& console, const std::atomic<bool>& stop,
           Work& work, Findings& findings);

}  // namespace heckbert::cli
