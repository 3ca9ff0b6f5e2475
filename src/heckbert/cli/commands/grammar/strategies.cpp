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
  std::vector<std::string> words;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, StrategiesOptions& options) {
  command.add_option("WORD", options.words, "words such as LSDE; ends of every kind; several: only counts")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {});
}

/// The word with ends of these kinds, and how it can be found.
struct Found {
  taxonomy::Symbol light, eye;
  std::vector<taxonomy::Strategy> strategies;
};

std::vector<Found> for_all_ends(taxonomy::Word word) {
  std::vector<Found> all;
  for (const taxonomy::Symbol light : taxonomy::members(taxonomy::kLights))
    for (const taxonomy::Symbol eye : taxonomy::members(taxonomy::kEyes)) {
      word.light = light;
      word.eye = eye;
      all.push_back({light, eye, taxonomy::strategies(word)});
    }
  return all;
}

report::Json json_of(const taxonomy::Word& word) {
  report::Json ends = report::Json::array();
  for (const Found& found : for_all_ends(word)) {
    report::Json list = report::Json::array();
    for (const taxonomy::Strategy& s : found.strategies)
      list.push_back({{"name", s.name}, {"light_vertices", s.light_vertices}, {"eye_vertices", s.eye_vertices}});
    ends.push_back({{"light", taxonomy::name(found.light)},
                    {"eye", taxonomy::name(found.eye)},
                    {"count", found.strategies.size()},
                    {"strategies", std::move(list)}});
  }
  return {{"word", plain(word)}, {"ends", std::move(ends)}};
}

std::string named_strategies(const taxonomy::Word& word, const report::TextStyle& style) {
  std::vector<report::TextRow> rows;
  for (const Found& found : for_all_ends(word)) {
    std::string names;
    for (const taxonomy::Strategy& s : found.strategies) names += (names.empty() ? "" : ", ") + std::string(s.name);
    rows.push_back({{names.empty() ? "none" : names, taxonomy::name(found.light), taxonomy::name(found.eye),
                     std::to_string(found.strategies.size())}});
  }
  return report::text_table({{"Strategies for " + plain(word)}, {"Light"}, {"Eye"}, {"Count", report::Align::Right}},
                            rows, style);
}

std::string counted_strategies(const std::vector<taxonomy::Word>& words, const report::TextStyle& style) {
  std::vector<report::TextColumn> columns{{"Strategies for"}};
  for (const Found& found : for_all_ends(words.front()))
    columns.push_back({taxonomy::name(found.light) + " " + taxonomy::name(found.eye), report::Align::Right});
  std::vector<report::TextRow> rows;
  for (const taxonomy::Word& word : words) {
    rows.push_back({{plain(word)}});
    for (const Found& found : for_all_ends(word)) rows.back().cells.push_back(std::to_string(found.strategies.size()));
  }
  return report::text_table(columns, rows, style);
}

ExitCode run(const StrategiesOptions& options) {
  const Console console(resolve(options.flags));
  std::vector<taxonomy::Word> words;
  for (const std::string& text : options.words) words.push_back(taxonomy::parse_word(text));
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_strategies");
    json["words"] = report::Json::array();
    for (const taxonomy::Word& word : words) json["words"].push_back(json_of(word));
    fmt::print("{}", report::dump(json));
  } else {
    fmt::print("{}", words.size() == 1 ? named_strategies(words.front(), console.table_style())
                                       : counted_strategies(words, console.table_style()));
  }
  return ExitCode::Done;
}

}  // namespace

void add_grammar_strategies(CLI::App& family, Run& chosen) {
  add_command<StrategiesOptions>(family, chosen, "strategies",
                                 "How a path of this word can be found, by kinds of its ends",
                                 "  heckbert grammar strategies LSDSE\n"
                                 "  heckbert grammar strategies LE LDE LSE LDSE LSDE LSSE LSDSE\n"
                                 "  heckbert grammar strategies LDDE --json\n",
                                 declare, run);
}

}  // namespace heckbert::cli
