#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/asked_part.h>
#include <heckbert/cli/asked_record.h>
#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/pictures.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/contact_sheet.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/coverage_json.h>
#include <heckbert/report/coverage_text.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/requirement.h>

namespace heckbert::cli {
namespace {

struct CoverageFlags {
  std::string record;
  std::vector<std::string> grammars;  ///< none: the teaching set
  std::size_t top = report::CoverageOptions{}.top;
  bool fine = false;
  double error = report::CoverageOptions{}.error;
  std::size_t budget = static_cast<std::size_t>(report::CoverageOptions{}.budget);
  PartFlags part;
  std::vector<std::string> requirements;  ///< "GRAMMAR>=SHARE"
  std::string sheet;                      ///< empty: not wanted
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, CoverageFlags& options) {
  add_record(command, options.record);
  add_grammars(command, options.grammars);
  add_count(command, "--top", options.top, fmt::format("words listed per grammar (default: {})", options.top));
  command.add_flag("--fine", options.fine, "words with subscripts, such as LaDrStEp");
  const auto read_error = [&options](const std::string& text) {
    options.error = value_of_flag("--error", [&] { return number_between(text, 0, 1); });
  };
  command
      .add_option_function<std::string>(
          "--error", read_error, fmt::format("relative error that makes a word practical (default: {})", options.error))
      ->type_name("E");
  add_count(command, "--budget", options.budget,
            fmt::format("samples per pixel that it may take (default: {})", options.budget));
  add_part(command, options.part);
  command
      .add_option("--require", options.requirements, "exit with 1 unless the interval's lower end reaches this share")
      ->type_name("GRAMMAR>=SHARE")
      ->allow_extra_args(false);
  command.add_option("--sheet", options.sheet, "a contact sheet: what each grammar captures and misses")
      ->type_name("FILE.png");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy, Scope::Confidence});
}

constexpr const char* kCoverageExamples =
    "  heckbert coverage cornell.paths.exr\n"
    "  heckbert coverage cornell.paths.exr --grammar whitted --grammar 'L(D|S)*E' --glossy specular\n"
    "  heckbert coverage cornell.paths.exr --grammar my.grammar --json\n"
    "  heckbert coverage cornell.paths.exr --grammar all\n"
    "  heckbert coverage cornell.paths.exr --sheet sheet.png\n"
    "  heckbert coverage cornell.paths.exr --require 'whitted>=0.6' --require 'radiosity>=90%'\n"
    "  heckbert coverage labelled.paths.exr --object 'glass ball' --error 0.01 --budget 4096\n";

/// A requirement as it was given, and the text of its grammar.
struct Demand {
  report::Requirement requirement;
  std::string grammar;
};

Demand parse_requirement(const std::string& text) {
  const std::size_t sign = text.rfind(">=");
  if (sign == std::string::npos || sign == 0)
    throw UsageError(
        fmt::format("--require: '{}' is no requirement; expected GRAMMAR>=SHARE, such as whitted>=0.95", text));
  const double least = value_of_flag("--require", [&] { return share_of(text.substr(sign + 2)); });
  std::string grammar = text.substr(0, sign);
  while (!grammar.empty() && grammar.back() == ' ') grammar.pop_back();
  return {{text, "", least}, std::move(grammar)};
}

/// The grammars to cover; those of requirements that are not among them are added.
std::vector<taxonomy::Grammar> grammars_of(const CoverageFlags& options, std::vector<Demand>& demands,
                                           const Settings& settings) {
  std::vector<taxonomy::Grammar> grammars = find_to_cover(options.grammars, "--grammar", settings);
  for (Demand& demand : demands) {
    taxonomy::Grammar grammar = find_grammar(demand.grammar, "--require", settings);
    demand.requirement.grammar = grammar.name;
    const bool is_there = std::any_of(grammars.begin(), grammars.end(),
                                      [&](const taxonomy::Grammar& other) { return other.name == grammar.name; });
    if (!is_there) grammars.push_back(std::move(grammar));
  }
  return grammars;
}

ExitCode run(const CoverageFlags& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  if (options.sheet == "-") throw UsageError("--sheet needs the name of a file; standard output has the table");
  if (!options.sheet.empty()) check_writable(options.sheet);
  std::vector<Demand> demands;
  for (const std::string& text : options.requirements) demands.push_back(parse_requirement(text));
  const std::vector<taxonomy::Grammar> grammars = grammars_of(options, demands, settings);
  const record::RecordFile file = open_record(options.record);
  // Regions and contact sheets go over the pixels more than once.
  std::optional<record::Record> whole;
  if (has_pixels(options.part) || !options.sheet.empty()) whole = file.whole();
  const record::Record& record = whole ? *whole : file.totals();
  console.note(report::folding(record));

  const report::Coverage coverage =
      report::coverage(record, whole ? rows_of(*whole) : rows_of(file), grammars,
                       {.glossy_rule = settings.glossy,
                        .confidence = settings.confidence,
                        .top = options.top,
                        .spelling = options.fine ? report::Spelling::Fine : report::Spelling::Plain,
                        .error = options.error,
                        .budget = static_cast<double>(options.budget),
                        .part = part_of(options.part, record, settings)});
  std::vector<report::Requirement> requirements;
  for (const Demand& demand : demands) requirements.push_back(demand.requirement);
  const std::vector<report::Verdict> verdicts = report::judge(coverage, requirements);
  fmt::print("{}", options.json ? report::coverage_json(coverage, verdicts)
                                : report::coverage_text(coverage, console.table_style(), options.top));
  for (const report::Verdict& verdict : verdicts) console.note(report::sentence(verdict, coverage));
  if (!options.sheet.empty()) {
    write_bytes(options.sheet, png_of(report::contact_sheet(record, coverage)));
    console.note("wrote " + options.sheet);
  }
  const bool all_hold =
      std::all_of(verdicts.begin(), verdicts.end(), [](const report::Verdict& verdict) { return verdict.holds; });
  return all_hold ? ExitCode::Done : ExitCode::No;
}

}  // namespace

void add_coverage(CLI::App& app, Run& chosen) {
  add_command<CoverageFlags>(app, chosen, "coverage", "What each algorithm captures and misses of a record",
                             kCoverageExamples, declare, run);
}

}  // namespace heckbert::cli
