#include <string>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/phases.h>

namespace heckbert::cli {
namespace {

struct PhasesOptions {
  std::string expression;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, PhasesOptions& options) {
  command.add_option("EXPR", options.expression, "an expression; a name is written @name")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {});
}

ExitCode run(const PhasesOptions& options) {
  const Console console(resolve(options.flags));
  const taxonomy::Phases phases = taxonomy::phases(options.expression, taxonomy::builtin_grammars().names(), "EXPR");
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_phases");
    json["expression"] = options.expression;
    json["tree"] = phases.tree;
    json["parts"] = report::Json::array();
    for (const taxonomy::PartPhases& part : phases.parts)
      json["parts"].push_back({{"expression", part.expression},
                               {"positions", part.positions},
                               {"subsets", part.subsets},
                               {"deterministic", part.deterministic}});
    json["minimal"] = phases.minimal;
    json["states"] = phases.states;
    fmt::print("{}", report::dump(json));
    return ExitCode::Done;
  }
  fmt::print("Tree\n{}", phases.tree);
  for (const taxonomy::PartPhases& part : phases.parts)
    fmt::print("\nLetters of {}, and which may follow\n{}\nDeterministic: {} sets of letters\n{}", part.expression,
               part.positions, part.deterministic, part.subsets);
  fmt::print("\nMinimal: {} states\n{}", phases.states, phases.minimal);
  return ExitCode::Done;
}

}  // namespace

void add_grammar_phases(CLI::App& family, Run& chosen) {
  add_command<PhasesOptions>(family, chosen, "phases", "From the text to the minimal automaton, step by step",
                             "  heckbert grammar phases 'L(D|S)*DE'\n"
                             "  heckbert grammar phases 'LX*E - @whitted' --json\n",
                             declare, run);
}

}  // namespace heckbert::cli
