#pragma once
// Coverage: what each grammar captures and misses of a record, as data. Everything the terminal, the JSON, the contact
// sheet and the HTML page show is taken from these structs; nothing downstream recomputes.
//
// That an algorithm captures a word says three things (docs/anchors.md has the scenes that tell them apart): the word
// is in its language; its value is right, or biased as the grammar's notes say; and it is practical, in that the
// samples it needs for a given error stay within a budget. The samples are those of the algorithm that made the record:
// with a standard deviation s of one sample and a mean m, a relative error e takes (s/m)^2 / e^2 samples per pixel.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/rows.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/part.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::report {

/// Words that print alike ("LDSE") together, with their energy.
struct WordEnergy {
  std::string word;         ///< plain or fine spelling, as asked
  record::Estimate energy;  ///< picture-mean luminance
  record::Estimate share;   ///< of all recorded energy
  std::uint64_t count = 0;  ///< contributions
  std::size_t length = 0;
  std::optional<double> samples_needed{};  ///< per pixel, for Coverage::error; unset where the spread is unknown
};

/// The pixel of which a grammar captures the least; among equals the brightest.
struct WorstPixel {
  int x = 0, y = 0;
  double share = 0;
};

struct GrammarCoverage {
  std::string name, title, expression, expression_delta, source;
  std::vector<std::string> biases, variances, preconditions;  ///< what the share does not tell
  std::vector<bool> captured;                                 ///< by word of the record; certainly, where it is folded
  bool is_exact = true;  ///< false: folded words may be captured too; the intervals say how much they are
  record::Estimate captured_energy;
  record::Estimate share;                            ///< captured over all
  double practical_share = 0;                        ///< of all energy: captured, within the budget
  std::optional<WorstPixel> worst_pixel{};           ///< unset when all is dark
  std::vector<WordEnergy> top_captured, top_missed;  ///< by energy, most first
};

/// A grammar that was asked for and has no language, so no share either.
struct LeftOut {
  std::string name, title;
  std::string why;  ///< a sentence
};

struct Coverage {
  record::RenderInfo info;
  record::Tally tally;
  taxonomy::GlossyRule glossy_rule = taxonomy::GlossyRule::Keep;
  double confidence = 0.95;
  double error = 0, budget = 0;  ///< what "practical" means: relative error, samples per pixel
  Part part;                     ///< of the record that all this is about
  record::Estimate total;        ///< mean luminance of the part's pixels, of the part's words
  /// Picture-mean luminance of light that belongs to no path, and so to no share; 0 when there is none.
  double ambient = 0, phantom = 0;
  std::vector<GrammarCoverage> grammars;
  std::vector<LeftOut> left_out;
  std::vector<WordEnergy> words;  ///< all, by energy, most first
};

enum class Spelling : std::uint8_t { Plain, Fine };

/// The chosen words of a part of the record by energy, most first; those that are not there are left out.
std::vector<WordEnergy> words_by_energy(const record::Record& record, const std::vector<bool>& chosen,
                                        Spelling spelling = Spelling::Plain, double confidence = 0.95, Part part = {});
/// Does what it needs stay within the budget?
bool is_practical(const WordEnergy& word, double budget);

struct CoverageOptions {
  taxonomy::GlossyRule glossy_rule = taxonomy::GlossyRule::Keep;
  double confidence = 0.95;
  std::size_t top = 8;  ///< words listed per grammar
  Spelling spelling = Spelling::Plain;
  double error = 0.05;   ///< relative, of a pixel
  double budget = 1024;  ///< samples per pixel
  Part part{};           ///< of the record
};

/// Grammars that have no language are left out, and named.
Coverage coverage(const record::Record& record, const std::vector<taxonomy::Grammar>& grammars,
                  const CoverageOptions& options = {});
/// The same of a record whose pixels are shown by `rows`. Takes: a record with its pixels where a region is asked for,
/// else one that needs no offsets and no entries.
Coverage coverage(const record::Record& record, const record::Rows& rows,
                  const std::vector<taxonomy::Grammar>& grammars, const CoverageOptions& options = {});

/// What "practical" means here, in a sentence.
std::string practical_rule(const Coverage& coverage);

/// Are lights that a ray cannot hit told apart, and does it make a difference?
bool has_two_expressions(const GrammarCoverage& grammar);

/// Do its words have a wrong value somewhere, as far as its file says?
bool is_biased(const GrammarCoverage& grammar);

/// What the grammar leaves of all recorded energy; 0 when there is none.
double missed_share(const Coverage& coverage, const GrammarCoverage& grammar);

}  // namespace heckbert::report
