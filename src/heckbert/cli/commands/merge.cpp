#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/record_precision.h>
#include <heckbert/cli/settings.h>
#include <heckbert/record/file.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {
namespace {

struct MergeOptions {
  std::vector<std::string> records;
  std::string output, precision;
  bool exact = false, json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, MergeOptions& options) {
  command.add_option("RECORD", options.records, "records that keep their sums, in any order")->required();
  command.add_option("-o,--output", options.output, "the record of all of them")
      ->type_name("FILE.paths.exr")
      ->required();
  add_precision(command, options.precision);
  command.add_flag("--exact", options.exact, "keep the sums even when nothing is missing, to merge more later");
  command.add_flag("--json", options.json, "print what was merged as JSON");
  add_settings(command, options.flags, {});
}

constexpr const char* kMergeExamples =
    "  heckbert merge room.part-*.paths.exr -o room.paths.exr\n"
    "  heckbert merge monday.paths.exr tuesday.paths.exr -o both.paths.exr --exact\n";

/// Records that are to be added up, once any two of them have been compared.
class Inputs {
 public:
  explicit Inputs(const Console& console) : console_(console) {}

  void add(const std::string& name) {
    record::SumsStream sums = open_sums(name);
    console_.detail(fmt::format("{}: {}", name, report::summary(sums.info)));
    for (std::size_t i = 0; i < names_.size(); ++i) {
      check(names_[i], streams_[i].info, name, sums.info);
      if (const std::string doubt = record::doubt_of(streams_[i].info, sums.info); !doubt.empty())
        console_.note(fmt::format("warning: '{}' and '{}': {}", names_[i], name, doubt));
    }
    names_.push_back(name);
    streams_.push_back(std::move(sums));
  }

  record::SumsStream merged() && { return record::merged(std::move(streams_)); }

 private:
  static void check(const std::string& first, const record::RenderInfo& a, const std::string& second,
                    const record::RenderInfo& b) {
    try {
      record::check_alike(a, b);
      record::samples_of_both(a, b);
    } catch (const record::MergeError& error) {
      throw ReadError(fmt::format("cannot merge '{}' and '{}': {}", first, second, error.what()));
    }
  }

  const Console& console_;
  std::vector<std::string> names_;
  std::vector<record::SumsStream> streams_;
};

report::Json to_json(const std::vector<record::SampleRange>& ranges) {
  report::Json json = report::Json::array();
  for (const record::SampleRange& range : ranges) json.push_back(report::to_json(range));
  return json;
}

ExitCode run(const MergeOptions& options) {
  const Console console(resolve(options.flags));
  if (options.output == "-" && options.json) throw UsageError("--json and an output '-' both want standard output");
  check_writable(options.output);
  const record::Precision precision = precision_of(options.precision);
  Inputs inputs(console);
  for (const std::string& name : options.records) inputs.add(name);

  const record::SumsStream sums = std::move(inputs).merged();
  const std::vector<record::SampleRange> missing = record::missing_of(record::samples_of(sums.info));
  const bool keeps_sums = options.exact || sums.info.partial || !missing.empty();
  const record::Record record = record::totals_of(sums, keeps_sums ? record::Precision::Float : precision);
  write_to(options.output, [&](const auto& path) {
    keeps_sums ? record::write_sums(sums, path) : record::write_record(record, sums, path);
  });

  console.note(report::summary(sums.info));
  for (const record::SampleRange& range : missing) console.note("still missing: " + record::to_text(range));
  for (const std::string& warning : report::warnings(record.info, record.tally)) console.note("warning: " + warning);
  console.note(fmt::format("wrote {}", options.output));
  if (options.json) {
    report::Json json = report::document_of("heckbert.merge");
    json["render"] = report::to_json(record.info);
    json["tally"] = report::to_json(record.info, record.tally);
    json["words"] = record.words.size();
    json["missing"] = to_json(missing);
    json["keeps_sums"] = keeps_sums;
    json["records"] = options.records;
    json["file"] = options.output;
    fmt::print("{}", report::dump(json));
  }
  return ExitCode::Done;
}

}  // namespace

void add_merge(CLI::App& app, Run& chosen) {
  add_command<MergeOptions>(app, chosen, "merge", "Add up records: the parts of a render, or other seeds of a scene",
                            kMergeExamples, declare, run);
}

}  // namespace heckbert::cli
