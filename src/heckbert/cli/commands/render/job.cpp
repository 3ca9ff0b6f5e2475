#include <heckbert/cli/commands/render/job.h>

#include <filesystem>

#include <fmt/format.h>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/exit_code.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/rank_parts.h>
#include <heckbert/transport/method_options.h>

namespace heckbert::cli {

std::vector<std::string> Outputs::all() const {
  std::vector<std::string> names;
  for (const std::string& name : {picture, record, preview})
    if (!name.empty()) names.push_back(name);
  return names;
}

Outputs outputs_of(const RenderOptions& options) {
  if (options.output.empty() && options.record.empty())
    throw UsageError("render needs somewhere to write to: -o FILE.exr, --record FILE.paths.exr, or both");
  if (options.cryptomatte && options.output.empty()) throw UsageError("--cryptomatte needs -o FILE.exr to go into");
  if (options.no_preview && !options.preview.empty()) throw UsageError("--preview and --no-preview exclude each other");
  Outputs outputs{options.output, options.record, options.preview};
  if (outputs.preview.empty() && !options.no_preview && !options.output.empty() && options.output != "-")
    outputs.preview = std::filesystem::path(options.output).replace_extension(".png").string();

  const std::vector<std::string> names = outputs.all();
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (names[i] == names[j]) throw UsageError(fmt::format("two outputs would go to '{}'", names[i]));
  for (const std::string& name : names) {
    if (name == "-" && options.json) throw UsageError("--json and an output '-' both want standard output");
    check_writable(name);
  }
  return outputs;
}

transport::RenderSettings render_settings(const RenderOptions& options, const Settings& settings,
                                          const transport::RenderDefaults& scene, const Ranks& ranks) {
  transport::RenderSettings render;
  render.algorithm = choose_flag("--algorithm", options.algorithm, transport::kAlgorithms).id;
  render.width = settings.size ? settings.size->width : scene.width.value_or(render.width);
  render.height = settings.size ? settings.size->height : scene.height.value_or(render.height);
  render.crop = settings.crop;
  render.samples_per_pixel =
      settings.samples_per_pixel.value_or(scene.samples_per_pixel.value_or(render.samples_per_pixel));
  if (ranks.count() > 1 && settings.part.of > 1)
    throw UsageError("--part: the processes of mpirun are the parts already");
  render.part = ranks.count() > 1 ? record::Part{ranks.number() + 1, ranks.count()} : settings.part;
  if (settings.seconds && (render.part.of > 1 || !options.resume.empty()))
    throw UsageError("--time: what is traced in pieces needs a number of samples that all pieces know; use --spp");
  if (options.adaptive && (render.part.of > 1 || !options.resume.empty() || options.exact || settings.checkpoint))
    throw UsageError(
        "--adaptive plans the samples of one render as a whole: it excludes what is traced in pieces or merged later, "
        "which is --part, --resume, --checkpoint, --exact and mpirun");
  if (options.adaptive && transport::facts(render.algorithm).from_light)
    throw UsageError(fmt::format(
        "--adaptive plans how many walks each pixel begins, but '{}' also walks from the light, which is for "
        "all pixels at once; use another --algorithm",
        options.algorithm));
  if (render.part.of > render.samples_per_pixel)
    throw UsageError(fmt::format("{} samples per pixel cannot be shared out into {} parts", render.samples_per_pixel,
                                 render.part.of));
  render.max_depth = settings.max_depth.value_or(scene.max_depth.value_or(render.max_depth));
  render.seed = settings.seed.value_or(scene.seed.value_or(render.seed));
  render.filter = settings.filter.value_or(scene.filter.value_or(render.filter));
  render.sampler = settings.sampler;
  render.labels = settings.labels;
  render.method = settings.method;
  for (const transport::MethodOption& option : transport::kMethodOptions)
    if (option.get(render.method) != option.get({}) && !transport::reads(render.algorithm, option))
      throw UsageError(fmt::format("--method: the algorithm '{}' has no {}", options.algorithm, option.name));
  render.threads = settings.threads.value_or(render.threads);
  if (render.crop && (render.crop->x1 > render.width || render.crop->y1 > render.height))
    throw UsageError(
        fmt::format("--crop: the window reaches beyond the picture of {}x{}", render.width, render.height));
  return render;
}

/// Whether words may be folded.
void check_folding(const RenderOptions& options, const Settings& settings, const transport::RenderSettings& render,
                   const Ranks& ranks) {
  if (options.exact || render.part.of > 1 || settings.checkpoint || !options.resume.empty() || ranks.count() > 1)
    throw UsageError(
        "--memory: --exact, --part, --checkpoint, --resume and mpirun keep sums for others to add to, and folded words "
        "have none");
  if (transport::facts(render.algorithm).from_light)
    throw UsageError(
        fmt::format("--memory: '{}' also walks from the light, which takes memory of its own", options.algorithm));
}

TracingJob job_of(const RenderOptions& options, const Settings& settings, const transport::RenderSettings& render,
                  const import::Imported& imported, const Outputs& outputs, const Ranks& ranks) {
  TracingJob job{.settings = render, .info = transport::info_of(imported.scene, render)};
  job.info.scene = options.scene;
  job.info.ignored = imported.account.ignored;
  job.info.glossy = settings.glossy;
  job.checkpoint = settings.checkpoint;
  job.resume = options.resume;
  job.keep = outputs.record;
  if (ranks.count() > 1) {
    job.keep = name_of_part(outputs.record.empty() ? outputs.picture : outputs.record, render.part);
    // Each rank goes on from its own part, if that is there.
    if (!job.resume.empty()) job.resume = name_of_part(job.resume, render.part);
    if (!std::filesystem::exists(job.resume)) job.resume.clear();
  }
  if (transport::facts(render.algorithm).passes && (job.checkpoint || !job.resume.empty()))
    throw UsageError(fmt::format(
        "--algorithm {} goes over the whole picture again and again: no --checkpoint, no --resume", options.algorithm));
  if (job.checkpoint && (job.keep.empty() || job.keep == "-"))
    throw UsageError("--checkpoint needs a file to write to: --record FILE.paths.exr");
  if (settings.memory) check_folding(options, settings, render, ranks);
  return job;
}

}  // namespace heckbert::cli
