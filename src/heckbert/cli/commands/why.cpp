#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/algorithms.h>
#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/interrupt.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/cli/settings.h>
#include <heckbert/cli/trial.h>
#include <heckbert/cli/trial_settings.h>
#include <heckbert/report/diagnosis.h>
#include <heckbert/report/diagnosis_text.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::cli {
namespace {

using transport::AlgorithmFacts;
using transport::claimed_by;

struct WhyOptions {
  std::string scene;
  std::string algorithm{transport::kAlgorithms.front().name};
  std::string region, pixel;  ///< empty: the whole picture
  bool cheapest = false;
  std::string plot;  ///< empty: none
  std::size_t top = 8;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, WhyOptions& options) {
  add_scene_to_try(command, options.scene);
  command.add_option("--algorithm", options.algorithm, with_algorithms("whose picture is black (default: path):"))
      ->type_name("NAME");
  command.add_option("--region", options.region, "only these pixels, X1 and Y1 excluded")->type_name("X0,Y0,X1,Y1");
  command.add_option("--pixel", options.pixel, "only this pixel")->type_name("X,Y")->excludes("--region");
  command.add_flag("--cheapest", options.cheapest, "run all algorithms: what each captures, and how long it takes");
  command.add_option("--plot", options.plot, "the same as a plot")->type_name("FILE.svg");
  add_count(command, "--top", options.top, fmt::format("words listed (default: {})", options.top));
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Tracing, Scope::Confidence});
}

constexpr const char* kWhyExamples =
    "  heckbert why caustic-point\n"
    "  heckbert why lecture --algorithm whitted --pixel 300,400\n"
    "  heckbert why lantern --cheapest --plot lantern.svg\n";

/// The settings of the whole picture, or of the region at the size that the scene's picture has, so that places mean
/// what they mean there; few pixels get more samples.
transport::RenderSettings settings_of(const WhyOptions& options, const Settings& settings,
                                      const transport::RenderDefaults& scene) {
  transport::RenderSettings render = settings_to_try(settings, scene);
  if (options.region.empty() && options.pixel.empty()) return render;
  if (!settings.size) {
    render.width = scene.width.value_or(transport::RenderSettings{}.width);
    render.height = scene.height.value_or(transport::RenderSettings{}.height);
  }
  const bool is_pixel = !options.pixel.empty();
  const std::string flag = is_pixel ? "--pixel" : "--region";
  render.crop = value_of_flag(flag, [&] {
    return is_pixel ? parse_pixel(options.pixel, {0, 0, render.width, render.height}) : parse_window(options.region);
  });
  if (render.crop->x1 > render.width || render.crop->y1 > render.height)
    throw UsageError(
        fmt::format("{}: reaches beyond the picture, which has {}x{} pixels", flag, render.width, render.height));
  if (!settings.samples_per_pixel) {
    constexpr std::size_t kMostFactor = 64;
    const std::size_t factor = kTrialSide * kTrialSide / render.crop->pixel_count();
    render.samples_per_pixel *= static_cast<int>(std::clamp<std::size_t>(factor, 1, kMostFactor));
  }
  return render;
}

/// Those whose word is taken: the unbiased, then the consistent ones for what is left.
std::vector<const AlgorithmFacts*> all_who_know(const transport::Scene& scene) {
  const std::vector<taxonomy::Symbol> lights = kinds_of_lights(scene);
  const taxonomy::Symbol eye = kind_of_eye(scene);
  std::vector<const AlgorithmFacts*> known = trusted_algorithms(scene);
  taxonomy::Language left = words_between(lights, eye);
  for (const AlgorithmFacts* algorithm : known) left = left - claimed_by(*algorithm);
  for (const AlgorithmFacts& algorithm : transport::kAlgorithms) {
    if (algorithm.accuracy != transport::Accuracy::Consistent || !takes(algorithm, scene) ||
        (claimed_by(algorithm) & left).is_empty())
      continue;
    known.push_back(&algorithm);
    left = left - claimed_by(algorithm);
  }
  return known;
}

/// What each technique of the algorithm brings, measured.
std::vector<report::MeasuredTechnique> measured_techniques(const AlgorithmFacts& algorithm,
                                                           const transport::Scene& scene,
                                                           transport::RenderSettings settings,
                                                           const std::atomic<bool>& stop) {
  settings.algorithm = algorithm.id;
  const record::RenderInfo info = transport::info_of(scene, settings);
  std::vector<report::MeasuredTechnique> measured;
  for (const record::TechniqueSum& sum :
       transport::measure_techniques(scene, settings, {.progress = {}, .stop = &stop})) {
    const record::Estimate energy = record::energy_of(sum, info);
    measured.push_back({.word = sum.word,
                        .light_vertices = sum.technique.light_vertices,
                        .merged = sum.technique.merged,
                        .count = sum.count,
                        .mean = energy.mean,
                        .standard_error = energy.standard_error});
  }
  return measured;
}

