#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/cli/algorithms.h>
#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/interrupt.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/layers.h>
#include <heckbert/cli/memory_budget.h>
#include <heckbert/cli/pictures.h>
#include <heckbert/cli/pilot.h>
#include <heckbert/cli/ranks.h>
#include <heckbert/cli/record_precision.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/cli/settings.h>
#include <heckbert/cli/streamed.h>
#include <heckbert/cli/tracing.h>
#include <heckbert/import/import.h>
#include <heckbert/record/file.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/picture.h>
#include <heckbert/transport/method_options.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {
namespace {

struct RenderOptions {
  std::string scene;
  std::string algorithm{transport::kAlgorithms.front().name};
  std::string output, record, preview;  ///< empty: not wanted
  std::string resume;                   ///< empty: from the start
  std::string precision;                ///< of the record
  bool no_preview = false, exact = false;
  std::vector<std::string> classes;  ///< "name=EXPR" or "EXPR"
  bool cryptomatte = false;
  bool adaptive = false;
  bool json = false;
  SettingFlags flags;
};

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

constexpr const char* kExamples =
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

/// Where the results go.
struct Outputs {
  std::string picture, record, preview;
  std::vector<std::string> all() const {
    std::vector<std::string> names;
    for (const std::string& name : {picture, record, preview})
      if (!name.empty()) names.push_back(name);
    return names;
  }
};

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

void tell_account(const Console& console, const std::string& name, const import::Account& account) {
  console.note(fmt::format("{}: {} understood, {} guessed, {} ignored", name, account.understood.size(),
                           account.guessed.size(), account.ignored.size()));
  console.detail(account_lines(account.understood, "understood"));
  console.note(account_lines(account.guessed, "guessed"));
  console.note(account_lines(account.ignored, "ignored"));
}

void tell_result(const Console& console, const record::Record& record, const Work& work,
                 const std::vector<ClassOfRecord>& classes) {
  console.note(fmt::format("{} samples in {:.2f} s, {:.2f} Mrays/s; {} found", report::grouped(record.tally.samples),
                           work.seconds, work.seconds > 0 ? static_cast<double>(work.rays) / work.seconds / 1e6 : 0,
                           report::counted(record.words.size(), "word")));
  for (const std::string& warning : report::warnings(record.info, record.tally)) console.note("warning: " + warning);
  console.note(report::folding(record));
  for (const ClassOfRecord& item : classes) {
    console.note(describe(item));
    console.note(item.never);
  }
}

/// What a render came to.
struct Result {
  record::Record record;                 ///< pixels may be missing
  std::optional<record::Sums> sums{};    ///< to be kept with the record, where that was held in memory
  std::vector<ClassOfRecord> classes{};  ///< that were asked for
  record::Image beauty{};
  std::vector<record::Image> images{};  ///< by class
};

/// From a record that was held in memory.
Result result_of(record::Sums sums, bool keeps_sums, record::Precision precision,
                 const std::vector<taxonomy::Grammar>& grammars, const Settings& settings) {
  sums.info.precision = keeps_sums ? record::Precision::Float : precision;
  Result result{.record = record::record_of(keeps_sums ? sums : std::move(sums))};
  if (keeps_sums) result.sums = std::move(sums);
  result.classes = classes_of(result.record, grammars, settings.glossy, settings.confidence);
  result.images = images_of(result.record, record::rows_of(result.record), result.classes);
  result.beauty = std::move(result.images.back());
  result.images.pop_back();
  return result;
}

/// From tiles that were let go.
Result result_of(const Streamed& streamed, bool is_done, bool keeps_sums,
                 const std::vector<taxonomy::Grammar>& grammars, const Settings& settings) {
  Result result{.record = streamed.spool.totals(!is_done)};
  if (keeps_sums) {  // which are of floats, even where halves were wanted
    result.record = record::totals_of(streamed.spool.stream(!is_done));
    result.record.info.precision = record::Precision::Float;
  }
  result.classes = classes_of(result.record, grammars, settings.glossy, settings.confidence);
  result.beauty = streamed.pictures.beauty();
  const auto images = streamed.pictures.classes();
  result.images.assign(images.begin(), images.end());
  return result;
}

record::Attachment matte_of(const Result& result, const Streamed* streamed) {
  if (streamed == nullptr) return cryptomatte_of(result.record, record::rows_of(result.record), result.classes);
  const record::SumsStream sums = streamed->spool.stream(result.record.info.partial);
  return cryptomatte_of(result.record, record::rows_of(sums), result.classes);
}

void write_outputs(const Outputs& outputs, const Result& result, const Streamed* streamed, bool keeps_sums,
                   bool with_cryptomatte, const Settings& settings, const Console& console) {
  if (!outputs.picture.empty()) {
    std::vector<record::Layer> layers = layers_of(result.images, result.classes, settings.glossy);
    layers.insert(layers.begin(), record::Layer{"", result.beauty, {}});
    add_non_path_layers(result.record, layers);
    const record::Attachment attachment = with_cryptomatte ? matte_of(result, streamed) : record::Attachment{};
    write_to(outputs.picture,
             [&](const auto& path) { record::write_layers(layers, result.record.info, path, attachment); });
    for (const std::string& sentence : renamed(layers)) console.note(sentence);
  }
  if (!outputs.record.empty())
    write_to(outputs.record, [&](const auto& path) {
      if (result.sums)
        record::write_sums(*result.sums, path);
      else if (streamed != nullptr && keeps_sums)
        record::write_sums(streamed->spool.stream(result.record.info.partial), path);
      else if (streamed != nullptr)
        streamed->spool.write(path, result.record.info.partial);
      else
        record::write_record(result.record, path);
    });
  if (!outputs.preview.empty())
    write_bytes(outputs.preview, png_of(result.beauty, report::auto_exposure(result.beauty)));
}

report::Json to_json(const Outputs& outputs, const record::Record& record, const Work& work,
                     const std::vector<ClassOfRecord>& classes, const Settings& settings,
                     const import::Account& account) {
  report::Json json = report::document_of("heckbert.render");
  json["render"] = report::to_json(record.info);
  json["tally"] = report::to_json(record.info, record.tally);
  json["seconds"] = work.seconds;
  json["rays"] = work.rays;
  json["words"] = record.words.size();
  json["glossy_rule"] = report::name_of(settings.glossy);
  json["confidence"] = settings.confidence;
  json["classes"] = cli::to_json(classes);
  json["account"] = cli::to_json(account);
  json["files"] = {{"picture", outputs.picture}, {"record", outputs.record}, {"preview", outputs.preview}};
  return json;
}

/// What the tracing is told, apart from the scene.
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
  return job;
}

