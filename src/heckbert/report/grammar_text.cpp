#include <heckbert/report/grammar_text.h>

#include <array>

#include <fmt/format.h>

#include <heckbert/report/json_parts.h>
#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

using taxonomy::Grammar;
using taxonomy::GrammarKind;

struct KindFacts {
  GrammarKind kind;
  std::string_view name, title;
};
constexpr std::array<KindFacts, 2> kKinds{{
    {GrammarKind::Algorithm, "algorithm", "Algorithm"},
    {GrammarKind::Class, "class", "Class"},
}};

const KindFacts& facts_of(GrammarKind kind) {
  return kKinds[kind == GrammarKind::Algorithm ? 0 : 1];
}

std::string shortest_word(const Grammar& grammar) {
  const auto word = grammar.language.shortest_word();
  return word ? plain(*word) : std::string();
}

Json to_json(const Grammar& grammar) {
  return {{"kind", facts_of(grammar.kind).name},
          {"name", grammar.name},
          {"title", grammar.title},
          {"source", grammar.source},
          {"expression", grammar.expression},
          {"expression_delta", grammar.expression_delta},
          {"biases", grammar.biases},
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
  std::string text;
  for (const KindFacts& kind : kKinds) {
    std::vector<TextRow> rows;
    for (const Grammar& grammar : library.grammars)
      if (grammar.kind == kind.kind) rows.push_back({.cells = {grammar.title, grammar.name, grammar.expression}});
    if (rows.empty()) continue;
    if (!text.empty()) text += '\n';
    text += text_table({{std::string(kind.title)}, {"Name"}, {"Expression"}}, rows, style);
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
  std::string text = bold(grammar.title, style) + fmt::format(" ({} {})\n", facts_of(grammar.kind).name, grammar.name);
  if (grammar.expression_delta.empty()) {
    text += field("Expression", grammar.expression, style);
  } else {
    text += field("Expression", grammar.expression + "  for lights that a ray can hit (La, Le)", style);
    text += field("", grammar.expression_delta + "  for lights that it cannot (Lp, Ld)", style);
  }
  text += field("Source", grammar.source, style);
  for (const std::string& bias : grammar.biases) text += field("Bias", bias, style);
  text += field("Notes", grammar.notes, style);
  text += field("Automaton", counted(grammar.language.states().size(), "state"), style);
  text += field("Shortest", shortest_word(grammar), style);
  return text;
}

std::string grammar_json(const Grammar& grammar) {
  Json document = document_of("heckbert.grammar");
  document["grammar"] = to_json(grammar);
  return dump(document);
}

}  // namespace heckbert::report
