#include <heckbert/cli/languages.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <heckbert/cli/choice.h>

#include <heckbert/cli/console.h>
#include <heckbert/cli/files.h>
#include <heckbert/taxonomy/error_codes.h>
#include <heckbert/taxonomy/expression.h>

namespace heckbert::cli {
namespace {

using taxonomy::ErrorCode;
using taxonomy::Grammar;

constexpr std::string_view kAllGrammars = "all";

/// Names begin with a small letter, expressions never do.
bool looks_like_name(std::string_view text) {
  return !text.empty() && std::islower(static_cast<unsigned char>(text.front())) != 0 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
}

Grammar builtin(std::string_view name, std::string_view text, std::string_view what) {
  const taxonomy::GrammarLibrary& library = taxonomy::builtin_grammars();
  if (const Grammar* found = library.find(name)) return *found;
  const std::string near = nearest(name, names_of(library.grammars));
  throw InputError(diagnose(ErrorCode::UnknownName, what, text, text.size() - name.size(), name.size(),
                            {fmt::format("'{}'", name)},
                            near.empty() ? "'heckbert grammar list' shows all" : "did you mean '" + near + "'?"));
}

/// "name=rest": both parts; the name is empty when there is none.
std::pair<std::string, std::string> split_name(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || text.ends_with(".grammar")) return {"", text};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// Whatever the text means, with a language or without.
Grammar lookup(const std::string& text, std::string_view what, const Settings& settings) {
  if (text.ends_with(".grammar")) return taxonomy::parse_grammar(read_text(text), text, taxonomy::builtin_grammars());
  if (text.starts_with('@') && looks_like_name(text.substr(1))) return builtin(text.substr(1), text, what);
  if (looks_like_name(text)) return builtin(text, text, what);
  Grammar grammar;
  grammar.kind = taxonomy::GrammarKind::Class;
  grammar.name = grammar.title = grammar.expression = text;
  grammar.dialect = settings.dialect;
  taxonomy::Reading reading =
      taxonomy::read_expression(text, settings.dialect, taxonomy::builtin_grammars().names(), what);
  for (const Diagnostic& warning : reading.warnings)
    Console(settings).note(fmt::format("warning: {}: {}", text, taxonomy::warning_text(warning)));
  grammar.language = std::move(reading.language);
  return grammar;
}

/// Applies `make` to every text, collecting the diagnostics of all that are wrong.
template <class Make>
std::vector<Grammar> collect(const std::vector<std::string>& texts, Make make) {
  std::vector<Grammar> grammars;
  std::vector<Diagnostic> errors;
  for (const std::string& text : texts) {
    try {
      grammars.push_back(make(text));
    } catch (const InputError& error) {
      errors.insert(errors.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }
  if (!errors.empty()) throw InputError(std::move(errors));
  return grammars;
}

}  // namespace

Grammar find_grammar(const std::string& text, std::string_view what, const Settings& settings) {
  Grammar grammar = lookup(text, what, settings);
  if (!taxonomy::has_language(grammar))
    throw InputError(diagnose(ErrorCode::NoLanguage, what, text, 0, text.size(), {taxonomy::why_no_language(grammar)},
                              "'heckbert grammar show " + grammar.name + "' says what it is"));
  return grammar;
}

std::vector<Grammar> find_grammars(const std::vector<std::string>& texts, std::string_view what,
                                   const Settings& settings) {
  return collect(texts, [&](const std::string& text) { return find_grammar(text, what, settings); });
}

std::vector<Grammar> find_described(const std::vector<std::string>& texts, std::string_view what,
                                    const Settings& settings) {
  return collect(texts, [&](const std::string& text) { return lookup(text, what, settings); });
}

std::vector<Grammar> find_to_cover(const std::vector<std::string>& texts, std::string_view what,
                                   const Settings& settings) {
  if (texts.empty()) return taxonomy::core_algorithms(taxonomy::builtin_grammars());
  std::vector<std::string> others = texts;
  const bool all = std::erase(others, kAllGrammars) > 0;
  std::vector<Grammar> grammars;
  if (all)
    std::copy_if(taxonomy::builtin_grammars().grammars.begin(), taxonomy::builtin_grammars().grammars.end(),
                 std::back_inserter(grammars),
                 [](const Grammar& grammar) { return grammar.kind != taxonomy::GrammarKind::Class; });
  for (Grammar& grammar : find_grammars(others, what, settings)) grammars.push_back(std::move(grammar));
  return grammars;
}

std::vector<Grammar> find_named_grammars(const std::vector<std::string>& texts, std::string_view what,
                                         const Settings& settings) {
  std::vector<Grammar> grammars = collect(texts, [&](const std::string& text) {
    const auto [name, rest] = split_name(text);
    Grammar grammar = find_grammar(rest, what, settings);
    if (!name.empty()) grammar.name = name;
    return grammar;
  });
  for (std::size_t i = 0; i < grammars.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (grammars[i].name == grammars[j].name)
        throw InputError(diagnose(what, texts[i], 0, grammars[i].name.size(),
                                  "there are two layers of the name '" + grammars[i].name + "'",
                                  "give them names of their own: name=EXPR"));
  return grammars;
}

taxonomy::GrammarLibrary teaching_library() {
  taxonomy::GrammarLibrary library{taxonomy::core_algorithms(taxonomy::builtin_grammars())};
  for (const Grammar& grammar : taxonomy::builtin_grammars().grammars)
    if (grammar.kind == taxonomy::GrammarKind::Class) library.grammars.push_back(grammar);
  return library;
}

std::vector<std::string> first_words(const taxonomy::Language& language, taxonomy::Symbol light, bool contained,
                                     std::size_t count) {
  constexpr std::size_t kLongest = 5;
  using taxonomy::Symbol;
  std::vector<std::string> found;
  std::vector<taxonomy::Word> words{{.light = light, .events = {}, .eye = Symbol::Ep}};
  for (std::size_t length = 0; length <= kLongest && found.size() < count; ++length) {
    std::vector<taxonomy::Word> longer;
    for (const taxonomy::Word& word : words) {
      if (found.size() < count && language.contains(word) == contained) found.push_back(taxonomy::plain(word));
      for (const Symbol event : {Symbol::Dr, Symbol::Gr, Symbol::Sr}) {
        longer.push_back(word);
        longer.back().events.push_back(event);
      }
    }
    words = std::move(longer);
  }
  return found;
}

std::string show(const taxonomy::Word& word) {
  const std::string letters = taxonomy::plain(word);
  return taxonomy::parse_word(letters) == word ? letters : taxonomy::fine(word);
}

}  // namespace heckbert::cli
