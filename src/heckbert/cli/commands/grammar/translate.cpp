// grammar translate

#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/error_codes.h>

namespace heckbert::cli {
namespace {

using taxonomy::Dialect;
using taxonomy::DialectFacts;
using taxonomy::Translation;

struct TranslateOptions {
  std::string expression;
  const DialectFacts* from = &taxonomy::facts(Dialect::Heckbert);
  const DialectFacts* to = &taxonomy::facts(Dialect::Heckbert);
  bool json = false;
  SettingFlags flags;
};

void add_dialect(CLI::App& command, const std::string& flag, const DialectFacts*& dialect, const std::string& help) {
  const auto read = [flag, &dialect](const std::string& text) {
    dialect = &choose_flag(flag, text, taxonomy::kDialects);
  };
  command.add_option_function<std::string>(flag, read, help)->type_name("DIALECT");
}

void declare_translate(CLI::App& command, TranslateOptions& options) {
  command.add_option("EXPR", options.expression, "expression; from heckbert also a name or .grammar file")->required();
  add_dialect(command, "--from", options.from, "the dialect that EXPR is written in (default: heckbert)");
  add_dialect(command, "--to", options.to, "the dialect to write (default: heckbert)");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {});
}

Translation translation(const TranslateOptions& options) {
  if (options.from->dialect == Dialect::Heckbert) {
    const taxonomy::Grammar grammar = find_grammar(options.expression, "EXPR", {});
    const bool is_named = grammar.expression != options.expression;
    if (is_named)
      return {{grammar.language, {}, {}}, taxonomy::write_expression(grammar.language, options.to->dialect), {}, false};
  }
  return taxonomy::translate(options.expression, options.from->dialect, options.to->dialect,
                             taxonomy::builtin_grammars().names(), "EXPR");
}

/// The dialect that alone has the word on which the same text differs; empty when it does not differ.
std::string_view owner(const Translation& t, const TranslateOptions& options) {
  if (!t.differs_on) return "";
  return t.only_in_from ? options.from->name : options.to->name;
}

std::vector<std::string> warnings_of(const Translation& t, const TranslateOptions& options) {
  std::vector<std::string> warnings;
  for (const Diagnostic& d : t.reading.warnings) warnings.push_back(taxonomy::warning_text(d));
  if (t.differs_on)
    warnings.push_back(fmt::format("the same text means something else in {}: {} is in it under {} only",
                                   options.to->title, show(*t.differs_on),
                                   t.only_in_from ? options.from->title : options.to->title));
  return warnings;
}

ExitCode run_translate(const TranslateOptions& options) {
  const Console console(resolve(options.flags));
  const Translation t = translation(options);
  const std::vector<std::string> warnings = warnings_of(t, options);
  for (const std::string& warning : warnings) console.note("warning: " + warning);
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_translate");
    json["expression"] = options.expression;
    json["from"] = options.from->name;
    json["to"] = options.to->name;
    json["text"] = t.writing.text;
    json["refusal"] = t.writing.refusal;
    json["prefixes"] = t.reading.prefixes;
    json["warnings"] = warnings;
    json["differs_on"] = t.differs_on ? show(*t.differs_on) : "";
    json["differs_in"] = owner(t, options);
    fmt::print("{}", report::dump(json));
  } else if (t.writing.refusal.empty()) {
    fmt::print("{}\n", t.writing.text);
  } else {
    fmt::print("{}: {}\n", console.paint(Style::Bad, fmt::format("cannot be said in {}", options.to->title)),
               t.writing.refusal);
  }
  return t.writing.refusal.empty() ? ExitCode::Done : ExitCode::No;
}

}  // namespace

void add_grammar_translate(CLI::App& family, Run& chosen) {
  add_command<TranslateOptions>(family, chosen, "translate",
                                "An expression of one renderer as another one writes it, or why it cannot",
                                "  heckbert grammar translate 'CS*D{0,1}L' --from osl --to vray\n"
                                "  heckbert grammar translate 'LD?S*E' --to osl\n"
                                "  heckbert grammar translate 'C<RD>(.+L|.*[OB])' --from vray --to osl --json\n"
                                "Dialects:\n  " +
                                    alternatives(taxonomy::kDialects) + "\n",
                                declare_translate, run_translate);
}

}  // namespace heckbert::cli