ExitCode run(const WhyOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const AlgorithmFacts& suspect = choose_flag("--algorithm", options.algorithm, transport::kAlgorithms);
  if (suspect.accuracy == transport::Accuracy::NotLight)
    throw UsageError(fmt::format("--algorithm: {} shows no light of the scene", suspect.name));
  if (!options.plot.empty()) check_writable(options.plot);
  const import::Imported imported = load_scene(options.scene);
  const transport::Scene& scene = imported.scene;
  const transport::RenderSettings render = settings_of(options, settings, scene.defaults);
  const std::vector<taxonomy::Symbol> lights = kinds_of_lights(scene);
  const taxonomy::Symbol eye = kind_of_eye(scene);
  if (lights.empty()) throw UsageError(fmt::format("{} has no light: that is why", options.scene));
  const taxonomy::Language words = words_between(lights, eye);

  const InterruptGuard interrupt;
  const auto run_one = [&](const AlgorithmFacts& algorithm, const transport::RenderSettings& with,
                           std::span<const taxonomy::Language> pictures, std::vector<TrialRun>& runs) {
    return try_out(run_trial, algorithm, scene, with, pictures, interrupt.stop(), console, runs);
  };
  std::vector<TrialRun> known, runs;
  for (const AlgorithmFacts* algorithm : all_who_know(scene))
    if (!run_one(*algorithm, reference_settings(render, kReferenceFactor * render.samples_per_pixel), {}, known))
      return ExitCode::Interrupted;
  if (!run_one(suspect, render, {&words, 1}, runs)) return ExitCode::Interrupted;

  report::VerdictOptions rules{.confidence = settings.confidence};
  std::vector<report::Candidate> candidates;
  const bool runs_all = options.cheapest || !options.plot.empty();
  for (const AlgorithmFacts& algorithm : transport::kAlgorithms) {
    if (algorithm.accuracy == transport::Accuracy::NotLight || !takes(algorithm, scene)) continue;
    candidates.push_back({std::string(algorithm.name), claimed_by(algorithm)});
    if (!runs_all) continue;
    if (algorithm.id != suspect.id && !run_one(algorithm, render, {&words, 1}, runs)) return ExitCode::Interrupted;
    const TrialRun& made = algorithm.id == suspect.id ? runs.front() : runs.back();
    const double samples = made.evidence.samples_per_pixel();
    if (const auto needed = report::samples_for_picture(made.evidence.image(0), samples, rules.error))
      candidates.back().seconds = made.seconds / samples * *needed;
  }
  const std::vector<report::MeasuredTechnique> measured = measured_techniques(suspect, scene, render, interrupt.stop());
  if (interrupt.stop()) return ExitCode::Interrupted;
  const report::Diagnosis diagnosis = report::diagnose(
      {.algorithm = std::string(suspect.name),
       .title = std::string(suspect.title),
       .evidence = &runs.front().evidence,
       .claimed = claimed_by(suspect),
       .has = [&](const taxonomy::Word& word,
                  const taxonomy::Strategy& s) { return transport::has_technique(suspect, word, s.light_vertices); }},
      witnesses_of(known), std::move(candidates), measured, words, rules);
  if (!options.plot.empty()) {
    write_bytes(options.plot, report::candidates_svg(diagnosis));
    console.note("wrote " + options.plot);
  }
  if (options.json) {
    const record::Window window = render.crop.value_or(record::Window{0, 0, render.width, render.height});
    report::Json json = report::document_of("heckbert.why");
    json["scene"] = options.scene;
    json["eye"] = taxonomy::name(eye);
    json["width"] = render.width;
    json["height"] = render.height;
    json["window"] = {{"x0", window.x0}, {"y0", window.y0}, {"x1", window.x1}, {"y1", window.y1}};
    json["samples_per_pixel"] = std::lround(runs.front().evidence.samples_per_pixel());
    json["seed"] = render.seed;
    json["max_depth"] = render.max_depth;
    json.update(report::to_json(diagnosis));
    fmt::print("{}", report::dump(json));
  } else {
    fmt::print("{}", report::diagnosis_text(diagnosis, console.table_style(), options.top));
  }
  return ExitCode::Done;
}

}  // namespace

void add_why(CLI::App& app, Run& chosen) {
  add_command<WhyOptions>(app, chosen, "why", "Why is it black? What an algorithm cannot find, and who can",
                          kWhyExamples, declare, run);
}

}  // namespace heckbert::cli
