#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/help.h>
#include <heckbert/cli/settings.h>
#include <heckbert/record/file.h>
#include <heckbert/record/path_stream.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {
namespace {

// ---- record import ------------------------------------------------------------------------------------------------

struct ImportOptions {
  std::string stream, output;
  bool json = false;
  SettingFlags flags;
};

void declare_import(CLI::App& command, ImportOptions& options) {
  command.add_option("STREAM", options.stream, "paths of another renderer (docs/path-stream.md), or '-'")->required();
  command.add_option("-o,--output", options.output, "the record")->type_name("FILE.paths.exr")->required();
  command.add_flag("--json", options.json, "print what was read as JSON");
  add_settings(command, options.flags, {});
}

record::Record read_stream(const std::string& name) {
  if (name == "-") return record::read_path_stream(std::cin, "standard input");
  if (std::filesystem::is_directory(name)) throw ReadError(name + ": is a folder, not a file");
  std::ifstream file(name, std::ios::binary);
  if (!file) throw ReadError(fmt::format("{}: {}", name, std::strerror(errno)));
  return record::read_path_stream(file, name);
}

ExitCode run_import(const ImportOptions& options) {
  const Console console(resolve(options.flags));
  if (options.output == "-" && options.json) throw UsageError("--json and an output '-' both want standard output");
  check_writable(options.output);
  const record::Record record = read_stream(options.stream);
  write_to(options.output, [&](const auto& path) { record::write_record(record, path); });

  console.note(report::summary(record.info));
  console.note(fmt::format("{} found; wrote {}", report::counted(record.words.size(), "word"), options.output));
  for (const std::string& warning : report::warnings(record.info, record.tally)) console.note("warning: " + warning);
  if (options.json) {
    report::Json json = report::document_of("heckbert.record_import");
    json["render"] = report::to_json(record.info);
    json["tally"] = report::to_json(record.info, record.tally);
    json["words"] = record.words.size();
    json["file"] = options.output;
    fmt::print("{}", report::dump(json));
  }
  return ExitCode::Done;
}

}  // namespace

void add_record_family(CLI::App& app, Run& chosen) {
  CLI::App* family = add_family(app, "record", "Records of what other renderers have traced");
  add_command<ImportOptions>(*family, chosen, "import", "Make a record of the paths of another renderer",
                             "  heckbert record import paths.txt -o mine.paths.exr\n"
                             "  my-renderer --print-paths | heckbert record import - -o mine.paths.exr\n",
                             declare_import, run_import);
}

}  // namespace heckbert::cli
