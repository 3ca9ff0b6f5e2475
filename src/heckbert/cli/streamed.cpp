#include <heckbert/cli/streamed.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include <heckbert/cli/progress.h>

namespace heckbert::cli {

namespace {

std::optional<std::filesystem::path> target_of(const std::string& record) {
  if (record.empty()) return {};
  if (record == "-") return std::filesystem::temp_directory_path() / "heckbert";
  return record;
}

}  // namespace

Streamed::Streamed(const record::RenderInfo& info, const std::string& record,
                   std::span<const taxonomy::Language> classes, taxonomy::GlossyRule rule,
                   const std::optional<record::FoldRule>& folding)
    : spool(info, target_of(record), folding), pictures(info, classes, rule) {}

bool trace(const transport::Scene& scene, const TracingJob& job, const Console& console, const std::atomic<bool>& stop,
           Work& work, Streamed& streamed) {
  const auto start = std::chrono::steady_clock::now();
  ProgressDisplay display(console.progress(), job.info.samples_per_pixel);
  transport::RenderHooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&](const transport::Progress& progress) {
    work.rays = progress.rays;
    display.show(progress);
  };
  const bool is_done = transport::render_tiles(scene, job.settings, hooks, [&](const record::Tile& tile) {
    streamed.spool.submit(tile);
    streamed.pictures.add(tile);
  });
  work.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return is_done;
}

}  // namespace heckbert::cli
