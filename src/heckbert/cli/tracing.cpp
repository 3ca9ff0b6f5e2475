#include <heckbert/cli/tracing.h>

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include <heckbert/cli/collector.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/progress.h>
#include <heckbert/cli/resume.h>
#include <heckbert/record/file.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {

record::Sums trace(const transport::Scene& scene, TracingJob job, const Console& console, const std::atomic<bool>& stop,
                   Work& work) {
  record::Sums begun{job.info, record::added(job.info.window, {})};
  if (!job.resume.empty()) {
    begun = resumed(job.resume, job.info);
    job.settings.skip = pixels_done(begun);
    begun.info = job.info;
  }
  const auto start = std::chrono::steady_clock::now();
  Collector collector(std::move(begun), job.checkpoint, [&](const record::Sums& sums) {
    try {
      record::write_sums(sums, job.keep);
      console.detail(fmt::format("checkpoint: {}", job.keep));
    } catch (const WriteError& error) {
      console.note(fmt::format("warning: no checkpoint: {}", error.what()));
    }
  });
  ProgressDisplay display(console.progress(), job.info.samples_per_pixel);
  transport::RenderHooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&](const transport::Progress& progress) {
    work.rays = progress.rays;
    display.show(progress);
  };
  transport::render_tiles(scene, job.settings, hooks, [&](record::Tile tile) { collector.take(std::move(tile)); });
  record::Sums sums = collector.finish();
  work.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return sums;
}

std::string name_of_part(const std::string& output, const record::Part& part) {
  return fmt::format("{}.part-{}-of-{}", output, part.number, part.of);
}

std::optional<record::Sums> reduce(const Ranks& ranks, record::Sums sums) {
  // Up a binary tree: as many steps as the number of ranks has bits, and the order of additions changes nothing.
  for (int step = 1; step < ranks.count(); step *= 2) {
    if (ranks.number() % (2 * step) != 0) {
      ranks.send(ranks.number() - step, bytes_of(sums));
      return {};
    }
    const int other = ranks.number() + step;
    if (other < ranks.count()) sums = record::merged(std::move(sums), sums_from(ranks.receive(other)));
  }
  return sums;
}

}  // namespace heckbert::cli
