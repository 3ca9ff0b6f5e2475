#include <heckbert/cli/trial_settings.h>

#include <algorithm>

#include <heckbert/cli/trial.h>

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
  render.threads = settings.threads.value_or(render.threads);
  return render;
}

}  // namespace heckbert::cli
