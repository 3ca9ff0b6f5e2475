#include <algorithm>
#include <cmath>
#include <filesystem>
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
#include <heckbert/cli/pictures.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/cli/settings.h>
#include <heckbert/cli/trial.h>
#include <heckbert/cli/trial_settings.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/verdict.h>
#include <heckbert/report/verdict_json.h>
#include <heckbert/report/verdict_picture.h>
#include <heckbert/report/verdict_text.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/symbol_set.h>
#include <heckbert/transport/method_options.h>
#include <heckbert/transport/scene_hash.h>

namespace heckbert::cli {
namespace {

struct VerifyOptions {
  std::string scene;
  std::vector<std::string> algorithms;  ///< none: all that show light of the scene
  std::string reference;                ///< a record; empty: rendered
  std::size_t reference_samples = 0;    ///< 0: kReferenceFactor times those of the algorithms
  double significance = report::VerdictOptions{}.significance;
  std::string folder;  ///< for pictures; empty: none
  std::size_t top = 4;
  bool fine = false, json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, VerifyOptions& options) {
  add_scene_to_try(command, options.scene);
  command
      .add_option("--algorithm", options.algorithms, with_algorithms("one to test (default: all); may be repeated:"))
      ->type_name("NAME")
      ->allow_extra_args(false);
  command.add_option("--reference", options.reference, "a record to compare with (default: rendered for this)")
      ->type_name("FILE.paths.exr");
  add_count(command, "--reference-spp", options.reference_samples,
            fmt::format("samples per pixel of the reference (default: {} times --spp)", kReferenceFactor));
  const auto read_significance = [&options](const std::string& text) {
    options.significance = value_of_flag("--significance", [&] { return number_between(text, 0, 1); });
  };
  command
      .add_option_function<std::string>(
          "--significance", read_significance,
          fmt::format("chance of a false alarm in all that is compared (default: {})", options.significance))
      ->type_name("P");
  command.add_option("-o,--output", options.folder, "pictures: predicted, rendered, difference in standard errors")
      ->type_name("DIR");
  add_count(command, "--top", options.top, fmt::format("words listed of each kind (default: {})", options.top));
  command.add_flag("--fine", options.fine, "words with subscripts, such as LaDrStEp");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Tracing, Scope::Confidence});
}

constexpr const char* kVerifyExamples =
    "  heckbert verify cornell\n"
    "  heckbert verify lecture --algorithm whitted --algorithm lecture --spp 256 -o pictures\n"
    "  heckbert verify room.json --reference room.paths.exr --json\n";

/// The algorithms to test. Errors: UsageError for one that is not there or has no words to test.
std::vector<const transport::AlgorithmFacts*> algorithms_of(const VerifyOptions& options,
                                                            const transport::Scene& scene) {
  std::vector<const transport::AlgorithmFacts*> chosen;
  for (const std::string& name : options.algorithms) {
    const transport::AlgorithmFacts& algorithm = choose_flag("--algorithm", name, transport::kAlgorithms);
    if (algorithm.accuracy == transport::Accuracy::NotLight)
      throw UsageError(fmt::format("--algorithm: {} shows no light of the scene, so there is nothing to verify", name));
    if (!takes(algorithm, scene)) throw UsageError(fmt::format("--algorithm: {} knows no media", name));
    chosen.push_back(&algorithm);
  }
  if (chosen.empty())
    for (const transport::AlgorithmFacts& algorithm : transport::kAlgorithms)
      if (algorithm.accuracy != transport::Accuracy::NotLight && takes(algorithm, scene)) chosen.push_back(&algorithm);
  return chosen;
}

/// Errors: UsageError where an algorithm cannot be made as much coarser as its errors are followed.
void check_refinable(const std::vector<const transport::AlgorithmFacts*>& algorithms, const transport::Method& method) {
  for (const transport::AlgorithmFacts* algorithm : algorithms) {
    if (algorithm->accuracy != transport::Accuracy::Consistent) continue;
    const transport::MethodOption& option = *transport::refining_option(algorithm->id);
    const double finest = option.get(method),
                 most = option.most / *std::max_element(std::begin(kCoarser), std::end(kCoarser));
    if (finest > most)
      throw UsageError(
          fmt::format("--method {}: {:g} is too coarse to verify {}, which is run with up to {:g} times as "
                      "much too; at most {:g}",
                      option.name, finest, algorithm->name, option.most / most, most));
  }
}

