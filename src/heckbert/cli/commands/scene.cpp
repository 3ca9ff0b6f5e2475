#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/help.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/cli/settings.h>
#include <heckbert/import/import.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {
namespace {

// ---- scene list ---------------------------------------------------------------------------------------------------

struct ListOptions {
  bool json = false;
  SettingFlags flags;
};

void declare_list(CLI::App& command, ListOptions& options) {
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {});
}

ExitCode run_list(const ListOptions& options) {
  const Console console(resolve(options.flags));
  report::Json json = report::document_of("heckbert.scenes");
  json["scenes"] = report::Json::array();
  std::vector<report::TextRow> rows;
  for (const import::BuiltinScene& scene : import::builtin_scenes()) {
    json["scenes"].push_back({{"name", scene.name}, {"title", scene.title}});
    rows.push_back({.cells = {std::string(scene.name), std::string(scene.title)}});
  }
  fmt::print("{}", options.json ? report::dump(json)
                                : report::text_table({{"Scene"}, {"Title"}}, rows, console.table_style()));
  return ExitCode::Done;
}

// ---- scene check --------------------------------------------------------------------------------------------------

struct CheckOptions {
  std::vector<std::string> scenes;
  bool json = false;
  SettingFlags flags;
};

void declare_check(CLI::App& command, CheckOptions& options) {
  command.add_option("SCENE", options.scenes, "a .json, .obj or .xml file, or a built-in scene")->required();
  command.add_flag("--json", options.json, "print the accounts as JSON");
  add_settings(command, options.flags, {});
}

ExitCode run_check(const CheckOptions& options) {
  resolve(options.flags);
  report::Json json = report::document_of("heckbert.scene_check");
  json["scenes"] = report::Json::array();
  // Every file is looked at, whatever is wrong with those before it.
  ExitCode worst = ExitCode::Done;
  for (const std::string& name : options.scenes) {
    const ExitCode code = guarded([&] {
      const import::Account account = load_scene(name).account;
      json["scenes"].push_back({{"scene", name}, {"account", to_json(account)}});
      if (!options.json) {
        fmt::print("{}\n{}{}{}", name, account_lines(account.understood, "understood"),
                   account_lines(account.guessed, "guessed"), account_lines(account.ignored, "ignored"));
      }
      return ExitCode::Done;
    });
    worst = std::max(worst, code);
  }
  if (options.json) fmt::print("{}", report::dump(json));
  return worst;
}

}  // namespace

void add_scene(CLI::App& app, Run& chosen) {
  CLI::App* scene = add_family(app, "scene", "The built-in scenes; what is understood of a scene file");
  add_command<ListOptions>(*scene, chosen, "list", "The built-in scenes", "  heckbert scene list\n", declare_list,
                           run_list);
  add_command<CheckOptions>(*scene, chosen, "check", "What an import understood, guessed and ignored",
                            "  heckbert scene check room.obj lamp.json mitsuba.xml\n", declare_check, run_check);
}

}  // namespace heckbert::cli
