#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/grammar_text.h>

namespace heckbert::cli {
namespace {

using taxonomy::Grammar;

/// "Captures    LE LDE LSE ...": the shortest words, for lights that a ray can hit and for those that it cannot.
std::string examples_text(const Grammar& grammar) {
  if (!taxonomy::has_language(grammar)) return {};
  constexpr std::size_t kExamplesShown = 8;
  struct Lights {
    taxonomy::Symbol light;
    std::string_view title;
  };
  std::string text;
  for (const bool contained : {true, false}) {
    std::string_view label = contained ? "Captures" : "Misses";
    for (const Lights lights : {Lights{taxonomy::Symbol::La, "area lights"}, {taxonomy::Symbol::Lp, "point lights"}}) {
      const auto words = first_words(grammar.language, lights.light, contained, kExamplesShown);
      text += fmt::format("{:<12}{}  ({})\n", label,
                          words.empty() ? "nothing" : fmt::format("{}", fmt::join(words, " ")), lights.title);
      label = "";
    }
  }
  return text;
}

struct ShowOptions {
  std::vector<std::string> grammars;
  bool json = false;
  SettingFlags flags;
};

void declare_show(CLI::App& command, ShowOptions& options) {
  command.add_option("GRAMMAR", options.grammars, "name, .grammar file or expression")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect});
}

ExitCode run_show(const ShowOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const taxonomy::GrammarLibrary shown{find_described(options.grammars, "GRAMMAR", settings)};
  if (options.json) {
    fmt::print("{}", report::grammar_list_json(shown));
    return ExitCode::Done;
  }
  const char* separator = "";
  for (const Grammar& grammar : shown.grammars) {
    fmt::print("{}{}{}", separator, report::grammar_text(grammar, console.table_style()), examples_text(grammar));
    separator = "\n";
  }
  return ExitCode::Done;
}

}  // namespace

void add_grammar_show(CLI::App& family, Run& chosen) {
  add_command<ShowOptions>(family, chosen, "show", "All that is known of a grammar",
                           "  heckbert grammar show whitted radiosity\n"
                           "  heckbert grammar show 'LS+D(S|D)*E' my.grammar\n",
                           declare_show, run_show);
}

}  // namespace heckbert::cli
