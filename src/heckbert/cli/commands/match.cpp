#include <iostream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/never.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/explain.h>

namespace heckbert::cli {
namespace {

struct MatchOptions {
  std::string expression;
  std::vector<std::string> words;  ///< none, or "-": read from standard input
  bool explain = false;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, MatchOptions& options) {
  command.add_option("EXPR", options.expression, "expression, @name or .grammar file")->required();
  command.add_option("WORD", options.words, "words such as LDSE or LaDrSrEp; none, or '-': from standard input");
  command.add_flag("--explain", options.explain, "say where each word stops matching");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

constexpr const char* kMatchExamples =
    "  heckbert match 'LD?S*E' LDSE LDDE\n"
    "  heckbert match 'LD?S*E' LDDE --explain\n"
    "  heckbert match @whitted < words.txt\n";

std::vector<std::string> words_of(const MatchOptions& options) {
  if (!options.words.empty() && options.words != std::vector<std::string>{"-"}) return options.words;
  std::vector<std::string> words;
  for (std::string word; std::cin >> word;) words.push_back(word);
  return words;
}

ExitCode run(const MatchOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const taxonomy::Grammar grammar = find_grammar(options.expression, "EXPR", settings);
  const taxonomy::Language language = taxonomy::apply(settings.glossy, grammar.language);

  report::Json json = report::document_of("heckbert.match");
  json["expression"] = options.expression;
  json["glossy_rule"] = report::name_of(settings.glossy);
  json["words"] = report::Json::array();
  bool all_match = true;
  std::vector<Diagnostic> errors;
  for (const std::string& text : words_of(options)) {
    try {
      const taxonomy::Word word = taxonomy::parse_word(text);
      const bool matches = language.contains(word);
      all_match = all_match && matches;
      const std::string why = options.explain ? taxonomy::describe(taxonomy::explain(language, word), word) : "";
      json["words"].push_back({{"word", text}, {"matches", matches}, {"explanation", why}});
      if (!options.json)
        fmt::print("{} {}\n", console.paint(matches ? Style::Good : Style::Bad, matches ? "yes" : "no "),
                   why.empty() ? text : why);
    } catch (const InputError& error) {
      // The other words still get their answers.
      errors.insert(errors.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }
  if (options.json) fmt::print("{}", report::dump(json));
  console.note(never_text(grammar, settings.glossy));
  if (!errors.empty()) throw InputError(std::move(errors));
  return all_match ? ExitCode::Done : ExitCode::No;
}

}  // namespace

void add_match(CLI::App& app, Run& chosen) {
  add_command<MatchOptions>(app, chosen, "match", "Does each word match an expression?", kMatchExamples, declare, run);
}

}  // namespace heckbert::cli
