#pragma once
// Dialects: light path expressions of other renderers, read and written by their own rules. All facts about a dialect
// stand in one table, kDialects; reader, writer, help texts and docs/dialects.md derive from it, and docs/dialects.md
// says where each fact comes from and what was decided where the documents are silent.
//
// A letter of a dialect stands for a set of our thirteen symbols, so an expression of a dialect is an expression over
// our alphabet: a set of words is read by an inverse homomorphism (taxonomy.md, 1.2). Two things do not fit and are
// decided here: an area light La is both L and O of the camera-first dialects, because our words do not say whether a
// lamp is a light of the scene or an object that glows; and straight-through events `s`, which our words leave out,
// match nothing.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

enum class Dialect : std::uint8_t { Heckbert, Osl, RenderMan, Arnold, VRay, Iray, Karma, MoonRay };

enum class Orientation : std::uint8_t { CameraFirst, Either };
enum class Blanks : std::uint8_t { Refused, AtEnds, Ignored };

/// A scattering letter and the kinds of ours that it stands for, reflected and transmitted.
struct KindLetter {
  char letter = 0;  ///< 0 fills the table
  std::string_view kinds;
};

/// A light end and the subscripts of our light ends that it stands for.
struct LightLetter {
  std::string_view text;  ///< empty fills the table
  std::string_view subscripts;
};

struct DialectFacts {
  Dialect dialect;
  std::string_view name;   ///< as --dialect takes it
  std::string_view title;  ///< for people
  Orientation orientation;
  std::string_view eyes;  ///< letters of the eye end; the first is written
  std::array<KindLetter, 4> kinds;
  std::array<LightLetter, 5> lights;  ///< the wider ones first
  bool bar_binds_tightest;            ///< `CD|SL` is C(D|S)L, else (CD)|(SL)
  bool dot_matches_ends;              ///< '.' and [^..] match lights and the eye too
  bool has_groups;                    ///< <RD>, else subscripts
  bool has_whole_operators;           ///< complement, & and - on whole expressions
  bool has_optional;                  ///< ?
  bool has_exact;                     ///< {n}
  bool has_open;                      ///< {n,}
  bool has_range;                     ///< {n,m}
  bool stacks_repetitions;            ///< D+* is (D+)*, else an error
  Blanks blanks;
  std::string_view prefixes;  ///< words before the expression, blank between them
};

inline constexpr std::array kOslLights{LightLetter{"L", "apd"}, LightLetter{"O", "a"}, LightLetter{"B", "e"},
                                       LightLetter{}, LightLetter{}};
inline constexpr std::array kOslKinds{KindLetter{'D', "D"}, KindLetter{'G', "G"}, KindLetter{'S', "S"},
                                      KindLetter{'s', ""}};
inline constexpr std::string_view kRenderManPrefixes =
    "lpe unoccluded noclamp nothruput shadows holdouts overwrite noinfinitecheck";

