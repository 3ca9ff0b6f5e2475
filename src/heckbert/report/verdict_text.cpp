#include <heckbert/report/verdict_text.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/report/numbers.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::report {
namespace {

std::string factor(const record::Estimate& ratio) {
  return fmt::format("{:.4g} [{:.4g}, {:.4g}]", ratio.mean, ratio.lower, ratio.upper);
}

std::string errors(double standard_errors) {
  return std::isfinite(standard_errors) ? fmt::format("{:.1f} standard errors", standard_errors)
                                        : std::string("without any spread");
}

std::string place(const BrightPixel& pixel) {
  return fmt::format("brightest at {}, {}", pixel.x, pixel.y);
}

std::string needs(const std::optional<double>& samples) {
  return samples ? fmt::format("needs about {} samples", samples_text(samples)) : std::string("needs more samples");
}

std::string note(const WordFinding& word) {
  std::string text = fmt::format("{} {}", word.word, facts(word.standing).meaning);
  switch (word.standing) {
    case Standing::Differs:
      text += fmt::format(": {} times that of {}, {}", factor(*word.ratio), word.witness,
                          errors(word.comparison.standard_errors));
      return text;
    case Standing::Missing:
      return text + fmt::format(": {} has {} from {}, {}", word.witness, number(word.comparison.expected.mean),
                                counted(word.expected_count, "path"), place(*word.brightest));
    case Standing::Unclaimed:
      return text + fmt::format(": {} from {}, {}", number(word.comparison.found.mean),
                                counted(word.found_count, "path"), place(*word.brightest));
    case Standing::Converges:
    case Standing::Rare:
    case Standing::Untold:
    case Standing::Agrees:
      return text;
  }
  return text;
}

/// How the heaviest words come nearer as the algorithm is made finer.
std::vector<std::string> sequences(const AlgorithmVerdict& verdict, std::size_t most) {
  std::vector<const WordFinding*> words;
  for (const WordFinding& word : verdict.words)
    if (word.sequence) words.push_back(&word);
  if (words.empty()) return {};
  std::stable_sort(words.begin(), words.end(), [](const WordFinding* a, const WordFinding* b) {
    return a->comparison.expected.mean > b->comparison.expected.mean;
  });
  words.resize(std::min(words.size(), most));
  std::vector<std::string> lines{
      fmt::format("found/expected as {} goes {:g}", verdict.refined_by, fmt::join(verdict.sizes, ", "))};
  for (const WordFinding* word : words) {
    std::vector<std::string> ratios;
    for (const record::Estimate& ratio : word->sequence->ratios) ratios.push_back(fmt::format("{:.4f}", ratio.mean));
    std::string line = fmt::format("  {}: {}, +- {:.4f}", word->word, fmt::join(ratios, ", "),
                                   word->sequence->ratios.back().upper - word->sequence->ratios.back().mean);
    if (word->sequence->order)
      line += fmt::format("; of order {:.2f} [{:.2f}, {:.2f}]", word->sequence->order->mean,
                          word->sequence->order->lower, word->sequence->order->upper);
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Where it differs most, on a line of its own.
std::string where(const WordFinding& word) {
  const BlockFinding& worst = *word.worst_block;
  return fmt::format("  in {} of {} blocks of pixels; most at {} to {}, {} to {}: {:.4g} times",
                     word.blocks_that_differ, word.blocks_compared, worst.pixels.x0, worst.pixels.x1 - 1,
                     worst.pixels.y0, worst.pixels.y1 - 1,
                     worst.comparison.found.mean / worst.comparison.expected.mean);
}

/// The heaviest words that need more samples than there is a budget for.
std::vector<std::string> costly(const AlgorithmVerdict& verdict, const VerdictOptions& options, std::size_t most) {
  std::vector<const WordFinding*> words;
  double total = 0;
  for (const WordFinding& word : verdict.words) {
    if (word.pooled > 1 || word.witness.empty()) continue;
    total += word.comparison.expected.mean;
    if (!word.samples_needed || *word.samples_needed > options.budget) words.push_back(&word);
  }
  std::stable_sort(words.begin(), words.end(), [](const WordFinding* a, const WordFinding* b) {
    return a->comparison.expected.mean > b->comparison.expected.mean;
  });
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(most, words.size()); ++i)
    lines.push_back(fmt::format("{} {}; it has {} of the energy", words[i]->word, needs(words[i]->samples_needed),
                                percent(words[i]->comparison.expected.mean / total)));
  return lines;
}

/// What the verdict rests on; agreement needs no words.
std::vector<std::string> notes(const AlgorithmVerdict& verdict, const VerdictOptions& options, std::size_t most) {
  std::vector<std::string> lines = sequences(verdict, most);
  if (verdict.ruling == Ruling::NeedsSamples) {
    for (std::string& line : costly(verdict, options, most)) lines.push_back(std::move(line));
    return lines;
  }
  for (const StandingFacts& standing : kStandings) {
    if (standing.standing == Standing::Agrees || standing.standing == Standing::Converges ||
        standing.standing == Standing::Untold || standing.standing == Standing::Rare)
      continue;
    std::size_t count = 0;
    for (const WordFinding& word : verdict.words) {
      if (word.standing != standing.standing) continue;
      if (++count > most) continue;
      lines.push_back(note(word));
      if (word.worst_block) lines.push_back(where(word));
    }
    if (count > most) lines.push_back(fmt::format("... and {} more", counted(count - most, "word")));
    if (count > 0 && standing.standing == Standing::Differs && !verdict.refined_by.empty())
      lines.push_back(fmt::format("these errors do not shrink as they should; a finer {} may show that they do",
                                  verdict.refined_by));
  }
  return lines;
}

std::size_t count_of(const AlgorithmVerdict& verdict, Standing standing) {
  std::size_t count = 0;
  for (const WordFinding& word : verdict.words) count += word.standing == standing ? 1 : 0;
  return count;
}

}  // namespace

std::string sentence(const AlgorithmVerdict& verdict) {
  if (verdict.ruling != Ruling::NeedsSamples) return std::string(facts(verdict.ruling).sentence);
  return "captured, but " + needs(verdict.samples_needed);
}

std::string verification_text(const Verification& verification, const TextStyle& style, std::size_t most) {
  const VerdictOptions& options = verification.options;
  std::string text =
      wrap(fmt::format(
               "{} of words and of their blocks of pixels; chance alone raises an alarm in {:g} of 100 verifications. "
               "Intervals hold at {}. Samples are those for a relative error of {} at a pixel.",
               counted(verification.comparisons, "comparison"), 100 * options.significance, level(options.confidence),
               percent(options.error)),
           style.width);
  std::vector<TextRow> rows;
  for (const AlgorithmVerdict& verdict : verification.verdicts) {
    const std::size_t compared = count_of(verdict, Standing::Agrees) + count_of(verdict, Standing::Differs) +
                                 count_of(verdict, Standing::Converges);
    rows.push_back(
        {.cells = {verdict.algorithm, taxonomy::name(verdict.light), sentence(verdict), std::to_string(compared),
                   verdict.ratio ? fmt::format("{:.4f}", verdict.ratio->mean) : "-"},
         .notes = notes(verdict, options, most)});
  }
  return text + '\n' +
         text_table({{"Algorithm"}, {"Light"}, {"Verdict"}, {"Words", Align::Right}, {"Found/expected", Align::Right}},
                    rows, style);
}

}  // namespace heckbert::report
