#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/asked_record.h>
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

namespace heckbert::cli {
namespace {

struct CoverageFlags {
  std::string record;
  std::vector<std::string> grammars;  ///< none: the teaching set
  std::size_t top = report::CoverageOptions{}.top;
  bool fine = false;
  std::string sheet;  ///< empty: not wanted
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, CoverageFlags& options) {
  add_record(command, options.record);
  add_grammars(command, options.grammars);
  add_count(command, "--top", options.top, fmt::format("words listed per grammar (default: {})", options.top));
  command.add_flag("--fine", options.fine, "words with subscripts, such as LaDrStEp");
  command.add_option("--sheet", options.sheet, "a contact sheet: what each grammar captures and misses")
      ->type_name("FILE.png");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy, Scope::Confidence});
}

constexpr const char* kExamples =
    "  heckbert coverage cornell.paths.exr\n"
    "  heckbert coverage cornell.paths.exr --grammar whitted --grammar 'L(D|S)*E' --glossy specular\n"
    "  heckbert coverage cornell.paths.exr --grammar my.grammar --json\n"
    "  heckbert coverage cornell.paths.exr --grammar all\n"
    "  heckbert coverage cornell.paths.exr --sheet sheet.png\n";

ExitCode run(const CoverageFlags& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  if (options.sheet == "-") throw UsageError("--sheet needs the name of a file; standard output has the table");
  if (!options.sheet.empty()) check_writable(options.sheet);
  const std::vector<taxonomy::Grammar> grammars = find_to_cover(options.grammars, "--grammar", settings);
  const record::Record record = read_record(options.record);

  const report::Coverage coverage =
      report::coverage(record, grammars,
                       {.glossy_rule = settings.glossy,
                        .confidence = settings.confidence,
                        .top = options.top,
                        .spelling = options.fine ? report::Spelling::Fine : report::Spelling::Plain});
  fmt::print("{}", options.json ? report::coverage_json(coverage)
                                : report::coverage_text(coverage, console.table_style(), options.top));
  if (!options.sheet.empty()) {
    write_bytes(options.sheet, png_of(report::contact_sheet(record, coverage)));
    console.note("wrote " + options.sheet);
  }
  return ExitCode::Done;
}

}  // namespace

void add_coverage(CLI::App& app, Run& chosen) {
  add_command<CoverageFlags>(app, chosen, "coverage", "What each algorithm captures and misses of a record", kExamples,
                             declare, run);
}

}  // namespace heckbert::cli
