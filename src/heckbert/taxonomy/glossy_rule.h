#pragma once
// Where glossy falls. Heckbert's notation has two letters, ours three; what a two-letter expression says about a glossy
// bounce is the user's choice, applied when asking and printed with every result (design decision 1).

#include <array>
#include <cstdint>
#include <string_view>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

enum class GlossyRule : std::uint8_t { Keep, Diffuse, Specular };

struct GlossyRuleFacts {
  GlossyRule rule;
  std::string_view name;  ///< as on the command line
  std::string_view meaning;
};

inline constexpr std::array<GlossyRuleFacts, 3> kGlossyRules{{
    {GlossyRule::Keep, "keep", "G is a letter of its own: only expressions that say G match it"},
    {GlossyRule::Diffuse, "diffuse", "every G is read as D before matching"},
    {GlossyRule::Specular, "specular", "every G is read as S before matching"},
}};

/// The words that `language` matches once G has been read by this rule.
Language apply(GlossyRule rule, const Language& language);

}  // namespace heckbert::taxonomy
