#include <heckbert/cli/commands/grammar/operands.h>

#include <fmt/format.h>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/languages.h>
#include <heckbert/cli/never.h>

namespace heckbert::cli {
namespace {

using taxonomy::SymbolSet;

/// "S", "Sr": the symbols so called, of one role. Errors: BadValue.
SymbolSet symbols_called(const std::string& text, SymbolSet role) {
  unsigned found = 0;
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, SymbolSet set) {
    if (text == name) found |= set;
    if (names.empty() || names.back() != name) names.push_back(name);
  };
  for (const taxonomy::Symbol s : taxonomy::members(role)) {
    const SymbolSet whole = taxonomy::with_letter(taxonomy::facts(s).letter);
    if (s == taxonomy::members(whole).front()) add(std::string(1, taxonomy::facts(s).letter), whole);
    add(taxonomy::name(s), taxonomy::single(s));
  }
  if (found == 0) refuse_choice(text, names);
  return static_cast<SymbolSet>(found);
}

std::vector<SymbolSet> read_list(const std::string& flag, const std::string& text, SymbolSet role) {
  return value_of_flag(flag, [&] {
    std::vector<SymbolSet> list;
    for (const std::string& item : split(text, ',')) list.push_back(symbols_called(item, role));
    return list;
  });
}

SymbolSet read_set(const std::string& flag, const std::string& text, SymbolSet role) {
  if (text.empty()) return role;
  unsigned set = 0;
  for (const SymbolSet item : read_list(flag, text, role)) set |= item;
  return static_cast<SymbolSet>(set);
}

report::Json names_of_symbols(SymbolSet set) {
  report::Json names = report::Json::array();
  for (const taxonomy::Symbol s : taxonomy::members(set)) names.push_back(taxonomy::name(s));
  return names;
}

}  // namespace

std::vector<Operand> operands(const std::vector<std::string>& texts, const Settings& settings) {
  const std::vector<taxonomy::Grammar> grammars = find_grammars(texts, "argument", settings);
  std::vector<Operand> list;
  for (std::size_t i = 0; i < texts.size(); ++i)
    list.push_back({texts[i], taxonomy::apply(settings.glossy, grammars[i].language), grammars[i], settings.glossy});
  return list;
}

Operand operand(const std::string& text, const Settings& settings) {
  return operands({text}, settings).front();
}

void add_conditions(CLI::App& command, ConditionFlags& flags) {
  command.add_option("--lights", flags.lights, "the kinds of light there are, such as La,Lp")->type_name("LIST");
  command.add_option("--eye", flags.eye, "the kind of eye: Ep or El")->type_name("LIST");
  command.add_option("--letters", flags.letters, "the events there are, such as D,S or Dr,Sr,St")->type_name("LIST");
  command.add_option("--max-depth", flags.max_depth, "the largest number of scatterings")->type_name("N");
}

taxonomy::Conditions conditions_of(const ConditionFlags& flags) {
  taxonomy::Conditions conditions;
  conditions.lights = read_set("--lights", flags.lights, taxonomy::kLights);
  conditions.eyes = read_set("--eye", flags.eye, taxonomy::kEyes);
  conditions.events = read_set("--letters", flags.letters, taxonomy::kEvents);
  constexpr std::uint64_t kDeepest = 10'000;
  if (!flags.max_depth.empty())
    conditions.max_length = value_of_flag("--max-depth", [&] { return whole_number(flags.max_depth, 0, kDeepest); });
  return conditions;
}

std::vector<SymbolSet> letters_of(const ConditionFlags& flags) {
  const std::vector<SymbolSet> letters = read_list("--letters", flags.letters, taxonomy::kEvents);
  unsigned seen = 0;
  for (const SymbolSet letter : letters) {
    if ((seen & letter) != 0)
      throw UsageError(fmt::format("--letters: two of '{}' stand for the same events", flags.letters));
    seen |= letter;
  }
  return letters;
}

report::Json to_json(const taxonomy::Conditions& conditions) {
  return {{"lights", names_of_symbols(conditions.lights)},
          {"eyes", names_of_symbols(conditions.eyes)},
          {"events", names_of_symbols(conditions.events)},
          {"max_depth", conditions.max_length ? static_cast<std::int64_t>(*conditions.max_length) : -1}};
}

std::string never_text(const Operand& operand, const taxonomy::Conditions& conditions) {
  return never_text(operand.grammar, operand.rule, conditions);
}

}  // namespace heckbert::cli
