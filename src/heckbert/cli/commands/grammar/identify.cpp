#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/taxonomy/identification.h>

namespace heckbert::cli {
namespace {

using taxonomy::Neighbour;

struct IdentifyOptions {
  std::string expression;
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, IdentifyOptions& options) {
  command.add_option("EXPR", options.expression, "name, .grammar file or expression")->required();
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

std::string title_of(const Neighbour& neighbour) {
  return describe(taxonomy::Match{neighbour.grammar, neighbour.form, 0});
}

report::Json json_of(const std::vector<Neighbour>& neighbours) {
  report::Json json = report::Json::array();
  for (const Neighbour& n : neighbours)
    json.push_back({{"name", n.grammar->name}, {"description", title_of(n)}, {"witness", show(n.witness)}});
  return json;
}

ExitCode run(const IdentifyOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const Operand asked = operand(options.expression, settings);
  const taxonomy::Identification found = taxonomy::identify(asked.language, taxonomy::builtin_grammars());
  const std::string never = never_text(asked);

  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_identify");
    json["expression"] = asked.text;
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["answer"] = !found.same.empty();
    json["never"] = never;
    json["same"] = report::Json::array();
    for (const taxonomy::Match& m : found.same)
      json["same"].push_back({{"name", m.grammar->name}, {"description", describe(m)}});
    json["containing"] = json_of(found.containing);
    json["contained"] = json_of(found.contained);
    fmt::print("{}", report::dump(json));
  } else {
    for (const taxonomy::Match& m : found.same) fmt::print("{} ({})\n", describe(m), m.grammar->name);
    if (found.same.empty()) fmt::print("{}\n", console.paint(Style::Bad, "no known grammar"));
    for (const Neighbour& n : found.containing)
      fmt::print("part of {} ({}), which also has {}\n", title_of(n), n.grammar->name, show(n.witness));
    for (const Neighbour& n : found.contained)
      fmt::print("more than {} ({}), which lacks {}\n", title_of(n), n.grammar->name, show(n.witness));
    console.note(never);
  }
  return found.same.empty() ? ExitCode::No : ExitCode::Done;
}

}  // namespace

void add_grammar_identify(CLI::App& family, Run& chosen) {
  add_command<IdentifyOptions>(family, chosen, "identify",
                               "Which known algorithm or class is this? The nearest, if none",
                               "  heckbert grammar identify 'LNS*E'\n"
                               "  heckbert grammar identify 'L(D|S)*E'\n",
                               declare, run);
}

}  // namespace heckbert::cli
