#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/asked_part.h>
#include <heckbert/cli/asked_record.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/cli/settings.h>
#include <heckbert/cli/traced_paths.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/words_text.h>

namespace heckbert::cli {
namespace {

struct PathsOptions {
  std::string record, pixel, scene;
  bool trace = false, fine = false, json = false;
  std::size_t top = 8;
  SettingFlags flags;
};

void declare(CLI::App& command, PathsOptions& options) {
  add_record(command, options.record);
  command.add_option("--pixel", options.pixel, "the pixel, counted from the upper left corner")
      ->type_name("X,Y")
      ->required();
  command.add_flag("--trace", options.trace, "trace its samples again and show where its heaviest paths went");
  command.add_option("--scene", options.scene, "where the scene is now, with --trace (default: where it was)")
      ->type_name("SCENE")
      ->needs("--trace");
  add_count(command, "--top", options.top,
            fmt::format("words, and paths, to show; 0 for all (default: {})", options.top));
  command.add_flag("--fine", options.fine, "words with subscripts, such as LaDrStEp");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Confidence});
}

constexpr const char* kPathsExamples =
    "  heckbert paths lecture.paths.exr --pixel 120,200\n"
    "  heckbert paths lecture.paths.exr --pixel 120,200 --trace --top 3\n"
    "  heckbert paths lecture.paths.exr --pixel 120,200 --trace --json\n";

ExitCode run(const PathsOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const record::Record record = read_record(options.record);
  introduce(record, console);
  const record::Window pixel = pixel_of("--pixel", options.pixel, record);
  const std::vector<report::WordEnergy> words =
      report::words_by_energy(record, std::vector<bool>(record.words.size(), true),
                              options.fine ? report::Spelling::Fine : report::Spelling::Plain, settings.confidence,
                              {.pixels = pixel, .words = {}, .description = {}});
  const std::vector<transport::RetracedPath> paths =
      options.trace ? traced_paths(record, options.scene, pixel.x0, pixel.y0) : std::vector<transport::RetracedPath>{};
  if (options.json) {
    report::Json json = report::document_of("heckbert.paths");
    json["render"] = report::to_json(record.info);
    json["pixel"] = {{"x", pixel.x0}, {"y", pixel.y0}};
    json["confidence"] = settings.confidence;
    json["words"] = report::to_json(words);
    json["paths"] = to_json(paths);
    fmt::print("{}", report::dump(json));
    return ExitCode::Done;
  }
  const report::TextStyle style = console.table_style();
  fmt::print("{}", report::words_text(words, style, options.top));
  if (options.trace) fmt::print("{}", paths_text(paths, record, style, options.top));
  return ExitCode::Done;
}

}  // namespace

void add_paths(CLI::App& app, Run& chosen) {
  add_command<PathsOptions>(app, chosen, "paths", "The words of a pixel, and where its paths went", kPathsExamples,
                            declare, run);
}

}  // namespace heckbert::cli
