#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/strategies.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::cli {
namespace {

struct StrategiesOptions {
  std::string word;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, StrategiesOptions& options) {
  command.add_option("WORD", options.word, "a word such as LSDE; its ends are taken to be of every kind")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {});
}

ExitCode run(const StrategiesOptions& options) {
  const Console console(resolve(options.flags));
  taxonomy::Word word = taxonomy::parse_word(options.word);
  report::Json json = report::document_of("heckbert.grammar_strategies");
  json["word"] = plain(word);
  json["ends"] = report::Json::array();
  std::vector<report::TextRow> rows;
  for (const taxonomy::Symbol light : taxonomy::members(taxonomy::kLights))
    for (const taxonomy::Symbol eye : taxonomy::members(taxonomy::kEyes)) {
      word.light = light;
      word.eye = eye;
      const std::vector<taxonomy::Strategy> found = taxonomy::strategies(word);
      report::Json list = report::Json::array();
      std::string names;
      for (const taxonomy::Strategy& s : found) {
        list.push_back({{"name", s.name}, {"light_vertices", s.light_vertices}, {"eye_vertices", s.eye_vertices}});
        names += (names.empty() ? "" : ", ") + std::string(s.name);
      }
      json["ends"].push_back({{"light", taxonomy::name(light)},
                              {"eye", taxonomy::name(eye)},
                              {"count", found.size()},
                              {"strategies", std::move(list)}});
      rows.push_back(
          {{names.empty() ? "none" : names, taxonomy::name(light), taxonomy::name(eye), std::to_string(found.size())}});
    }
  fmt::print("{}", options.json
                       ? report::dump(json)
                       : report::text_table(
                             {{"Strategies for " + plain(word)}, {"Light"}, {"Eye"}, {"Count", report::Align::Right}},
                             rows, console.table_style()));
  return ExitCode::Done;
}

}  // namespace

void add_grammar_strategies(CLI::App& family, Run& chosen) {
  add_command<StrategiesOptions>(family, chosen, "strategies",
                                 "How a path of this word can be found, by kinds of its ends",
                                 "  heckbert grammar strategies LSDSE\n"
                                 "  heckbert grammar strategies LDDE --json\n",
                                 declare, run);
}

}  // namespace heckbert::cli
