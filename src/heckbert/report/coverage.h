#pragma once
// Coverage: what each grammar captures and misses of a record, as data. Everything the terminal, the JSON, the contact
// sheet and the HTML page show is taken from these structs; nothing downstream recomputes.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>
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
};

struct GrammarCoverage {
  std::string name, title, expression, expression_delta, source;
  std::vector<std::string> biases, variances, preconditions;  ///< what the share does not tell
  std::vector<bool> captured;                                 ///< by word of the record
  record::Estimate captured_energy;
  record::Estimate share;                            ///< captured over all
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
  record::Estimate total;  ///< picture-mean luminance of all words
  /// Picture-mean luminance of light that belongs to no path, and so to no share; 0 when there is none.
  double ambient = 0, phantom = 0;
  std::vector<GrammarCoverage> grammars;
  std::vector<LeftOut> left_out;
  std::vector<WordEnergy> words;  ///< all, by energy, most first
};

enum class Spelling : std::uint8_t { Plain, Fine };

/// Every word of the record by energy, most first.
std::vector<WordEnergy> words_by_energy(const record::Record& record, const std::vector<bool>& chosen,
                                        Spelling spelling = Spelling::Plain, double confidence = 0.95);

struct CoverageOptions {
  taxonomy::GlossyRule glossy_rule = taxonomy::GlossyRule::Keep;
  double confidence = 0.95;
  std::size_t top = 8;  ///< words listed per grammar
  Spelling spelling = Spelling::Plain;
};

/// Grammars that have no language are left out, and named.
Coverage coverage(const record::Record& record, const std::vector<taxonomy::Grammar>& grammars,
                  const CoverageOptions& options = {});

/// Are lights that a ray cannot hit told apart, and does it make a difference?
bool has_two_expressions(const GrammarCoverage& grammar);

/// What the grammar leaves of all recorded energy; 0 when there is none.
double missed_share(const Coverage& coverage, const GrammarCoverage& grammar);

}  // namespace heckbert::report
