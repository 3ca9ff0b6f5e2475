#include <heckbert/report/coverage_text.h>

#include <fmt/format.h>

#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/words_text.h>

namespace heckbert::report {
namespace {

std::string expressions(const GrammarCoverage& grammar) {
  if (!has_two_expressions(grammar)) return grammar.expression;
  return fmt::format("{}   for lights that cannot be hit: {}", grammar.expression, grammar.expression_delta);
}

/// As many of the missed words as fit on the line.
std::string missed(const GrammarCoverage& grammar, std::size_t width) {
  if (grammar.top_missed.empty()) return "misses nothing";
  std::string line = "misses ";
  for (std::size_t i = 0; i < grammar.top_missed.size(); ++i) {
    const WordEnergy& word = grammar.top_missed[i];
    const std::string next = fmt::format("{}{} {}", i == 0 ? "" : ", ", word.word, percent(word.share.mean));
    if (i > 0 && display_width(line) + next.size() > width) break;
    line += next;
  }
  return line;
}

}  // namespace

std::string coverage_text(const Coverage& coverage, const TextStyle& style, std::size_t words) {
  std::string text = wrap(summary(coverage.info), style.width);
  text += wrap("Glossy rule " + describe(coverage.glossy_rule), style.width);
  text += wrap(fmt::format("Energy is the mean luminance of the picture: {} in all. Intervals hold at {}.",
                           number(coverage.total.mean), level(coverage.confidence)),
               style.width);
  if (!coverage.part.is_whole()) text += wrap("All of this is about " + coverage.part.description + ".", style.width);
  text += wrap(practical_rule(coverage), style.width);
  if (coverage.ambient > 0 || coverage.phantom > 0)
    text += wrap(fmt::format("Outside of every share, as no path: ambient term {}, phantom mirror {}.",
                             number(coverage.ambient), number(coverage.phantom)),
                 style.width);
  if (const std::string ended = termination(coverage.info, coverage.tally, coverage.total.mean); !ended.empty())
    text += wrap(ended, style.width);
  for (const std::string& warning : warnings(coverage.info, coverage.tally))
    text += wrap("Warning: " + warning, style.width);

  std::vector<TextRow> rows;
  for (const GrammarCoverage& grammar : coverage.grammars) {
    rows.push_back({.cells = {grammar.title, percent(grammar.share.mean), bracketed_percent(grammar.share),
                              is_biased(grammar) ? "yes" : "-", percent(grammar.practical_share)},
                    .notes = {expressions(grammar), missed(grammar, style.width - 2)},
                    .bar = grammar.share.mean});
    std::vector<std::string>& notes = rows.back().notes;
    if (const std::optional<WorstPixel>& worst = grammar.worst_pixel; worst && worst->share < 1)
      notes.push_back(fmt::format("worst pixel {}, {}: {}", worst->x, worst->y, percent(worst->share)));
    if (!grammar.is_exact) notes.emplace_back(kAtLeast);
    for (const std::string& bias : grammar.biases) notes.push_back("bias: " + bias);
  }
  text += '\n' + text_table({{"Algorithm"},
                             {"Captured", Align::Right},
                             {"Interval in %", Align::Right},
                             {"Bias", Align::Right},
                             {"Practical", Align::Right}},
                            rows, style);
  if (!coverage.left_out.empty()) text += "\nLeft out:\n";
  for (const LeftOut& grammar : coverage.left_out) text += wrap(grammar.why + ".", style.width, 2);
  return text + '\n' + words_text(coverage.words, style, words, true);
}

}  // namespace heckbert::report