inline constexpr std::array<DialectFacts, 8> kDialects{{
    {.dialect = Dialect::Heckbert,
     .name = "heckbert",
     .title = "Heckbert",
     .orientation = Orientation::Either,
     .eyes = "EC",
     .kinds = {{{'D', "D"}, {'G', "G"}, {'S', "S"}, {}}},
     .lights = {{{"L", "apde"}, {"La", "a"}, {"Lp", "p"}, {"Ld", "d"}, {"Le", "e"}}},
     .bar_binds_tightest = false,
     .dot_matches_ends = false,
     .has_groups = false,
     .has_whole_operators = true,
     .has_optional = true,
     .has_exact = true,
     .has_open = true,
     .has_range = true,
     .stacks_repetitions = true,
     .blanks = Blanks::Ignored,
     .prefixes = ""},
    {.dialect = Dialect::Osl,
     .name = "osl",
     .title = "OSL",
     .orientation = Orientation::CameraFirst,
     .eyes = "C",
     .kinds = kOslKinds,
     .lights = kOslLights,
     .bar_binds_tightest = true,
     .dot_matches_ends = true,
     .has_groups = true,
     .has_whole_operators = false,
     .has_optional = false,
     .has_exact = true,
     .has_open = true,
     .has_range = true,
     .stacks_repetitions = false,
     .blanks = Blanks::Refused,
     .prefixes = ""},
    {.dialect = Dialect::RenderMan,
     .name = "renderman",
     .title = "RenderMan",
     .orientation = Orientation::CameraFirst,
     .eyes = "C",
     .kinds = {{{'D', "D"}, {'S', "GS"}, {}, {}}},
     .lights = {{{"L", "apde"}, {"O", "a"}, {}, {}, {}}},
     .bar_binds_tightest = true,
     .dot_matches_ends = true,
     .has_groups = true,
     .has_whole_operators = false,
     .has_optional = false,
     .has_exact = true,
     .has_open = false,
     .has_range = false,
     .stacks_repetitions = false,
     .blanks = Blanks::Ignored,
     .prefixes = kRenderManPrefixes},
    {.dialect = Dialect::Arnold,
     .name = "arnold",
     .title = "Arnold",
     .orientation = Orientation::CameraFirst,
     .eyes = "C",
     .kinds = {{{'D', "D"}, {'S', "GS"}, {}, {}}},
     .lights = kOslLights,
     .bar_binds_tightest = false,
     .dot_matches_ends = true,
     .has_groups = true,
     .has_whole_operators = false,
     .has_optional = false,
     .has_exact = false,
     .has_open = false,
     .has_range = false,
     .stacks_repetitions = false,
     .blanks = Blanks::Ignored,
     .prefixes = ""},
    {.dialect = Dialect::VRay,
     .name = "vray",
     .title = "V-Ray",
     .orientation = Orientation::CameraFirst,
     .eyes = "C",
     .kinds = kOslKinds,
     .lights = kOslLights,
     .bar_binds_tightest = false,
     .dot_matches_ends = true,
     .has_groups = true,
     .has_whole_operators = true,
     .has_optional = true,
     .has_exact = false,
     .has_open = false,
     .has_range = false,
     .stacks_repetitions = false,
     .blanks = Blanks::Ignored,
     .prefixes = ""},
    {.dialect = Dialect::Iray,
     .name = "iray",
     .title = "Iray",
     .orientation = Orientation::Either,
     .eyes = "EC",
     .kinds = {{{'D', "D"}, {'G', "G"}, {'S', "S"}, {}}},
     .lights = {{{"L", "apde"}, {"La", "a"}, {"Lp", "pd"}, {"Le", "e"}, {}}},
     .bar_binds_tightest = false,
     .dot_matches_ends = false,
     .has_groups = true,
     .has_whole_operators = false,
     .has_optional = true,
     .has_exact = true,
     .has_open = true,
     .has_range = true,
     .stacks_repetitions = false,
     .blanks = Blanks::Ignored,
     .prefixes = ""},
    {.dialect = Dialect::Karma,
     .name = "karma",
     .title = "Karma",
     .orientation = Orientation::CameraFirst,
     .eyes = "C",
     .kinds = {{{'D', "D"}, {'G', "GS"}, {}, {}}},
     .lights = kOslLights,
     .bar_binds_tightest = false,
     .dot_matches_ends = true,
     .has_groups = true,
     .has_whole_operators = false,
     .has_optional = false,
     .has_exact = false,
     .has_open = false,
     .has_range = false,
     .stacks_repetitions = false,
     .blanks = Blanks::Ignored,
     .prefixes = "unoccluded shadow"},
    {.dialect = Dialect::MoonRay,
     .name = "moonray",
     .title = "MoonRay",
     .orientation = Orientation::CameraFirst,
     .eyes = "C",
     .kinds = kOslKinds,
     .lights = kOslLights,
     .bar_binds_tightest = true,
     .dot_matches_ends = true,
     .has_groups = true,
     .has_whole_operators = false,
     .has_optional = false,
     .has_exact = true,
     .has_open = true,
     .has_range = true,
     .stacks_repetitions = false,
     .blanks = Blanks::AtEnds,
     .prefixes = "unoccluded"},
}};

constexpr const DialectFacts& facts(Dialect dialect) {
  return kDialects[static_cast<std::size_t>(dialect)];
}

static_assert([] {
  for (std::size_t i = 0; i < kDialects.size(); ++i)
    if (static_cast<std::size_t>(kDialects[i].dialect) != i) return false;
  return true;
}());

/// An expression as a dialect means it.
struct Reading {
  Language language;                  ///< a subset of universe()
  std::vector<std::string> prefixes;  ///< "unoccluded", "lpe": they change the value of a path, never which paths
  std::vector<Diagnostic> warnings;   ///< well-formed, and hardly what was meant
};

/// Reads an expression by the rules of a dialect. `names` serves Heckbert's @name. Errors: InputError with all errors
/// of the text, and where possible a repaired expression, which has been read; LimitError as from compile().
Reading read_expression(std::string_view text, Dialect dialect, const Names& names = {},
                        std::string_view source = "expression");

/// An expression in a dialect, or why there is none: exactly one of the two is not empty.
struct Writing {
  std::string text;
  std::string refusal;
};

/// An expression that `dialect` reads as exactly this language, a subset of universe(); checked by reading it.
Writing write_expression(const Language& language, Dialect dialect);

/// A text and its language carried from one dialect to another.
struct Translation {
  Reading reading;
  Writing writing;
  std::optional<Word> differs_on;  ///< the shortest word that the text itself means in one of the two dialects only
  bool only_in_from = false;       ///< which of the two
};

/// Errors: as read_expression, for the text in `from`.
Translation translate(std::string_view text, Dialect from, Dialect to, const Names& names = {},
                      std::string_view source = "expression");

}  // namespace heckbert::taxonomy
