// grammar equal and grammar subset

#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/taxonomy/explain.h>

namespace heckbert::cli {
namespace {

using taxonomy::Grammar;
using taxonomy::Language;

struct CompareOptions {
  std::string a, b;
  bool json = false;
  SettingFlags flags;
};

void declare_compare(CLI::App& command, CompareOptions& options) {
  command.add_option("A", options.a, "name, .grammar file or expression")->required();
  command.add_option("B", options.b, "name, .grammar file or expression")->required();
  command.add_flag("--json", options.json, "print the answer as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

/// A shortest word that one language has and the other has not, or nothing.
std::string witness(const Language& with, const Language& without) {
  const auto word = taxonomy::witness_outside(with, without);
  return word ? show(*word) : "";
}

enum class Question : std::uint8_t { Equal, Subset };

ExitCode compare(const CompareOptions& options, Question question) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const std::vector<Grammar> grammars = find_grammars({options.a, options.b}, "argument", settings);
  const Language a = taxonomy::apply(settings.glossy, grammars[0].language);
  const Language b = taxonomy::apply(settings.glossy, grammars[1].language);

  const std::string only_in_a = witness(a, b), only_in_b = witness(b, a);
  const bool equal = question == Question::Equal;
  const bool holds = only_in_a.empty() && (!equal || only_in_b.empty());

  if (options.json) {
    report::Json json = report::document_of(equal ? "heckbert.grammar_equal" : "heckbert.grammar_subset");
    json["a"] = options.a;
    json["b"] = options.b;
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["answer"] = holds;
    json["only_in_a"] = only_in_a;
    json["only_in_b"] = only_in_b;
    fmt::print("{}", report::dump(json));
  } else {
    fmt::print("{}\n", holds ? console.paint(Style::Good, "yes") : console.paint(Style::Bad, "no"));
    if (!only_in_a.empty()) fmt::print("{} is in {} but not in {}\n", only_in_a, options.a, options.b);
    if (equal && !only_in_b.empty()) fmt::print("{} is in {} but not in {}\n", only_in_b, options.b, options.a);
  }
  return holds ? ExitCode::Done : ExitCode::No;
}

ExitCode run_equal(const CompareOptions& options) {
  return compare(options, Question::Equal);
}
ExitCode run_subset(const CompareOptions& options) {
  return compare(options, Question::Subset);
}

}  // namespace

void add_grammar_equal(CLI::App& family, Run& chosen) {
  add_command<CompareOptions>(family, chosen, "equal", "Are two languages the same? A word tells them apart if not",
                              "  heckbert grammar equal 'L(D|S)*E' 'L(D*S*)*E'\n"
                              "  heckbert grammar equal path-tracing '!whitted' --json\n",
                              declare_compare, run_equal);
}

void add_grammar_subset(CLI::App& family, Run& chosen) {
  add_command<CompareOptions>(family, chosen, "subset", "Is all of A in B? The shortest word that is not, if not",
                              "  heckbert grammar subset ray-casting whitted\n"
                              "  heckbert grammar subset LDDE @whitted\n",
                              declare_compare, run_subset);
}

}  // namespace heckbert::cli
