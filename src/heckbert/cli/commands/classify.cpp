#include <optional>
#include <string>
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
#include <heckbert/cli/settings.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/classify.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/words_text.h>

namespace heckbert::cli {
namespace {

struct ClassifyFlags {
  std::string record;
  std::string by{report::kGroupings.front().name};
  std::size_t top = 20;
  std::optional<double> reach;
  PartFlags part;
  bool json = false;
  SettingFlags flags;
};

std::string groupings_help() {
  std::string help = "what to group by (default: word)";
  for (const report::GroupByFacts& grouping : report::kGroupings)
    help += fmt::format("\n{}: {}", grouping.name, grouping.meaning);
  return help;
}

void declare(CLI::App& command, ClassifyFlags& options) {
  add_record(command, options.record);
  command.add_option("--by", options.by, groupings_help())->type_name("GROUPING");
  add_count(command, "--top", options.top, fmt::format("groups in the table; 0 for all (default: {})", options.top));
  const auto read_reach = [&options](const std::string& text) {
    options.reach = value_of_flag("--reach", [&] { return number_between(text, 0, 1); });
  };
  command
      .add_option_function<std::string>("--reach", read_reach,
                                        "list the fewest groups that have this share of the energy together")
      ->type_name("SHARE")
      ->excludes("--top");
  add_part(command, options.part);
  command.add_flag("--json", options.json, "print all groups as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy, Scope::Confidence});
}

constexpr const char* kClassifyExamples =
    "  heckbert classify cornell.paths.exr\n"
    "  heckbert classify cornell.paths.exr --by length --top 0\n"
    "  heckbert classify cornell.paths.exr --reach 0.99\n"
    "  heckbert classify cornell.paths.exr --by specular --region 100,80,140,120\n"
    "  heckbert classify cornell.paths.exr --by class --glossy diffuse --json\n";

ExitCode run(const ClassifyFlags& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const report::GroupBy by = choose_flag("--by", options.by, report::kGroupings).by;
  if (options.reach && !report::facts(by).is_partition)
    throw UsageError(fmt::format("--reach: groups by {} overlap, so their shares do not add up", options.by));
  const record::Record record =
      has_pixels(options.part) ? read_record(options.record) : read_record_totals(options.record);
  introduce(record, console);

  report::ClassifyOptions how{.glossy_rule = settings.glossy,
                              .confidence = settings.confidence,
                              .part = part_of(options.part, record, settings)};
  how.reach = options.reach.value_or(how.reach);
  report::Classification classes = report::classify(record, by, teaching_library(), how);
  const double luminance = record::energy(record, std::vector<bool>(record.words.size(), true)).mean;
  if (const std::string ended = report::termination(record.info, record.tally, luminance); !ended.empty())
    console.note(ended);
  if (options.json) {
    fmt::print("{}", report::classification_json(classes));
    return ExitCode::Done;
  }
  std::size_t rows = options.top;
  if (options.reach) {
    classes.groups = report::fewest_to_reach(classes);
    rows = classes.groups.size();
  }
  fmt::print("{}", report::classification_text(classes, console.table_style(), rows));
  return ExitCode::Done;
}

}  // namespace

void add_classify(CLI::App& app, Run& chosen) {
  add_command<ClassifyFlags>(app, chosen, "classify", "The words of a record by energy, or groups of them",
                             kClassifyExamples, declare, run);
}

}  // namespace heckbert::cli
