#include <heckbert/report/grammar_text.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <heckbert/report/json_parts.h>
#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

using taxonomy::Grammar;
using taxonomy::GrammarKind;

/// A heading of the list, and what stands under it.
struct Section {
  std::string_view title, gist;
  bool (*has)(const Grammar& grammar);
};
constexpr std::array<Section, 4> kSections{{
    {"Algorithm", "Captures", [](const Grammar& g) { return g.kind == GrammarKind::Algorithm && g.is_core; }},
    {"Further algorithm", "Captures", [](const Grammar& g) { return g.kind == GrammarKind::Algorithm && !g.is_core; }},
    {"No language", "Is a", [](const Grammar& g) { return !taxonomy::has_language(g); }},
    {"Class", "Contains", [](const Grammar& g) { return g.kind == GrammarKind::Class; }},
}};

std::string number_of(const Grammar& grammar) {
  return grammar.number ? std::to_string(*grammar.number) : "";
}

/// What it captures, or what else it is.
std::string gist(const Grammar& grammar) {
  if (!taxonomy::has_language(grammar))
    return fmt::format("{}{}{}", facts(grammar.kind).name, grammar.host.empty() ? "" : " of ", grammar.host);
  if (grammar.expression == "none") return grammar.expression_delta + "  (lights that cannot be hit)";
  return grammar.expression;
}

std::string shortest_word(const Grammar& grammar) {
  const auto word = grammar.language.shortest_word();
  return word ? plain(*word) : std::string();
}

Json to_json(const Grammar& grammar) {
  return {{"kind", facts(grammar.kind).name},
          {"name", grammar.name},
          {"title", grammar.title},
          {"number", grammar.number.value_or(0)},
          {"core", grammar.is_core},
          {"has_language", taxonomy::has_language(grammar)},
          {"source", grammar.source},
          {"expression", grammar.expression},
          {"expression_delta", grammar.expression_delta},
          {"host", grammar.host},
          {"biases", grammar.biases},
          {"variances", grammar.variances},
          {"preconditions", grammar.preconditions},
          {"notes", grammar.notes},
          {"states", grammar.language.states().size()},
          {"shortest_word", shortest_word(grammar)}};
}

/// "Label      text", the text wrapped beside its label.
std::string field(std::string_view label, std::string_view value, const TextStyle& style) {
  constexpr std::size_t kLabelWidth = 12;
  if (value.empty()) return {};
  std::string text = wrap(value, style.width, kLabelWidth);
  return bold(fmt::format("{:<{}}", label, kLabelWidth), style) + text.substr(std::min(text.size(), kLabelWidth));
}

}  // namespace

std::string grammar_list_text(const taxonomy::GrammarLibrary& library, const TextStyle& style) {
  std::size_t widest = 0;  // so that the columns of all sections stand under each other
  for (const Grammar& grammar : library.grammars) widest = std::max(widest, display_width(grammar.name));
  constexpr std::size_t kNumberAndGaps = 7;
  const std::size_t room = style.width - std::min(style.width, widest + kNumberAndGaps);
  std::string text;
  for (const Section& section : kSections) {
    std::vector<TextRow> rows;
    for (const Grammar& grammar : library.grammars)
      if (section.has(grammar))
        rows.push_back({.cells = {fmt::format("{:<{}}", grammar.name, widest), number_of(grammar),
                                  cut(gist(grammar), std::max<std::size_t>(room, 8))}});
    if (rows.empty()) continue;
    if (!text.empty()) text += '\n';
    text += text_table({{std::string(section.title)}, {"No.", Align::Right}, {std::string(section.gist)}}, rows, style);
  }
  return text.empty() ? "No grammars.\n" : text;
}

std::string grammar_list_json(const taxonomy::GrammarLibrary& library) {
  Json document = document_of("heckbert.grammars");
  document["grammars"] = Json::array();
  for (const Grammar& grammar : library.grammars) document["grammars"].push_back(to_json(grammar));
  return dump(document);
}

std::string grammar_text(const Grammar& grammar, const TextStyle& style) {
  std::string text = bold(grammar.title, style) + fmt::format(" ({} {})\n", facts(grammar.kind).name, grammar.name);
  if (grammar.expression_delta.empty()) {
    text += field("Expression", grammar.expression, style);
  } else {
    text += field("Expression", grammar.expression + "  for lights that a ray can hit (La, Le)", style);
    text += field("", grammar.expression_delta + "  for lights that it cannot (Lp, Ld)", style);
  }
  if (!taxonomy::has_language(grammar)) text += field("Language", taxonomy::why_no_language(grammar), style);
  text += field("Source", grammar.source, style);
  text += field("Number", number_of(grammar), style);
  for (const std::string& bias : grammar.biases) text += field("Bias", bias, style);
  for (const std::string& variance : grammar.variances) text += field("Variance", variance, style);
  for (const std::string& precondition : grammar.preconditions) text += field("Needs", precondition, style);
  text += field("Notes", grammar.notes, style);
  if (!taxonomy::has_language(grammar)) return text;
  text += field("Automaton", counted(grammar.language.states().size(), "state"), style);
  text += field("Shortest", shortest_word(grammar), style);
  return text;
}

}  // namespace heckbert::report
