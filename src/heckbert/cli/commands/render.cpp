#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/interrupt.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/layers.h>
#include <heckbert/cli/pictures.h>
#include <heckbert/cli/pilot.h>
#include <heckbert/cli/progress.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/cli/settings.h>
#include <heckbert/import/import.h>
#include <heckbert/record/file.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/picture.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {
namespace {

struct RenderOptions {
  std::string scene;
  std::string algorithm{transport::kAlgorithms.front().name};
  std::string output, record, preview;  ///< empty: not wanted
  bool no_preview = false;
  std::vector<std::string> classes;  ///< "name=EXPR" or "EXPR"
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, RenderOptions& options) {
  command.add_option("SCENE", options.scene, "built-in ('heckbert scene list'), .json, .obj, Mitsuba .xml, or '-'")
      ->required();
  command.add_option("-o,--output", options.output, "the picture and its class layers, as OpenEXR")
      ->type_name("FILE.exr");
  command.add_option("--record", options.record, "the record, for all later questions")->type_name("FILE.paths.exr");
  command.add_option("--preview", options.preview, "a PNG of the picture (default: beside the -o file)")
      ->type_name("FILE.png");
  command.add_flag("--no-preview", options.no_preview, "write no PNG");
  command.add_option("--lpe", options.classes, "add the picture of a class as a layer; may be repeated")
      ->type_name("NAME=EXPR")
      ->allow_extra_args(false);
  command.add_option("--algorithm", options.algorithm, "how to trace (default: path)")
      ->type_name(alternatives(transport::kAlgorithms));
  command.add_flag("--json", options.json, "print what was done as JSON");
  add_settings(command, options.flags, {Scope::Tracing, Scope::Dialect, Scope::Glossy, Scope::Confidence});
}

constexpr const char* kExamples =
    "  heckbert render cornell -o cornell.exr --record cornell.paths.exr --spp 64\n"
    "  heckbert render room.obj -o room.exr --size 640x480 --time 30\n"
    "  heckbert render lecture -o out.exr --lpe caustic='LS+DE' --lpe indirect=@indirect\n"
    "  heckbert render lecture --record whitted.paths.exr --algorithm whitted\n";

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
                                          const transport::RenderDefaults& scene) {
  transport::RenderSettings render;
  render.algorithm = choose_flag("--algorithm", options.algorithm, transport::kAlgorithms).id;
  render.width = settings.size ? settings.size->width : scene.width.value_or(render.width);
  render.height = settings.size ? settings.size->height : scene.height.value_or(render.height);
  render.crop = settings.crop;
  render.samples_per_pixel =
      settings.samples_per_pixel.value_or(scene.samples_per_pixel.value_or(render.samples_per_pixel));
  render.max_depth = settings.max_depth.value_or(scene.max_depth.value_or(render.max_depth));
  render.seed = settings.seed.value_or(scene.seed.value_or(render.seed));
  render.filter = settings.filter.value_or(scene.filter.value_or(render.filter));
  render.sampler = settings.sampler;
  render.threads = settings.threads.value_or(render.threads);
  if (render.crop && (render.crop->x1 > render.width || render.crop->y1 > render.height))
    throw UsageError(
        fmt::format("--crop: the window reaches beyond the picture of {}x{}", render.width, render.height));
  return render;
}

void tell_account(const Console& console, const std::string& name, const import::Account& account) {
  console.note(fmt::format("{}: {} understood, {} guessed, {} ignored", name, account.understood.size(),
                           account.guessed.size(), account.ignored.size()));
  console.detail(account_lines(account.understood, "understood"));
  console.note(account_lines(account.guessed, "guessed"));
  console.note(account_lines(account.ignored, "ignored"));
}

/// What a render leaves besides the record.
struct Work {
  double seconds = 0;
  std::uint64_t rays = 0;
};

record::Record trace(const transport::Scene& scene, const transport::RenderSettings& settings, const Console& console,
                     const std::atomic<bool>& stop, Work& work) {
  const auto start = std::chrono::steady_clock::now();
  ProgressDisplay display(console.progress(), settings.samples_per_pixel);
  transport::RenderHooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&](const transport::Progress& progress) {
    work.rays = progress.rays;
    display.show(progress);
  };
  record::Record record = transport::render(scene, settings, hooks);
  work.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return record;
}

