#pragma once
// Grammars: the language that one rendering algorithm captures, and named classes of paths, read from the text files of
// grammar/ (syntax: grammar/README.md). An algorithm has one expression for lights that a ray can hit (La, Le) and one
// for lights that it cannot (Lp, Ld); the language is the union of each, restricted to its light kinds, so one language
// answers for every scene.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

enum class GrammarKind : std::uint8_t { Algorithm, Class };

struct Grammar {
  GrammarKind kind = GrammarKind::Algorithm;
  int order = 0;                    ///< place in listings, the order of teaching
  std::string name;                 ///< identifier, used as @name
  std::string title;                ///< for people
  std::string source;               ///< publication or document the grammar is taken from
  std::string expression;           ///< as written; for lights that can be hit when `expression_delta` is given
  std::string expression_delta;     ///< for lights that cannot be hit, or "none"; empty for classes
  std::vector<std::string> biases;  ///< "right words, wrong value" notes
  std::string notes;
  Language language;  ///< over words with every kind of ends
};

/// All grammars of a library, algorithms first, in the order of their `order` field, then by name.
struct GrammarLibrary {
  std::vector<Grammar> grammars;
  const Grammar* find(std::string_view name) const;
  Names names() const;  ///< for compile(); refers to this library, which must outlive it
};

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
