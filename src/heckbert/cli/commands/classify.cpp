#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/asked_record.h>
#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/settings.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/classify.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/words_text.h>

namespace heckbert::cli {
namespace {

struct ClassifyFlags {
  std::string record;
  std::string by{report::kGroupings.front().name};
  std::size_t top = 20;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, ClassifyFlags& options) {
  add_record(command, options.record);
  command.add_option("--by", options.by, "what to group by (default: word)")
      ->type_name(alternatives(report::kGroupings));
  add_count(command, "--top", options.top, fmt::format("groups in the table; 0 for all (default: {})", options.top));
  command.add_flag("--json", options.json, "print all groups as JSON");
  add_settings(command, options.flags, {Scope::Glossy, Scope::Confidence});
}

constexpr const char* kExamples =
    "  heckbert classify cornell.paths.exr\n"
    "  heckbert classify cornell.paths.exr --by length --top 0\n"
    "  heckbert classify cornell.paths.exr --by class --glossy diffuse --json\n";

ExitCode run(const ClassifyFlags& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const report::GroupBy by = choose_flag("--by", options.by, report::kGroupings).by;
  const record::Record record = open_record(options.record, console);

  const report::ClassifyOptions how{.glossy_rule = settings.glossy, .confidence = settings.confidence};
  const std::vector<report::WordGroup> groups = report::classify(record, by, teaching_library(), how);
  const double luminance = record::energy(record, std::vector<bool>(record.words.size(), true)).mean;
  if (const std::string ended = report::termination(record.info, record.tally, luminance); !ended.empty())
    console.note(ended);
  fmt::print("{}", options.json ? report::groups_json(groups, by, record.info, record.tally, how)
                                : report::groups_text(groups, by, console.table_style(), options.top));
  return ExitCode::Done;
}

}  // namespace

void add_classify(CLI::App& app, Run& chosen) {
  add_command<ClassifyFlags>(app, chosen, "classify", "The words of a record by energy, or groups of them", kExamples,
                             declare, run);
}

}  // namespace heckbert::cli
