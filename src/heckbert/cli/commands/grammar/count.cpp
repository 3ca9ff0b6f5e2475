#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/counting.h>
#include <heckbert/taxonomy/enumeration.h>

namespace heckbert::cli {
namespace {

struct CountOptions {
  std::string expression;
  ConditionFlags conditions{.lights = "La", .eye = "Ep", .letters = {}, .max_depth = "10"};
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, CountOptions& options) {
  command.add_option("EXPR", options.expression, "name, .grammar file or expression")->required();
  ConditionFlags& c = options.conditions;
  command.add_option("--lights", c.lights, "the kind of light; of several, each counts (default La)")
      ->type_name("LIST");
  command.add_option("--eye", c.eye, "the kind of eye; of several, each counts (default Ep)")->type_name("LIST");
  command.add_option("--letters", c.letters, "the letters, each counted once: D,S; else Dr,Dt,Gr,Gt,Sr,St,V")
      ->type_name("LIST");
  command.add_option("--max-depth", c.max_depth, "the largest number of scatterings (default 10)")->type_name("N");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

/// The words to count: in the letters asked for, with every end kept apart.
taxonomy::Language counted(const CountOptions& options, const Operand& asked, taxonomy::Conditions conditions) {
  conditions.max_length.reset();
  taxonomy::Language language = asked.language & taxonomy::possible_words(conditions);
  if (options.conditions.letters.empty()) return language;
  std::vector<taxonomy::SymbolSet> letters = letters_of(options.conditions);
  for (const taxonomy::Symbol s : taxonomy::members(taxonomy::kLights | taxonomy::kEyes))
    letters.push_back(taxonomy::single(s));
  return taxonomy::read_as(language, letters);
}

report::Json function_json(const std::optional<taxonomy::GeneratingFunction>& function) {
  report::Json json{{"text", function ? write(*function) : ""},
                    {"numerator", report::Json::array()},
                    {"denominator", report::Json::array()}};
  if (!function) return json;
  for (const std::int64_t c : function->numerator) json["numerator"].push_back(c);
  for (const std::int64_t c : function->denominator) json["denominator"].push_back(c);
  return json;
}

ExitCode run(const CountOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const Operand asked = operand(options.expression, settings);
  const taxonomy::Conditions conditions = conditions_of(options.conditions);
  const taxonomy::Language language = counted(options, asked, conditions);
  const std::vector<taxonomy::Natural> counts = count_words(language, *conditions.max_length);
  const auto function = generating_function(language);
  const std::string never = never_text(asked, conditions);

  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_count");
    json["expression"] = options.expression;
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["conditions"] = to_json(conditions);
    json["never"] = never;
    json["counts"] = report::Json::array();
    for (const taxonomy::Natural& n : counts) json["counts"].push_back(to_string(n));
    json["generating_function"] = function_json(function);
    fmt::print("{}", report::dump(json));
    return ExitCode::Done;
  }
  std::vector<report::TextRow> rows;
  for (std::size_t n = 0; n < counts.size(); ++n) rows.push_back({{std::to_string(n), to_string(counts[n])}});
  fmt::print("{}", report::text_table({{"Scatterings", report::Align::Right}, {"Words", report::Align::Right}}, rows,
                                      console.table_style()));
  if (function)
    fmt::print("\nGenerating function: {}\n", write(*function));
  else
    console.note("no generating function: the automaton is too large");
  console.note(never);
  return ExitCode::Done;
}

}  // namespace

void add_grammar_count(CLI::App& family, Run& chosen) {
  add_command<CountOptions>(family, chosen, "count", "How many words of each length, and their generating function",
                            "  heckbert grammar count 'L(S?D)*S*E' --letters D,S\n"
                            "  heckbert grammar count path-tracing --lights Lp --max-depth 5 --json\n",
                            declare, run);
}

}  // namespace heckbert::cli
