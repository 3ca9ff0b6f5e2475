#include <heckbert/cli/memory_budget.h>

#include <algorithm>

#include <fmt/format.h>

#include <heckbert/cli/exit_code.h>
#include <heckbert/taxonomy/simplest.h>

namespace heckbert::cli {

namespace {

// Measured; see bench/README.md.
constexpr std::uint64_t kProgramBytes = 48 << 20;  ///< with a scene of some size and what threads hold
constexpr std::uint64_t kPixelBytes = 24;
constexpr std::uint64_t kPictureBytes = 24;  ///< by pixel, of each class and of the whole
constexpr std::uint64_t kMatteBytes = 64;    ///< by pixel, of a Cryptomatte
constexpr std::uint64_t kWordBytes = 3072;   ///< most of them when the file is written

void add_distinct(std::vector<taxonomy::Language>& languages, taxonomy::Language language) {
  if (std::find(languages.begin(), languages.end(), language) == languages.end())
    languages.push_back(std::move(language));
}

}  // namespace

record::FoldRule fold_rule(std::uint64_t bytes, const record::RenderInfo& info,
                           const std::vector<taxonomy::Grammar>& declared, bool with_cryptomatte) {
  record::FoldRule rule;
  for (const taxonomy::Grammar& grammar : declared) {
    taxonomy::Language finest = taxonomy::apply(info.glossy, grammar.language);
    if (!taxonomy::simplest_expression(finest))
      throw UsageError(fmt::format("--memory: '{}' is too long to be kept exact", grammar.name));
    add_distinct(rule.exact, std::move(finest));
  }
  for (const taxonomy::Grammar& grammar : taxonomy::builtin_grammars().grammars)
    if (taxonomy::has_language(grammar)) add_distinct(rule.exact, taxonomy::apply(info.glossy, grammar.language));

  const std::uint64_t by_pixel =
      kPixelBytes + kPictureBytes * (1 + declared.size()) + (with_cryptomatte ? kMatteBytes : 0);
  const std::uint64_t fixed = kProgramBytes + info.window.pixel_count() * by_pixel;
  if (bytes < fixed + kWordBytes)
    throw UsageError(fmt::format("--memory: a picture of this size and {} classes take {} MiB before any word is kept",
                                 declared.size(), (fixed >> 20) + 1));
  rule.most_words = (bytes - fixed) / kWordBytes;
  return rule;
}

}  // namespace heckbert::cli
