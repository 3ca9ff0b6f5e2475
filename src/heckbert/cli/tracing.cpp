#include <heckbert/cli/tracing.h>

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include <heckbert/cli/progress.h>
#include <heckbert/cli/resume.h>
#include <heckbert/record/file.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void write_checkpoint(const Findings& findings, const std::string& file, const Console& console) {
  try {
    record::write_sums(findings.sums(), file);
    console.detail(fmt::format("checkpoint: {}", file));
  } catch (const WriteError& error) {
    console.note(fmt::format("warning: no checkpoint: {}", error.what()));
  }
}

}  // namespace

void trace(const transport::Scene& scene, const TracingJob& job, const Console& console, const std::atomic<bool>& stop,
           Work& work, Findings& findings) {
  const Clock::time_point start = Clock::now();
  Clock::time_point last = start;
  ProgressDisplay display(console.progress(), job.info.samples_per_pixel);
  transport::RenderHooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&](const transport::Progress& progress) {
    work.rays = progress.rays;
    display.show(progress);
  };
  hooks.settled = [&] {
    if (!job.checkpoint || seconds_since(last) < *job.checkpoint) return;
    write_checkpoint(findings, job.keep, console);
    last = Clock::now();  // from the end of writing, so that writing never takes all the time
  };
  transport::RenderSettings settings = job.settings;
  if (findings.begun()) settings.skip = pixels_done(*findings.begun());
  transport::render_tiles(scene, settings, hooks, [&](record::Tile tile) { findings.take(std::move(tile)); });
  work.seconds = seconds_since(start);
}

}  // namespace heckbert::cli
