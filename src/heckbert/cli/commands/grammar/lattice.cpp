#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/report/lattice_svg.h>
#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/lattice.h>

namespace heckbert::cli {
namespace {

struct LatticeOptions {
  std::vector<std::string> grammars;
  bool dot = false, svg = false;
  ConditionFlags conditions;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, LatticeOptions& options) {
  command.add_option("GRAMMAR", options.grammars, "names, .grammar files or expressions; none: all that are built in");
  command.add_flag("--dot", options.dot, "print for Graphviz to draw");
  command.add_flag("--svg", options.svg, "print a picture");
  add_conditions(command, options.conditions);
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

std::vector<taxonomy::NamedLanguage> languages_of(const LatticeOptions& options, const Settings& settings) {
  std::vector<taxonomy::Grammar> grammars = find_grammars(options.grammars, "GRAMMAR", settings);
  if (grammars.empty()) grammars = taxonomy::builtin_grammars().grammars;
  const taxonomy::Language possible = taxonomy::possible_words(conditions_of(options.conditions));
  std::vector<taxonomy::NamedLanguage> languages;
  for (const taxonomy::Grammar& g : grammars) {
    taxonomy::Language language = taxonomy::apply(settings.glossy, g.language) & possible;
    // What captures nothing here would be below everything and tell nothing.
    if (!language.is_empty()) languages.push_back({g.name, std::move(language)});
  }
  return languages;
}

std::string title_of(const taxonomy::LatticeNode& node) {
  return fmt::format("{}", fmt::join(node.names, " = "));
}

std::string text_of(const taxonomy::Lattice& lattice, const report::TextStyle& style) {
  std::vector<report::TextRow> rows;
  for (std::size_t i = 0; i < lattice.nodes.size(); ++i) {
    report::TextRow row{{title_of(lattice.nodes[i]), "", ""}};
    for (const taxonomy::LatticeEdge& edge : lattice.edges) {
      if (edge.below != i) continue;
      row.cells[1] = title_of(lattice.nodes[edge.above]);
      row.cells[2] = show(edge.witness);
      rows.push_back(row);
      row.cells[0] = "";
    }
    if (!row.cells[0].empty()) rows.push_back(row);
  }
  return report::text_table({{"All of"}, {"is in"}, {"which also has"}}, rows, style);
}

ExitCode run(const LatticeOptions& options) {
  if (options.dot + options.svg + options.json > 1) throw UsageError("one of --dot, --svg and --json, please");
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const taxonomy::Lattice lattice = taxonomy::lattice(languages_of(options, settings));
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_lattice");
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["conditions"] = to_json(conditions_of(options.conditions));
    json["nodes"] = report::Json::array();
    for (const taxonomy::LatticeNode& node : lattice.nodes)
      json["nodes"].push_back({{"names", node.names}, {"level", node.level}});
    json["edges"] = report::Json::array();
    for (const taxonomy::LatticeEdge& edge : lattice.edges)
      json["edges"].push_back({{"below", edge.below}, {"above", edge.above}, {"witness", show(edge.witness)}});
    fmt::print("{}", report::dump(json));
  } else {
    fmt::print("{}", options.dot   ? taxonomy::dot(lattice)
                     : options.svg ? report::lattice_svg(lattice)
                                   : text_of(lattice, console.table_style()));
  }
  return ExitCode::Done;
}

}  // namespace

void add_grammar_lattice(CLI::App& family, Run& chosen) {
  add_command<LatticeOptions>(family, chosen, "lattice",
                              "Which grammar is part of which, and what the other has beyond",
                              "  heckbert grammar lattice\n"
                              "  heckbert grammar lattice --lights La --eye Ep --svg > lattice.svg\n"
                              "  heckbert grammar lattice whitted radiosity 'LD?E' --dot\n",
                              declare, run);
}

}  // namespace heckbert::cli