/// From a file. Errors: ReadError for a record that is of another picture, lacks some of it or says nothing of its
/// spread.
TrialRun read_reference(const std::string& name, const transport::Scene& scene,
                        const transport::RenderSettings& settings, const std::vector<taxonomy::Language>& pictures,
                        const Console& console) {
  const record::Record record = read_record(name);
  const auto algorithm =
      std::find_if(transport::kAlgorithms.begin(), transport::kAlgorithms.end(),
                   [&](const transport::AlgorithmFacts& facts) { return facts.name == record.info.algorithm; });
  if (algorithm == transport::kAlgorithms.end())
    throw ReadError(fmt::format("{}: made by '{}', whose grammar is not known here", name, record.info.algorithm));
  if (record.info.window != record::Window{0, 0, settings.width, settings.height})
    throw ReadError(fmt::format("{}: has another size than {}x{}; give --size", name, settings.width, settings.height));
  if (record::batches_in_use(record.info) < 2)
    throw ReadError(fmt::format("{}: without batches its spread is not known", name));
  if (record.info.partial) throw ReadError(fmt::format("{}: was interrupted, and some pixels are black", name));
  if (record.folding) throw ReadError(fmt::format("{}: its long words are folded, so they are not known", name));
  if (record.info.max_depth != settings.max_depth)
    throw ReadError(fmt::format("{}: is of at most {} scatterings, not {}; give --max-depth", name,
                                record.info.max_depth, settings.max_depth));
  if (record.info.scene_hash != fmt::format("{:016x}", transport::hash_of(scene)))
    console.note(fmt::format("warning: {} is of another scene, or of an earlier state of this one", name));
  TrialRun run{.algorithm = &*algorithm};
  run.evidence.take_batches_of(record, pictures);
  return run;
}

/// Pictures of what each algorithm was predicted to find, of what it found, and of the difference.
void write_pictures(const std::string& folder, const std::vector<report::Witness>& witnesses,
                    const std::vector<report::Trial>& trials, const Console& console) {
  for (std::size_t i = 0; i < trials.size(); ++i) {
    std::vector<report::NoisyImage> parts;
    for (const report::Witness& witness : witnesses) parts.push_back(witness.evidence->image(i));
    const report::NoisyImage predicted = report::sum_of(parts), rendered = trials[i].evidence->image(0);
    const float exposure = report::auto_exposure(witnesses.front().evidence->image(trials.size()).mean);
    const auto write = [&](const char* what, const std::string& bytes) {
      write_bytes((std::filesystem::path(folder) / fmt::format("{}-{}.png", trials[i].algorithm, what)).string(),
                  bytes);
    };
    write("predicted", png_of(predicted.mean, exposure));
    write("rendered", png_of(rendered.mean, exposure));
    write("difference", png_of(report::difference_picture(predicted, rendered)));
  }
  console.note(fmt::format("wrote {} into {}", report::counted(3 * trials.size(), "picture"), folder));
}

report::Json to_json(const VerifyOptions& options, const transport::RenderSettings& settings,
                     const std::vector<TrialRun>& trusted, taxonomy::Symbol eye,
                     const report::Verification& verification) {
  report::Json json = report::document_of("heckbert.verify");
  json["scene"] = options.scene;
  json["eye"] = taxonomy::name(eye);
  json["width"] = settings.width;
  json["height"] = settings.height;
  json["seed"] = settings.seed;
  json["max_depth"] = settings.max_depth;
  json["references"] = report::Json::array();
  for (const TrialRun& run : trusted)
    json["references"].push_back(
        {{"algorithm", run.algorithm->name}, {"samples_per_pixel", std::lround(run.evidence.samples_per_pixel())}});
  json.update(report::to_json(verification));
  return json;
}

