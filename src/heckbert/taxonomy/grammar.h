#pragma once
// Grammars: the language that one rendering algorithm captures, and named classes of paths, read from the text files of
// grammar/ (syntax: grammar/README.md). An algorithm has one expression for lights that a ray can hit (La, Le) and one
// for lights that it cannot (Lp, Ld); the language is the union of each, restricted to its light kinds, so one language
// answers for every scene. Where the eye decides too, the expression says so itself, with Ep and El.
//
// Not every method of rendering has a language of the scene's paths. Those that have none are listed beside the others
// and say what they are instead; asking for their words is an error.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

enum class GrammarKind : std::uint8_t { Algorithm, Transformer, Proxy, Predicate, Class };

struct GrammarKindFacts {
  GrammarKind kind;
  std::string_view name;         ///< in files and JSON
  std::string_view no_language;  ///< why there is none, a sentence without its subject; empty where there is one
};

inline constexpr std::array<GrammarKindFacts, 5> kGrammarKinds{{
    {GrammarKind::Algorithm, "algorithm", ""},
    {GrammarKind::Transformer, "transformer",
     "it changes how its host finds paths, and captures what its host captures"},
    {GrammarKind::Proxy, "proxy", "it lights a scene of its own, so its paths are none of this scene's"},
    {GrammarKind::Predicate, "predicate", "which paths it finds depends on places in the picture, and words have none"},
    {GrammarKind::Class, "class", ""},
}};

constexpr const GrammarKindFacts& facts(GrammarKind kind) {
  return kGrammarKinds[static_cast<std::size_t>(kind)];
}

/// What stands in place of an expression that matches nothing.
inline constexpr std::string_view kNoPath = "none";

struct Grammar {
  GrammarKind kind = GrammarKind::Algorithm;
  int order = 0;                 ///< place in listings, the order of teaching
  std::optional<int> number;     ///< row in the table of algorithms, from 1; classes have none
  bool is_core = false;          ///< one of the teaching set, which is what coverage shows when not asked for others
  std::string name;              ///< identifier, used as @name
  std::string title;             ///< for people
  std::string source;            ///< publication or document the grammar is taken from
  std::string expression;        ///< as written, or "none"; for lights that can be hit when there are two
  std::string expression_delta;  ///< for lights that cannot be hit, or "none"; empty for classes
  Dialect dialect = Dialect::Heckbert;     ///< of the expression; files are in Heckbert's notation
  std::string host;                        ///< of transformers: the algorithm whose language is theirs
  std::vector<std::string> biases;         ///< right words, wrong value
  std::vector<std::string> variances;      ///< right words, right value, but noise beyond use
  std::vector<std::string> preconditions;  ///< what a scene must have for all this to hold
  std::string notes;
  Language language;  ///< over words with every kind of ends; none when the kind has none
};

/// Does it stand for words? The language of an algorithm may still be small; that of a proxy is no language at all.
bool has_language(const Grammar& grammar);

/// "'x' is a proxy and has no language: it ...", for people; empty when it has one.
std::string why_no_language(const Grammar& grammar);

/// All grammars of a library: algorithms, what has no language, classes; each in the order of their `order` field, then
/// by name.
struct GrammarLibrary {
  std::vector<Grammar> grammars;
  const Grammar* find(std::string_view name) const;
  Names names() const;  ///< for compile(); refers to this library, which must outlive it
};

/// The algorithms of the teaching set, in the library's order.
std::vector<Grammar> core_algorithms(const GrammarLibrary& library);

/// One grammar file: its name, for errors, and its content.
struct GrammarText {
  std::string_view source;
  std::string_view text;
};

/// Reads grammar files in any order; an expression may name what the library and these files list before it. Errors:
/// InputError with all errors of all files, each at its place in its file; LimitError as from compile().
GrammarLibrary read_grammars(std::span<const GrammarText> files, const GrammarLibrary& library = {});

/// Reads one grammar file's text. Classes and algorithms may refer to those already in `library`, and may not take
/// their names. Errors: as above.
Grammar parse_grammar(std::string_view text, std::string_view source, const GrammarLibrary& library);

/// The grammars that ship with the tool, compiled into the library from grammar/ at build time.
const GrammarLibrary& builtin_grammars();

}  // namespace heckbert::taxonomy
