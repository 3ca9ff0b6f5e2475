#include <heckbert/report/requirement.h>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

/// Words named in a verdict, at most.
constexpr std::size_t kWitnesses = 3;

const GrammarCoverage& find(const Coverage& coverage, const std::string& name) {
  const auto found = std::find_if(coverage.grammars.begin(), coverage.grammars.end(),
                                  [&](const GrammarCoverage& grammar) { return grammar.name == name; });
  if (found == coverage.grammars.end()) throw std::out_of_range("no coverage of '" + name + "'");
  return *found;
}

}  // namespace

std::vector<Verdict> judge(const Coverage& coverage, const std::vector<Requirement>& requirements) {
  std::vector<Verdict> verdicts;
  for (const Requirement& requirement : requirements) {
    const GrammarCoverage& grammar = find(coverage, requirement.grammar);
    Verdict& verdict = verdicts.emplace_back();
    verdict.requirement = requirement;
    verdict.share = grammar.share;
    verdict.holds = grammar.share.known && grammar.share.lower >= requirement.least;
    if (verdict.holds) continue;
    for (std::size_t i = 0; i < std::min(kWitnesses, grammar.top_missed.size()); ++i)
      verdict.missed.push_back(
          fmt::format("{} ({})", grammar.top_missed[i].word, percent(grammar.top_missed[i].share.mean)));
  }
  return verdicts;
}

std::string sentence(const Verdict& verdict, const Coverage& coverage) {
  std::string text =
      fmt::format("{} {}: {} captures {}", verdict.requirement.text, verdict.holds ? "holds" : "does not hold",
                  verdict.requirement.grammar, percent(verdict.share.mean));
  text += verdict.share.known ? fmt::format(", {} at {}", percent_interval(verdict.share), level(coverage.confidence))
                              : std::string(", and one sample per pixel does not tell how sure that is");
  if (!verdict.missed.empty()) text += fmt::format("; it misses {}", fmt::join(verdict.missed, ", "));
  return text + ".";
}

}  // namespace heckbert::report
