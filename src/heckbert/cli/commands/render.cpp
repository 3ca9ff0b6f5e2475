#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/cli/algorithms.h>
#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/commands/render/job.h>
#include <heckbert/cli/commands/render/result.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/interrupt.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/memory_budget.h>
#include <heckbert/cli/pilot.h>
#include <heckbert/cli/rank_parts.h>
#include <heckbert/cli/record_precision.h>
#include <heckbert/cli/resume.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/transport/method_options.h>

namespace heckbert::cli {
namespace {

void declare(CLI::App& command, RenderOptions& options) {
  command.add_option("SCENE", options.scene, "built-in ('heckbert scene list'), .json, .obj, Mitsuba .xml, or '-'")
      ->required();
  command.add_option("-o,--output", options.output, "the picture and its class layers, as OpenEXR")
      ->type_name("FILE.exr");
  command.add_option("--record", options.record, "the record, for all later questions")->type_name("FILE.paths.exr");
  add_precision(command, options.precision);
  command.add_flag("--exact", options.exact, "keep sums in the record, so that others can be merged with it");
  command.add_option("--resume", options.resume, "go on from the record of an interrupted render")
      ->type_name("FILE.paths.exr");
  command.add_option("--preview", options.preview, "a PNG of the picture (default: beside the -o file)")
      ->type_name("FILE.png");
  command.add_flag("--no-preview", options.no_preview, "write no PNG");
  command.add_option("--lpe", options.classes, "add the picture of a class as a layer; may be repeated")
      ->type_name("NAME=EXPR")
      ->allow_extra_args(false);
  command.add_flag("--cryptomatte", options.cryptomatte,
                   "Cryptomatte of the --lpe classes, else of all words, in the -o file");
  command.add_option("--algorithm", options.algorithm, with_algorithms("how to trace (default: path):"))
      ->type_name("NAME");
  command.add_flag("--adaptive", options.adaptive,
                   "more samples where the --lpe classes, else the picture, are noisy;\n"
                   "not in pieces, not for algorithms that walk from the light");
  command.add_flag("--json", options.json, "print what was done as JSON");
  add_settings(command, options.flags,
               {Scope::Tracing, Scope::Rendering, Scope::Dialect, Scope::Glossy, Scope::Confidence});
}

constexpr const char* kRenderExamples =
    "  heckbert render cornell -o cornell.exr --record cornell.paths.exr --spp 64\n"
    "  heckbert render room.obj -o room.exr --size 640x480 --time 30\n"
    "  heckbert render lecture -o out.exr --lpe caustic='LS+DE' --lpe indirect=@indirect\n"
    "  heckbert render lecture -o caustic.exr --lpe caustic='LS+DE' --adaptive\n"
    "  heckbert render lecture --record whitted.paths.exr --algorithm whitted\n"
    "  heckbert render lecture --record out.paths.exr --checkpoint 60\n"
    "  heckbert render lecture --record out.paths.exr --checkpoint 60 --resume out.paths.exr\n"
    "  heckbert render lecture --record part3.paths.exr --part 3/8\n"
    "  mpirun heckbert render lecture -o lecture.exr --record lecture.paths.exr\n"
    "  heckbert render lecture --record lecture.paths.exr --labels object,light-group\n";

/// The names that --method knows.
std::string methods_text() {
  std::string text = "\nNames for --method:\n";
  for (const transport::MethodOption& option : transport::kMethodOptions) {
    std::string readers;
    for (const transport::AlgorithmId id : option.algorithms)
      readers += fmt::format("{}{}", readers.empty() ? "" : ", ", transport::facts(id).name);
    text += fmt::format("  {:<14} {}\n{:17}{:.7g} to {:.7g} (default: {:.7g}), for {}\n", option.name, option.meaning,
                        "", option.least, option.most, option.get({}), readers);
  }
  return text;
}

void tell_account(const Console& console, const std::string& name, const import::Account& account) {
  console.note(fmt::format("{}: {} understood, {} guessed, {} ignored", name, account.understood.size(),
                           account.guessed.size(), account.ignored.size()));
  console.detail(account_lines(account.understood, "understood"));
  console.note(account_lines(account.guessed, "guessed"));
  console.note(account_lines(account.ignored, "ignored"));
}

/// With as many samples per pixel as fit into the time.
transport::RenderSettings fit_into(double seconds, const transport::Scene& scene, transport::RenderSettings render,
                                   const RenderOptions& options, const Console& console,
                                   const std::atomic<bool>& stop) {
  const Plan plan = plan_for(scene, render, seconds, stop);
  render.samples_per_pixel = plan.samples_per_pixel;
  if (options.adaptive)
    render.samples_per_pixel = std::max(1, static_cast<int>(plan.samples_per_pixel / (1 + kPilotShare)));
  console.note(fmt::format("{} samples per pixel fit into {:g} s (measured {:.2f} Msamples/s in {:.2f} s)",
                           plan.samples_per_pixel, seconds, plan.samples_per_second / 1e6, plan.seconds));
  return render;
}

transport::RenderSettings plan_adaptively(const transport::Scene& scene, const transport::RenderSettings& render,
                                          const std::vector<taxonomy::Grammar>& grammars, const Settings& settings,
                                          const Console& console, const std::atomic<bool>& stop) {
  std::vector<taxonomy::Language> classes;
  for (const taxonomy::Grammar& grammar : grammars)
    classes.push_back(taxonomy::apply(settings.glossy, grammar.language));
  transport::RenderSettings planned = adapted(scene, render, classes, stop);
  const auto& repeats = planned.sample_map->repeats;
  const auto [fewest, most] = std::minmax_element(repeats.begin(), repeats.end());
  console.note(fmt::format("adaptive: {} to {} samples per pixel, {:.1f} on average",
                           *fewest * planned.samples_per_pixel, *most * planned.samples_per_pixel,
                           planned.sample_map->mean() * planned.samples_per_pixel));
  return planned;
}

/// Where what is found is kept while it is found.
Wanted wanted_of(const RenderOptions& options, const TracingJob& job, const Outputs& outputs, const Ranks& ranks,
                 const std::vector<taxonomy::Grammar>& grammars, const Settings& settings) {
  Wanted wanted{.rule = settings.glossy};
  // Pictures of tiles are those of the whole, unless something is added to them.
  wanted.pictures = !transport::facts(job.settings.algorithm).from_light && job.resume.empty() && ranks.count() == 1;
  const bool needs_entries = !outputs.record.empty() || options.cryptomatte || !wanted.pictures;
  if (needs_entries) wanted.file = outputs.record.empty() ? outputs.picture : outputs.record;
  if (settings.memory) wanted.folding = fold_rule(*settings.memory, job.info, grammars, options.cryptomatte);
  for (const taxonomy::Grammar& grammar : grammars) wanted.classes.push_back(grammar.language);
  return wanted;
}

ExitCode run(const RenderOptions& options) {
  Settings settings = resolve(options.flags);
  Ranks ranks;
  if (ranks.number() > 0) {
    settings.quiet = true;
    settings.progress = When::Never;
  }
  const Console console(settings);
  // Everything that can be wrong is looked at before any ray is traced.
  const Outputs outputs = outputs_of(options);
  const std::vector<taxonomy::Grammar> grammars = find_named_grammars(options.classes, "--lpe", settings);
  choose_flag("--algorithm", options.algorithm, transport::kAlgorithms);
  precision_of(options.precision);
  const import::Imported imported = load_scene(options.scene);
  transport::RenderSettings render = render_settings(options, settings, imported.scene.defaults, ranks);
  tell_account(console, options.scene, imported.account);

  const InterruptGuard interrupt;
  if (settings.seconds)
    render = fit_into(*settings.seconds, imported.scene, render, options, console, interrupt.stop());
  console.note(fmt::format("{}x{} pixels, {} samples per pixel, {}, seed {}, at most {} scatterings", render.width,
                           render.height, render.samples_per_pixel, options.algorithm, render.seed, render.max_depth));
  if (options.adaptive) render = plan_adaptively(imported.scene, render, grammars, settings, console, interrupt.stop());

  const TracingJob job = job_of(options, settings, render, imported, outputs, ranks);
  std::optional<record::SumsStream> begun;
  if (!job.resume.empty()) begun = resumed(job.resume, job.info);
  Findings findings(job.info, std::move(begun), wanted_of(options, job, outputs, ranks, grammars, settings));
  Work work;
  trace(imported.scene, job, console, interrupt.stop(), work, findings);
  std::optional<record::SumsStream> sums = findings.sums();
  if (ranks.count() > 1) sums = share(ranks, std::move(*sums), job.keep);
  if (!sums) {
    part_from(ranks, job.keep);
    ranks.leave();
    return ExitCode::Done;
  }

  const Result result = result_of(std::move(*sums), findings.pictures(), options, grammars, settings);
  write_outputs(outputs, result, options.cryptomatte, settings, console);
  tell_result(console, result, work);
  console.note(fmt::format("wrote {}", fmt::join(outputs.all(), ", ")));
  if (options.json) fmt::print("{}", report::dump(to_json(outputs, result, work, settings, imported.account)));
  if (ranks.count() > 1) part_from(ranks, job.keep);
  ranks.leave();
  return result.record.info.partial ? ExitCode::Interrupted : ExitCode::Done;
}

}  // namespace

void add_render(CLI::App& app, Run& chosen) {
  add_command<RenderOptions>(app, chosen, "render", "Trace a scene; write its picture, class pictures and record",
                             kRenderExamples + methods_text(), declare, run);
}

}  // namespace heckbert::cli
