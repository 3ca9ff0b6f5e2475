#include <string>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/taxonomy/dot.h>

namespace heckbert::cli {
namespace {

struct DotOptions {
  std::string expression;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, DotOptions& options) {
  command.add_option("EXPR", options.expression, "name, .grammar file or expression")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

ExitCode run(const DotOptions& options) {
  const Settings settings = resolve(options.flags);
  const Operand asked = operand(options.expression, settings);
  const std::string drawing = taxonomy::dot(asked.language, asked.text);
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_dot");
    json["expression"] = asked.text;
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["states"] = asked.language.states().size();
    json["dot"] = drawing;
    fmt::print("{}", report::dump(json));
  } else {
    fmt::print("{}", drawing);
  }
  return ExitCode::Done;
}

}  // namespace

void add_grammar_dot(CLI::App& family, Run& chosen) {
  add_command<DotOptions>(family, chosen, "dot", "The minimal automaton, for Graphviz to draw",
                          "  heckbert grammar dot whitted | dot -Tsvg -o whitted.svg\n", declare, run);
}

}  // namespace heckbert::cli
