#include <string>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/settings.h>
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
  command.add_option("EXPR", options.expression, "name, .grammar file or expression")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect});
}

taxonomy::Phases phases_of(const std::string& text, const Settings& settings) {
  const taxonomy::Grammar grammar = find_grammar(text, "EXPR", settings);
  if (grammar.expression != text) return taxonomy::phases(grammar);
  return taxonomy::phases(text, settings.dialect, taxonomy::builtin_grammars().names(), "EXPR");
}

report::Json json_of(const taxonomy::FormPhases& form) {
  report::Json json{{"expression", form.expression}, {"lights", form.lights}, {"tree", form.tree}};
  json["parts"] = report::Json::array();
  for (const taxonomy::PartPhases& part : form.parts)
    json["parts"].push_back({{"expression", part.expression},
                             {"positions", part.positions},
                             {"subsets", part.subsets},
                             {"deterministic", part.deterministic}});
  return json;
}

ExitCode run(const PhasesOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const taxonomy::Phases phases = phases_of(options.expression, settings);
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_phases");
    json["expression"] = options.expression;
    json["dialect"] = taxonomy::facts(settings.dialect).name;
    json["forms"] = report::Json::array();
    for (const taxonomy::FormPhases& form : phases.forms) json["forms"].push_back(json_of(form));
    json["minimal"] = phases.minimal;
    json["states"] = phases.states;
    fmt::print("{}", report::dump(json));
    return ExitCode::Done;
  }
  for (const taxonomy::FormPhases& form : phases.forms) {
    if (!form.lights.empty()) fmt::print("{}, for {}\n\n", form.expression, form.lights);
    fmt::print("Tree\n{}\n", form.tree);
    for (const taxonomy::PartPhases& part : form.parts)
      fmt::print("Letters of {}, and which may follow\n{}\nDeterministic: {} sets of letters\n{}\n", part.expression,
                 part.positions, part.deterministic, part.subsets);
  }
  fmt::print("Minimal: {} states\n{}", phases.states, phases.minimal);
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