ExitCode run(const VerifyOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const import::Imported imported = load_scene(options.scene);
  const transport::Scene& scene = imported.scene;
  const std::vector<const transport::AlgorithmFacts*> algorithms = algorithms_of(options, scene);
  const transport::RenderSettings of_trials = settings_to_try(settings, scene.defaults);
  check_refinable(algorithms, of_trials.method);
  const std::vector<taxonomy::Symbol> lights = kinds_of_lights(scene);
  const taxonomy::Symbol eye = kind_of_eye(scene);
  if (lights.empty()) throw UsageError(fmt::format("{} has no light, so there is nothing to verify", options.scene));
  const bool wants_pictures = !options.folder.empty();
  if (wants_pictures) make_writable_folder(options.folder);

  const InterruptGuard interrupt;
  const auto run_one = [&](Runner& run_it, const transport::AlgorithmFacts& algorithm,
                           const transport::RenderSettings& render, std::span<const taxonomy::Language> pictures,
                           std::vector<TrialRun>& runs) {
    return try_out(run_it, algorithm, scene, render, pictures, interrupt.stop(), console, runs);
  };
  // What each algorithm is predicted to find, as far as a reference vouches for it, and last all that it vouches for.
  const auto predictions = [&](const taxonomy::Language& vouched) {
    std::vector<taxonomy::Language> pictures;
    if (!wants_pictures) return pictures;
    for (const transport::AlgorithmFacts* algorithm : algorithms)
      pictures.push_back(transport::claimed_by(*algorithm) & vouched);
    pictures.push_back(vouched);
    return pictures;
  };
  std::vector<TrialRun> trusted, runs;
  if (!options.reference.empty()) {
    trusted.push_back(
        read_reference(options.reference, scene, of_trials, predictions(words_between(lights, eye)), console));
  } else {
    const transport::RenderSettings reference =
        reference_settings(of_trials, options.reference_samples > 0 ? static_cast<int>(options.reference_samples)
                                                                    : kReferenceFactor * of_trials.samples_per_pixel);
    const auto believed = trusted_algorithms(scene);
    const std::vector<taxonomy::Language> shares = shares_of(believed, lights, eye);
    for (std::size_t i = 0; i < believed.size(); ++i)
      if (!run_one(run_trial, *believed[i], reference, predictions(shares[i]), trusted)) return ExitCode::Interrupted;
  }
  const std::vector<taxonomy::Language> everything(wants_pictures ? 1 : 0, words_between(lights, eye));
  for (const transport::AlgorithmFacts* algorithm : algorithms)
    if (!run_one(run_refined_trial, *algorithm, of_trials, everything, runs)) return ExitCode::Interrupted;

  const std::vector<report::Witness> witnesses = witnesses_of(trusted);
  report::VerdictOptions rules{.significance = options.significance, .confidence = settings.confidence};
  if (options.fine) rules.spelling = report::Spelling::Fine;
  const auto run_again = [&](const transport::AlgorithmFacts& algorithm, const transport::RenderSettings& render) {
    std::vector<TrialRun> repeated;
    const bool is_done = run_one(run_refined_trial, algorithm, render, everything, repeated);
    return is_done ? std::optional(std::move(repeated.front())) : std::nullopt;
  };
  const auto verified = verify_twice(runs, witnesses, lights, eye, rules, of_trials, run_again);
  if (!verified) return ExitCode::Interrupted;
  const report::Verification& verification = *verified;
  if (options.json)
    fmt::print("{}", report::dump(to_json(options, of_trials, trusted, eye, verification)));
  else
    fmt::print("{}", report::verification_text(verification, console.table_style(), options.top));
  if (wants_pictures) write_pictures(options.folder, witnesses, trials_of(runs, eye), console);
  const bool all_expected = std::all_of(verification.verdicts.begin(), verification.verdicts.end(),
                                        [](const report::AlgorithmVerdict& verdict) { return verdict.is_expected; });
  return all_expected ? ExitCode::Done : ExitCode::No;
}

}  // namespace

void add_verify(CLI::App& app, Run& chosen) {
  add_command<VerifyOptions>(app, chosen, "verify",
                             "Run the algorithms and test each against what its grammar predicts", kVerifyExamples,
                             declare, run);
}

}  // namespace heckbert::cli
