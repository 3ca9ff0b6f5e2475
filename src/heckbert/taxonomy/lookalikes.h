#pragma once
// Characters that look like those of an expression and are not. People paste them from slides, papers and manuals: a
// vendor's own documentation has a Cyrillic letter in "C<\u0422[GS]>".

#include <array>
#include <string_view>

namespace heckbert::taxonomy {

struct Lookalike {
  char32_t code;
  std::string_view what;
  std::string_view meant;
};
inline constexpr std::array kLookalikes{
    Lookalike{U'\u0421', "a Cyrillic letter that looks like C", "C"},
    Lookalike{U'\u0415', "a Cyrillic letter that looks like E", "E"},
    Lookalike{U'\u0405', "a Cyrillic letter that looks like S", "S"},
    Lookalike{U'\u0422', "a Cyrillic letter that looks like T", "T"},
    Lookalike{U'\u0412', "a Cyrillic letter that looks like B", "B"},
    Lookalike{U'\u041E', "a Cyrillic letter that looks like O", "O"},
    Lookalike{U'\u0455', "a Cyrillic letter that looks like s", "s"},
    Lookalike{U'\u0425', "a Cyrillic letter that looks like X", "X"},
    Lookalike{U'\u0395', "a Greek letter that looks like E", "E"},
    Lookalike{U'\u03A4', "a Greek letter that looks like T", "T"},
    Lookalike{U'\u0392', "a Greek letter that looks like B", "B"},
    Lookalike{U'\u039F', "a Greek letter that looks like O", "O"},
    Lookalike{U'\u039D', "a Greek letter that looks like N", "N"},
    Lookalike{U'\u03A7', "a Greek letter that looks like X", "X"},
    Lookalike{U'\u0430', "a Cyrillic letter that looks like a", "a"},
    Lookalike{U'\u0440', "a Cyrillic letter that looks like p", "p"},
    Lookalike{U'\u0435', "a Cyrillic letter that looks like e", "e"},
    Lookalike{U'\u00A0', "a no-break space", " "},
    Lookalike{U'\u200B', "an invisible space", ""},
    Lookalike{U'\uFEFF', "an invisible byte order mark", ""},
    Lookalike{U'\u2212', "a minus sign that is not '-'", "-"},
    Lookalike{U'\u2013', "a dash that is not '-'", "-"},
    Lookalike{U'\u2014', "a dash that is not '-'", "-"},
    Lookalike{U'\u2217', "an asterisk that is not '*'", "*"},
    Lookalike{U'\u00D7', "a times sign", "*"},
    Lookalike{U'\u222A', "the sign of union", "|"},
    Lookalike{U'\u2229', "the sign of intersection", "&"},
    Lookalike{U'\u00AC', "the sign of negation", "!"},
    Lookalike{U'\u2216', "the sign of difference", "-"},
};

/// Nothing for a character that is not in the table.
constexpr const Lookalike* find_lookalike(char32_t code) {
  for (const Lookalike& l : kLookalikes)
    if (l.code == code) return &l;
  return nullptr;
}

}  // namespace heckbert::taxonomy
