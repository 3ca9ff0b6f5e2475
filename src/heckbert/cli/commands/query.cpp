#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/asked_record.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/layers.h>
#include <heckbert/cli/pictures.h>
#include <heckbert/cli/settings.h>
#include <heckbert/record/file.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/picture.h>

namespace heckbert::cli {
namespace {

struct QueryOptions {
  std::string record;
  std::vector<std::string> classes;  ///< "name=EXPR" or "EXPR"
  std::string output, preview;       ///< empty: not wanted
  bool cryptomatte = false;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, QueryOptions& options) {
  add_record(command, options.record);
  command.add_option("EXPR", options.classes, "expression, @name or .grammar file; NAME=EXPR gives the layer a name")
      ->required();
  command.add_option("-o,--output", options.output, "pictures as OpenEXR: one EXPR as R, G, B; several as layers")
      ->type_name("FILE.exr");
  command.add_option("--preview", options.preview, "a PNG of the first class; with {} in its name, one of each class")
      ->type_name("FILE.png");
  command.add_flag("--cryptomatte", options.cryptomatte, "add the classes to the EXR as a Cryptomatte, to be picked");
  command.add_flag("--json", options.json, "print the energies as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy, Scope::Confidence});
}

constexpr const char* kQueryExamples =
    "  heckbert query cornell.paths.exr 'LS+DE' -o caustic.exr --preview caustic.png\n"
    "  heckbert query cornell.paths.exr direct='LDE' indirect='LDD+E' -o layers.exr\n"
    "  heckbert query cornell.paths.exr direct='LDE' indirect='LDD+E' --preview 'cornell-{}.png'\n"
    "  heckbert query cornell.paths.exr @caustic @direct @emission -o classes.exr --cryptomatte\n"
    "  heckbert query cornell.paths.exr '!@whitted' --glossy specular --json\n";

/// One picture, or one of each class where the name has a place for the class's.
void write_previews(const std::string& name, const std::vector<ClassOfRecord>& classes,
                    const std::vector<record::Image>& images) {
  const float exposure = report::auto_exposure(images.back());
  const std::size_t place = name.find("{}");
  std::vector<std::string> taken;
  for (const ClassOfRecord& item : classes) {
    taken.push_back(record::layer_name(item.grammar.name, taken));
    std::string file = name;
    if (place != std::string::npos) file.replace(place, 2, taken.back());
    write_bytes(file, png_of(images[taken.size() - 1], exposure));
    if (place == std::string::npos) return;
  }
}

ExitCode run(const QueryOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  if (options.cryptomatte && options.output.empty()) throw UsageError("--cryptomatte needs -o FILE.exr to go into");
  const bool to_stdout = options.output == "-" || options.preview == "-";
  if (to_stdout && options.json) throw UsageError("--json and an output '-' both want standard output");
  if (options.output == "-" && options.preview == "-") throw UsageError("two outputs would go to standard output");
  for (const std::string& name : {options.output, options.preview})
    if (!name.empty()) check_writable(name);
  const std::vector<taxonomy::Grammar> grammars = find_named_grammars(options.classes, "EXPR", settings);
  const record::RecordFile file = open_record(options.record);
  const record::Record& record = file.totals();
  const record::Rows rows = rows_of(file);
  introduce(record, console);

  const std::vector<ClassOfRecord> classes = classes_of(record, grammars, settings.glossy, settings.confidence);
  const bool single_unnamed = classes.size() == 1 && options.classes.front().find('=') == std::string::npos;
  std::vector<record::Image> images;
  if (!options.output.empty() || !options.preview.empty()) images = images_of(record, rows, classes);
  if (!options.output.empty()) {
    std::vector<record::Layer> layers = layers_of(images, classes, settings.glossy, single_unnamed);
    add_undecided_layers(record, rows, classes, layers);
    const record::Attachment attachment =
        options.cryptomatte ? cryptomatte_of(record, rows, classes) : record::Attachment{};
    write_to(options.output, [&](const auto& path) { record::write_layers(layers, record.info, path, attachment); });
    for (const std::string& sentence : renamed(layers)) console.note(sentence);
  }
  if (!options.preview.empty()) write_previews(options.preview, classes, images);

  console.detail("glossy bounces: " + report::describe(settings.glossy));
  for (const ClassOfRecord& item : classes) console.note(item.never);
  if (options.json) {
    report::Json json = report::document_of("heckbert.query");
    json["render"] = report::to_json(record.info);
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["confidence"] = settings.confidence;
    json["classes"] = to_json(classes);
    fmt::print("{}", report::dump(json));
  } else if (!to_stdout) {
    fmt::print("{}", classes_text(classes, console.table_style()));
  }
  return ExitCode::Done;
}

}  // namespace

void add_query(CLI::App& app, Run& chosen) {
  add_command<QueryOptions>(app, chosen, "query", "The picture of any class of paths, and its share of the energy",
                            kQueryExamples, declare, run);
}

}  // namespace heckbert::cli
