#include <string>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/simplest.h>

namespace heckbert::cli {
namespace {

struct MinimizeOptions {
  std::string expression;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, MinimizeOptions& options) {
  command.add_option("EXPR", options.expression, "name, .grammar file or expression")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

ExitCode run(const MinimizeOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const Operand asked = operand(options.expression, settings);
  const auto simplest = taxonomy::simplest_expression(asked.language);
  if (!simplest) throw LimitError(fmt::format("no readable expression is known for '{}'", asked.text));
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_minimize");
    json["expression"] = asked.text;
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["simplest"] = *simplest;
    json["states"] = asked.language.states().size();
    fmt::print("{}", report::dump(json));
  } else {
    fmt::print("{}\n", *simplest);
    console.note(never_text(asked));
  }
  return ExitCode::Done;
}

}  // namespace

void add_grammar_minimize(CLI::App& family, Run& chosen) {
  add_command<MinimizeOptions>(family, chosen, "minimize", "A short expression of the same language",
                               "  heckbert grammar minimize 'LDE | LSE | LGE'\n"
                               "  heckbert grammar minimize '@whitted - @radiosity'\n",
                               declare, run);
}

}  // namespace heckbert::cli