void tell_result(const Console& console, const record::Record& record, const Work& work,
                 const std::vector<ClassOfRecord>& classes) {
  console.note(fmt::format("{} samples in {:.2f} s, {:.2f} Mrays/s; {} found", report::grouped(record.tally.samples),
                           work.seconds, work.seconds > 0 ? static_cast<double>(work.rays) / work.seconds / 1e6 : 0,
                           report::counted(record.words.size(), "word")));
  for (const std::string& warning : report::warnings(record.info, record.tally)) console.note("warning: " + warning);
  for (const ClassOfRecord& item : classes) {
    console.note(describe(item));
    console.note(item.never);
  }
}

void write_outputs(const Outputs& outputs, const record::Record& record, const std::vector<ClassOfRecord>& classes,
                   const Settings& settings) {
  const record::Image beauty = record::beauty(record);
  if (!outputs.picture.empty()) {
    std::vector<record::Layer> layers = layers_of(record, classes, settings.glossy);
    layers.insert(layers.begin(), record::Layer{"", beauty, {}});
    add_non_path_layers(record, layers);
    write_to(outputs.picture, [&](const auto& path) { record::write_layers(layers, record.info, path); });
  }
  if (!outputs.record.empty()) write_to(outputs.record, [&](const auto& path) { record::write_record(record, path); });
  if (!outputs.preview.empty()) write_bytes(outputs.preview, png_of(beauty, report::auto_exposure(beauty)));
}

report::Json to_json(const Outputs& outputs, const record::Record& record, const Work& work,
                     const std::vector<ClassOfRecord>& classes, const Settings& settings,
                     const import::Account& account) {
  report::Json json = report::document_of("heckbert.render");
  json["render"] = report::to_json(record.info);
  json["tally"] = report::to_json(record.tally);
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

ExitCode run(const RenderOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  // Everything that can be wrong is looked at before any ray is traced.
  const Outputs outputs = outputs_of(options);
  const std::vector<taxonomy::Grammar> grammars = find_named_grammars(options.classes, "--lpe", settings);
  choose_flag("--algorithm", options.algorithm, transport::kAlgorithms);
  const import::Imported imported = load_scene(options.scene);
  transport::RenderSettings render = render_settings(options, settings, imported.scene.defaults);
  tell_account(console, options.scene, imported.account);

  const InterruptGuard interrupt;
  if (settings.seconds) {
    const Plan plan = plan_for(imported.scene, render, *settings.seconds, interrupt.stop());
    render.samples_per_pixel = plan.samples_per_pixel;
    console.note(fmt::format("{} samples per pixel fit into {:g} s (measured {:.2f} Msamples/s in {:.2f} s)",
                             plan.samples_per_pixel, *settings.seconds, plan.samples_per_second / 1e6, plan.seconds));
  }
  console.note(fmt::format("{}x{} pixels, {} samples per pixel, {}, seed {}, at most {} scatterings", render.width,
                           render.height, render.samples_per_pixel, options.algorithm, render.seed, render.max_depth));

  Work work;
  record::Record record = trace(imported.scene, render, console, interrupt.stop(), work);
  record.info.scene = options.scene;
  record.info.ignored = imported.account.ignored;
  const std::vector<ClassOfRecord> classes = classes_of(record, grammars, settings.glossy, settings.confidence);
  write_outputs(outputs, record, classes, settings);
  tell_result(console, record, work, classes);
  console.note(fmt::format("wrote {}", fmt::join(outputs.all(), ", ")));
  if (options.json) fmt::print("{}", report::dump(to_json(outputs, record, work, classes, settings, imported.account)));
  return record.info.partial ? ExitCode::Interrupted : ExitCode::Done;
}

}  // namespace

void add_render(CLI::App& app, Run& chosen) {
  add_command<RenderOptions>(app, chosen, "render", "Trace a scene; write its picture, class pictures and record",
                             kExamples, declare, run);
}

}  // namespace heckbert::cli
