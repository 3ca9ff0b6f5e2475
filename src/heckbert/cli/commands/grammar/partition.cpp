// grammar disjoint and grammar partition

#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/taxonomy/partition.h>

namespace heckbert::cli {
namespace {

struct ClassesOptions {
  std::vector<std::string> classes;
  std::string within;  ///< empty: all words
  ConditionFlags conditions;
  bool json = false;
  SettingFlags flags;
};

void declare_disjoint(CLI::App& command, ClassesOptions& options) {
  command.add_option("CLASS", options.classes, "names, .grammar files or expressions")->required()->expected(2, -1);
  command.add_flag("--json", options.json, "print the answer as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

void declare_partition(CLI::App& command, ClassesOptions& options) {
  command.add_option("CLASS", options.classes, "names, .grammar files or expressions")->required();
  command.add_option("--within", options.within, "the words to divide: a name, .grammar file or expression")
      ->type_name("EXPR");
  add_conditions(command, options.conditions);
  command.add_flag("--json", options.json, "print the answer as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

struct Asked {
  std::vector<Operand> operands;
  taxonomy::Conditions conditions;
  taxonomy::Language whole;
  taxonomy::Partition answer;
};

Asked ask(const ClassesOptions& options, const Settings& settings, const Console& console) {
  Asked asked{operands(options.classes, settings), conditions_of(options.conditions), {}, {}};
  asked.whole = taxonomy::possible_words(asked.conditions);
  if (!options.within.empty()) {
    const Operand within = operand(options.within, settings);
    console.note(never_text(within, asked.conditions));
    asked.whole = asked.whole & within.language;
  }
  std::vector<taxonomy::Language> languages;
  for (const Operand& o : asked.operands) {
    console.note(never_text(o, asked.conditions));
    languages.push_back(o.language);
  }
  asked.answer = taxonomy::partition(languages, asked.whole);
  return asked;
}

report::Json document(std::string_view schema, const Asked& asked, const Settings& settings, bool holds) {
  report::Json json = report::document_of(schema);
  json["classes"] = report::Json::array();
  for (const Operand& o : asked.operands) json["classes"].push_back(o.text);
  json["glossy_rule"] = report::name_of(settings.glossy);
  json["answer"] = holds;
  json["overlaps"] = report::Json::array();
  for (const taxonomy::Overlap& o : asked.answer.overlaps)
    json["overlaps"].push_back({{"first", asked.operands[o.first].text},
                                {"second", asked.operands[o.second].text},
                                {"word", show(o.shortest)}});
  return json;
}

std::string overlaps_text(const Asked& asked) {
  std::string text;
  for (const taxonomy::Overlap& o : asked.answer.overlaps)
    text += fmt::format("{} is in both {} and {}\n", show(o.shortest), asked.operands[o.first].text,
                        asked.operands[o.second].text);
  return text;
}

std::string yes_or_no(const Console& console, bool holds) {
  return holds ? console.paint(Style::Good, "yes") : console.paint(Style::Bad, "no");
}

ExitCode run_disjoint(const ClassesOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const Asked asked = ask(options, settings, console);
  const bool holds = asked.answer.is_disjoint();
  if (options.json)
    fmt::print("{}", report::dump(document("heckbert.grammar_disjoint", asked, settings, holds)));
  else
    fmt::print("{}\n{}", yes_or_no(console, holds), overlaps_text(asked));
  return holds ? ExitCode::Done : ExitCode::No;
}

ExitCode run_partition(const ClassesOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const Asked asked = ask(options, settings, console);
  const bool holds = asked.answer.is_disjoint() && asked.answer.is_exhaustive();
  const std::string gap = asked.answer.gap ? show(*asked.answer.gap) : "";
  if (options.json) {
    report::Json json = document("heckbert.grammar_partition", asked, settings, holds);
    json["gap"] = gap;
    json["within"] = options.within;
    json["conditions"] = to_json(asked.conditions);
    fmt::print("{}", report::dump(json));
  } else {
    fmt::print("{}\n{}", yes_or_no(console, holds), overlaps_text(asked));
    if (!gap.empty()) fmt::print("{} is in none\n", gap);
  }
  return holds ? ExitCode::Done : ExitCode::No;
}

}  // namespace

void add_grammar_disjoint(CLI::App& family, Run& chosen) {
  add_command<ClassesOptions>(family, chosen, "disjoint",
                              "Do no two of these share a word? The shortest they do, if not",
                              "  heckbert grammar disjoint LDE LSE LGE\n"
                              "  heckbert grammar disjoint whitted radiosity --json\n",
                              declare_disjoint, run_disjoint);
}

void add_grammar_partition(CLI::App& family, Run& chosen) {
  add_command<ClassesOptions>(family, chosen, "partition",
                              "Is every word in exactly one of these? Overlaps and gap if not",
                              "  heckbert grammar partition LE LDX*E 'L[^D].*E' --letters D,G,S\n"
                              "  heckbert grammar partition emission direct indirect\n"
                              "  heckbert grammar partition LDE LDDE --within radiosity --lights Lp --max-depth 2\n",
                              declare_partition, run_partition);
}

}  // namespace heckbert::cli
