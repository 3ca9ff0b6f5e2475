#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/asked_part.h>
#include <heckbert/cli/asked_record.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/pictures.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/classify.h>
#include <heckbert/report/contact_sheet.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/html.h>
#include <heckbert/report/json_parts.h>

namespace heckbert::cli {
namespace {

struct ReportOptions {
  std::string record, output;
  std::vector<std::string> grammars;  ///< none: the teaching set
  PartFlags part;
  std::string sheet;  ///< empty: not wanted
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, ReportOptions& options) {
  add_record(command, options.record);
  command.add_option("-o,--output", options.output, "the page; it needs no other file")
      ->type_name("FILE.html")
      ->required();
  add_grammars(command, options.grammars);
  add_part(command, options.part);
  command.add_option("--sheet", options.sheet, "also the contact sheet as a PNG")->type_name("FILE.png");
  command.add_flag("--json", options.json, "print the names of the files as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy, Scope::Confidence});
}

constexpr const char* kReportExamples =
    "  heckbert report cornell.paths.exr -o cornell.html\n"
    "  heckbert report cornell.paths.exr -o cornell.html --sheet cornell-sheet.png --glossy specular\n"
    "  heckbert report cornell.paths.exr -o cornell.html --grammar whitted --grammar photon-mapping\n"
    "  heckbert report labelled.paths.exr -o pixel.html --pixel 90,90\n";

ExitCode run(const ReportOptions& options) {
  const Settings settings = resolve(options.flags);
  if (options.sheet == "-") throw UsageError("--sheet needs the name of a file");
  if (options.sheet == options.output) throw UsageError(fmt::format("two outputs would go to '{}'", options.output));
  if (options.output == "-" && options.json) throw UsageError("--json and an output '-' both want standard output");
  check_writable(options.output);
  if (!options.sheet.empty()) check_writable(options.sheet);
  const std::vector<taxonomy::Grammar> grammars = find_to_cover(options.grammars, "--grammar", settings);
  const record::Record record = read_record(options.record);

  const report::Part part = part_of(options.part, record, settings);
  const report::Coverage coverage = report::coverage(
      record, grammars, {.glossy_rule = settings.glossy, .confidence = settings.confidence, .part = part});
  const auto classified = [&](report::GroupBy by) {
    return report::classify(record, by, taxonomy::GrammarLibrary{},
                            {.glossy_rule = settings.glossy, .confidence = settings.confidence, .part = part});
  };
  std::vector<report::Classification> labels;
  if (!record.info.labels.empty())
    for (const report::GroupBy by : {report::GroupBy::Seen, report::GroupBy::Label, report::GroupBy::Light})
      labels.push_back(classified(by));
  write_bytes(options.output, report::html(record, coverage, classified(report::GroupBy::Word), {}, labels));
  if (!options.sheet.empty()) write_bytes(options.sheet, png_of(report::contact_sheet(record, coverage)));
  if (options.json) {
    report::Json json = report::document_of("heckbert.report");
    json["files"] = {{"page", options.output}, {"sheet", options.sheet}};
    fmt::print("{}", report::dump(json));
  } else if (options.output != "-") {
    fmt::print("{}\n", options.output);
  }
  return ExitCode::Done;
}

}  // namespace

void add_report(CLI::App& app, Run& chosen) {
  add_command<ReportOptions>(app, chosen, "report", "One page with pictures, coverage and words of a record",
                             kReportExamples, declare, run);
}

}  // namespace heckbert::cli
