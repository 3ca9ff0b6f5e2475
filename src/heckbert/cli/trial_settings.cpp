#include <heckbert/cli/trial_settings.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <heckbert/cli/progress.h>

namespace heckbert::cli {

void add_scene_to_try(CLI::App& command, std::string& name) {
  command.add_option("SCENE", name, "built-in ('heckbert scene list'), .json, .obj, Mitsuba .xml, or '-'")->required();
}

transport::RenderSettings settings_to_try(const Settings& settings, const transport::RenderDefaults& scene) {
  transport::RenderSettings render{.width = kTrialSide, .height = kTrialSide, .samples_per_pixel = kTrialSamples};
  if (settings.size) {
    render.width = settings.size->width;
    render.height = settings.size->height;
  } else if (scene.width && scene.height) {
    const int longer = std::max(*scene.width, *scene.height);
    render.width = std::max(1, kTrialSide * *scene.width / longer);
    render.height = std::max(1, kTrialSide * *scene.height / longer);
  }
  render.samples_per_pixel = settings.samples_per_pixel.value_or(render.samples_per_pixel);
  render.max_depth = settings.max_depth.value_or(scene.max_depth.value_or(render.max_depth));
  render.seed = settings.seed.value_or(scene.seed.value_or(render.seed));
  render.filter = settings.filter.value_or(scene.filter.value_or(render.filter));
  render.sampler = settings.sampler;
  render.method = settings.method;
  render.threads = settings.threads.value_or(render.threads);
  return render;
}

bool try_out(Runner& run_it, const transport::AlgorithmFacts& algorithm, const transport::Scene& scene,
             const transport::RenderSettings& settings, std::span<const taxonomy::Language> pictures,
             const std::atomic<bool>& stop, const Console& console, std::vector<TrialRun>& runs) {
  ProgressDisplay display(console.progress(), settings.samples_per_pixel);
  const transport::RenderHooks hooks{.progress = [&](const transport::Progress& progress) { display.show(progress); },
                                     .stop = &stop};
  std::optional<TrialRun> run = run_it(algorithm, scene, settings, pictures, hooks);
  if (!run) return false;
  display.clear();
  console.note(fmt::format("{}: {} samples per pixel in {:.2f} s", algorithm.name, run->evidence.samples_per_pixel(),
                           run->seconds));
  runs.push_back(std::move(*run));
  return true;
}

}  // namespace heckbert::cli
