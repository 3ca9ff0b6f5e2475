#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/explain.h>

namespace heckbert::cli {
namespace {

struct ExplainOptions {
  std::string expression, word;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, ExplainOptions& options) {
  command.add_option("EXPR", options.expression, "name, .grammar file or expression")->required();
  command.add_option("WORD", options.word, "a word such as LDSE or LaDrSrEp")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

ExitCode run(const ExplainOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const Operand asked = operand(options.expression, settings);
  const taxonomy::Word word = taxonomy::parse_word(options.word);
  const taxonomy::Explanation explanation = taxonomy::explain(asked.language, word);
  const std::vector<taxonomy::Step> steps = taxonomy::trace(asked.language, word);
  const std::string verdict = taxonomy::describe(explanation, word);

  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_explain");
    json["expression"] = asked.text;
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["word"] = fine(word);
    json["answer"] = explanation.matches;
    json["explanation"] = verdict;
    json["steps"] = report::Json::array();
    for (const taxonomy::Step& step : steps)
      json["steps"].push_back({{"state", step.from},
                               {"expected", step.expected.is_empty() ? "" : taxonomy::write(step.expected)},
                               {"letter", taxonomy::name(step.letter)},
                               {"next", step.to ? static_cast<std::int64_t>(*step.to) : -1}});
    fmt::print("{}", report::dump(json));
  } else {
    std::vector<report::TextRow> rows;
    for (const taxonomy::Step& step : steps)
      rows.push_back(
          {{fmt::format("{}", step.from), step.expected.is_empty() ? "nothing" : taxonomy::describe(step.expected),
            taxonomy::name(step.letter), step.to ? fmt::format("{}", *step.to) : "nowhere"}});
    fmt::print("{}\n{}\n",
               report::text_table({{"State"}, {"Expected"}, {"Letter"}, {"Goes to"}}, rows, console.table_style()),
               console.paint(explanation.matches ? Style::Good : Style::Bad, verdict));
  }
  return explanation.matches ? ExitCode::Done : ExitCode::No;
}

}  // namespace

void add_grammar_explain(CLI::App& family, Run& chosen) {
  add_command<ExplainOptions>(family, chosen, "explain", "The walk of a word through an automaton, state by state",
                              "  heckbert grammar explain whitted LDSE\n"
                              "  heckbert grammar explain 'LD?S*E' LSDE --json\n",
                              declare, run);
}

}  // namespace heckbert::cli