/// A rank of several has traced its part: writes it, and brings all parts together at rank 0, whose sums come back.
/// The files of the parts stay until all is written, for others to merge when this job does not come to its end.
std::optional<record::Sums> share(const Ranks& ranks, record::Sums sums, const std::string& kept) {
  record::write_sums(sums, kept);
  if (sums.info.partial) ranks.interrupt_all();
  return reduce(ranks, std::move(sums));
}

/// Rank 0 tells the others that everything is written, and every rank removes its part.
void part_from(const Ranks& ranks, const std::string& kept) {
  for (int other = 1; ranks.number() == 0 && other < ranks.count(); ++other) ranks.send(other, "written");
  if (ranks.number() > 0) ranks.receive(0);
  std::filesystem::remove(kept);
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
  const record::Precision precision = precision_of(options.precision);
  const import::Imported imported = load_scene(options.scene);
  transport::RenderSettings render = render_settings(options, settings, imported.scene.defaults, ranks);
  tell_account(console, options.scene, imported.account);

  const InterruptGuard interrupt;
  if (settings.seconds) {
    const Plan plan = plan_for(imported.scene, render, *settings.seconds, interrupt.stop());
    render.samples_per_pixel = plan.samples_per_pixel;
    if (options.adaptive)
      render.samples_per_pixel = std::max(1, static_cast<int>(plan.samples_per_pixel / (1 + kPilotShare)));
    console.note(fmt::format("{} samples per pixel fit into {:g} s (measured {:.2f} Msamples/s in {:.2f} s)",
                             plan.samples_per_pixel, *settings.seconds, plan.samples_per_second / 1e6, plan.seconds));
  }
  console.note(fmt::format("{}x{} pixels, {} samples per pixel, {}, seed {}, at most {} scatterings", render.width,
                           render.height, render.samples_per_pixel, options.algorithm, render.seed, render.max_depth));
  if (options.adaptive) render = plan_adaptively(imported.scene, render, grammars, settings, console, interrupt.stop());

  Work work;
  TracingJob job = job_of(options, settings, render, imported, outputs, ranks);
  std::optional<record::Sums> sums;
  std::optional<Streamed> streamed;
  bool is_done = false;
  // What is added to while it is traced is held in memory as sums. All else is let go tile by tile.
  const bool in_memory =
      transport::facts(render.algorithm).from_light || job.checkpoint || !job.resume.empty() || ranks.count() > 1;
  if (in_memory && settings.memory)
    throw UsageError(
        "--memory: a render from the light, with --checkpoint, with --resume or by mpirun is held in memory as a "
        "whole");
  if (settings.memory && (options.exact || render.part.of > 1))
    throw UsageError("--memory: --exact and --part keep sums for others to add to, and folded words have none");
  bool keeps_sums = false;
  if (in_memory) {
    sums = trace(imported.scene, job, console, interrupt.stop(), work);
    if (ranks.count() > 1) sums = share(ranks, std::move(*sums), job.keep);
    if (!sums) {
      part_from(ranks, job.keep);
      ranks.leave();
      return ExitCode::Done;
    }
    keeps_sums = options.exact || sums->info.partial || !sums->info.parts.empty();
  } else {
    keeps_sums = !outputs.record.empty() && (options.exact || !job.info.parts.empty());
    job.info.precision = keeps_sums ? record::Precision::Float : precision;
    std::vector<taxonomy::Language> languages;
    for (const taxonomy::Grammar& grammar : grammars) languages.push_back(grammar.language);
    std::optional<record::FoldRule> folding;
    if (settings.memory) folding = fold_rule(*settings.memory, job.info, grammars, options.cryptomatte);
    const std::string& kept = outputs.record.empty() && options.cryptomatte ? outputs.picture : outputs.record;
    streamed.emplace(job.info, kept, languages, settings.glossy, folding);
    is_done = trace(imported.scene, job, console, interrupt.stop(), work, *streamed);
    const bool can_be_resumed =
        !is_done && !outputs.record.empty() && !options.adaptive && !streamed->spool.is_folded();
    keeps_sums = keeps_sums || can_be_resumed;
  }
  const Result result = sums ? result_of(std::move(*sums), keeps_sums, precision, grammars, settings)
                             : result_of(*streamed, is_done, keeps_sums, grammars, settings);
  const record::Record& record = result.record;
  write_outputs(outputs, result, streamed ? &*streamed : nullptr, keeps_sums, options.cryptomatte, settings, console);
  tell_result(console, record, work, result.classes);
  console.note(fmt::format("wrote {}", fmt::join(outputs.all(), ", ")));
  if (options.json)
    fmt::print("{}", report::dump(to_json(outputs, record, work, result.classes, settings, imported.account)));
  if (ranks.count() > 1) part_from(ranks, job.keep);
  ranks.leave();
  return record.info.partial ? ExitCode::Interrupted : ExitCode::Done;
}

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

}  // namespace

void add_render(CLI::App& app, Run& chosen) {
  add_command<RenderOptions>(app, chosen, "render", "Trace a scene; write its picture, class pictures and record",
                             kExamples + methods_text(), declare, run);
}

}  // namespace heckbert::cli
