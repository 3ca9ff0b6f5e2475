#pragma once
// Does an algorithm find what its grammar predicts, with the right values? Its own renders are held against those of
// witnesses: algorithms that are trusted for the words of a language. All here is data in, data out.
//
// By kind of light, every word that the grammar claims and a witness vouches for is compared, in the whole picture and
// in every block of pixels; the significance is that of a whole verification, all its comparisons together. Words that
// are too rare to be compared alone are compared together. A word that is found and not claimed needs no statistics:
// one path is a proof. A word that is claimed and not found is missing once as many paths as the witness has of it
// should not have left it out. Where an algorithm is right only in the limit, what differs is followed through coarser
// renders: convergence.h.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/report/comparison.h>
#include <heckbert/report/convergence.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/evidence.h>
#include <heckbert/report/word_groups.h>
#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/symbol.h>

namespace heckbert::report {

/// How one word stands.
enum class Standing : std::uint8_t { Differs, Missing, Unclaimed, Converges, Rare, Untold, Agrees };

struct StandingFacts {
  Standing standing;
  std::string_view name;     ///< in JSON
  std::string_view meaning;  ///< for people, after the word
};

inline constexpr std::array<StandingFacts, 7> kStandings{{
    {Standing::Differs, "differs", "has another value"},
    {Standing::Missing, "missing", "is claimed and not found"},
    {Standing::Unclaimed, "unclaimed", "is found and not claimed"},
    {Standing::Converges, "converges", "has another value, and comes nearer"},
    {Standing::Rare, "rare", "is found too rarely to be compared"},
    {Standing::Untold, "untold", "has nothing sure to be compared with"},
    {Standing::Agrees, "agrees", "agrees"},
}};

/// What all of them come to; the first that holds.
enum class Ruling : std::uint8_t { Oversteps, Misses, WrongValues, Converges, NeedsSamples, Untold, Nothing, Captures };

struct RulingFacts {
  Ruling ruling;
  std::string_view name;      ///< in JSON
  std::string_view sentence;  ///< for people
  bool is_as_claimed;         ///< the grammar's prediction came true
};

inline constexpr std::array<RulingFacts, 8> kRulings{{
    {Ruling::Oversteps, "oversteps", "finds words it does not claim", false},
    {Ruling::Misses, "misses", "misses words it claims", false},
    {Ruling::WrongValues, "wrong-values", "right words, wrong values", false},
    {Ruling::Converges, "converges", "right words, and values come nearer", true},
    {Ruling::NeedsSamples, "needs-samples", "captured, but needs about N samples", true},
    {Ruling::Untold, "untold", "nothing to compare with", true},
    {Ruling::Nothing, "nothing", "finds nothing, as it claims", true},
    {Ruling::Captures, "captures", "captures exactly", true},
}};

constexpr const StandingFacts& facts(Standing standing) {
  return kStandings[static_cast<std::size_t>(standing)];
}
constexpr const RulingFacts& facts(Ruling ruling) {
  return kRulings[static_cast<std::size_t>(ruling)];
}

/// Renders that are put to the test.
struct Trial {
  std::string algorithm, title, grammar;
  const Evidence* evidence = nullptr;
  taxonomy::Language claimed;
  bool may_be_wrong = false;  ///< its values, whatever its settings: missing shadows, clamped light
  bool shares_light = false;  ///< its pixels share photons or virtual lights
  /// Does only a walk into the lens of the eye find the word? That is so seldom, and nothing is known of it before one
  /// is found, that it has no use to ask whether it should have been. Empty: of no word.
  std::function<bool(const taxonomy::Word&)> is_by_lens{};
  std::optional<Refinement> refinement{};  ///< of an algorithm that is right only in the limit
};

struct BlockFinding {
  record::Window pixels;
  Comparison comparison;
  std::optional<Sequence> sequence{};  ///< where the trial has a refinement
};

/// Of the words that print alike, or, with `pooled` above 1, of the rare ones together.
struct WordFinding {
  std::string word;  ///< "LDSE"; "5 rare words"
  std::size_t length = 0;
  std::size_t pooled = 1;
  Standing standing = Standing::Untold;
  std::string witness{};  ///< whose word is taken; empty: nobody's
  Comparison comparison;  ///< picture-mean luminance
  std::uint64_t expected_count = 0, found_count = 0;
  std::optional<record::Estimate> ratio{};  ///< found / expected
  std::optional<Sequence> sequence{};       ///< where the trial has a refinement, and the word is compared
  std::size_t blocks_compared = 0, blocks_that_differ = 0;
  std::optional<BlockFinding> worst_block{};  ///< of those that differ
  std::optional<BrightPixel> brightest{};     ///< of the algorithm's own, or where it has none of the witness's
  std::optional<double> samples_needed{};     ///< per pixel, for VerdictOptions::error
};

struct AlgorithmVerdict {
  std::string algorithm, title, grammar;
  taxonomy::Symbol light = taxonomy::Symbol::La;
  int samples_per_pixel = 0;    ///< all batches together, rounded
  std::string refined_by{};     ///< the option that makes it finer; empty: none
  std::vector<double> sizes{};  ///< of that option, as in every Sequence
  Ruling ruling = Ruling::Captures;
  bool is_expected = true;           ///< the prediction came true, or fails as is known of the algorithm
  std::vector<WordFinding> words{};  ///< as kStandings orders their standings; within one, by energy, most first
  /// The shortest word of those that made the ruling; among equals the first in letters. Empty when it captures.
  std::string shortest{};
  /// Found over expected, of all words that were compared.
  std::optional<record::Estimate> ratio{};
  /// Samples per pixel that 90 % of the expected energy takes, each word for its own; unset where not even so much was
  /// found often enough to tell.
  std::optional<double> samples_needed{};
};

struct VerdictOptions {
  double significance = 0.01;              ///< of false alarm in the whole verification
  double confidence = 0.95;                ///< of intervals
  double error = CoverageOptions{}.error;  ///< relative, of a pixel: what samples are needed for
  double budget = 16384;                   ///< samples per pixel; a verdict says so when more are needed
  Spelling spelling = Spelling::Plain;
};

struct Verification {
  VerdictOptions options;
  std::size_t comparisons = 0;
  std::vector<AlgorithmVerdict> verdicts;  ///< by algorithm, then by kind of light
};

/// Takes: at least one witness, in the order in which they are believed; the kinds of light that the scene has.
/// Evidence has at least two batches.
Verification verify(const std::vector<Trial>& trials, const std::vector<Witness>& witnesses,
                    const std::vector<taxonomy::Symbol>& lights, const VerdictOptions& options = {});

}  // namespace heckbert::report
