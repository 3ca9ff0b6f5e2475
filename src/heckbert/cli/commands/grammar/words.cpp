#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/operands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/taxonomy/enumeration.h>

namespace heckbert::cli {
namespace {

struct WordsOptions {
  std::string expression;
  std::size_t count = 0;  ///< 0: not given
  bool plain = false;
  ConditionFlags conditions;
  bool json = false;
  SettingFlags flags;
};

constexpr std::size_t kShown = 20;          // without --count and --max-depth
constexpr std::size_t kAtMost = 1'000'000;  // without --count

void declare(CLI::App& command, WordsOptions& options) {
  command.add_option("EXPR", options.expression, "name, .grammar file or expression")->required();
  add_count(command, "--count", options.count, "how many; else 20, or all when there is a --max-depth");
  command.add_flag("--plain", options.plain, "plain letters, LDSE for LaDrStEp and its like");
  add_conditions(command, options.conditions);
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {Scope::Dialect, Scope::Glossy});
}

ExitCode run(const WordsOptions& options) {
  const Settings settings = resolve(options.flags);
  const Console console(settings);
  const Operand asked = operand(options.expression, settings);
  const taxonomy::Conditions conditions = conditions_of(options.conditions);
  taxonomy::Conditions any_length = conditions;
  any_length.max_length.reset();
  taxonomy::Language language = asked.language & taxonomy::possible_words(any_length);
  if (options.plain) language = taxonomy::plain_words(language);

  std::size_t count = options.count;
  if (count == 0) count = conditions.max_length ? kAtMost : kShown;
  // One more than asked for tells whether there are more.
  std::vector<taxonomy::Word> words =
      taxonomy::first_words(language, {.count = count + 1, .max_length = conditions.max_length});
  const bool more = words.size() > count;
  if (more) words.resize(count);

  const std::string never = never_text(asked, conditions);
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_words");
    json["expression"] = options.expression;
    json["glossy_rule"] = report::name_of(settings.glossy);
    json["conditions"] = to_json(conditions);
    json["never"] = never;
    json["words"] = report::Json::array();
    for (const taxonomy::Word& word : words) json["words"].push_back(options.plain ? plain(word) : fine(word));
    json["more"] = more;
    fmt::print("{}", report::dump(json));
    return ExitCode::Done;
  }
  for (const taxonomy::Word& word : words) fmt::print("{}\n", options.plain ? plain(word) : fine(word));
  console.note(never);
  if (more) console.note(fmt::format("there are more than {}", count));
  return ExitCode::Done;
}

}  // namespace

void add_grammar_words(CLI::App& family, Run& chosen) {
  add_command<WordsOptions>(family, chosen, "words", "The words of a language, shortest first",
                            "  heckbert grammar words whitted --plain\n"
                            "  heckbert grammar words 'LS+DE' --lights Lp --eye Ep --letters D,St --max-depth 4\n",
                            declare, run);
}

}  // namespace heckbert::cli
