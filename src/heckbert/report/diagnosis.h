#pragma once
// Why is it black? What an algorithm cannot find of a scene, or finds too rarely, by the word: how much light that is
// by the word of those who can find it, with which strategies a path of the word can be found at all, which of them the
// algorithm has and used, and who else claims the word.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <heckbert/report/evidence.h>
#include <heckbert/report/verdict.h>
#include <heckbert/taxonomy/strategies.h>

namespace heckbert::report {

/// What one technique of the algorithm was seen to bring of a word.
struct MeasuredTechnique {
  taxonomy::Word word;
  std::size_t light_vertices = 0;
  bool merged = false;
  std::uint64_t count = 0;              ///< contributions
  double mean = 0, standard_error = 0;  ///< picture-mean luminance
};

/// An algorithm, what its grammar claims, and what it takes.
struct Candidate {
  std::string algorithm;
  taxonomy::Language claimed;
  /// Seconds until the root-mean-square error of pixels is VerdictOptions::error of the mean luminance of what it
  /// finds; unset where it was not run or found nothing.
  std::optional<double> seconds{};
  double share = 0;         ///< of all known energy: what it claims
  bool is_minimal = false;  ///< enough by itself, and none that is enough claims less
};

/// A candidate that claims this share is enough.
inline constexpr double kSufficient = 0.99;

struct Suspect {
  std::string algorithm, title;
  const Evidence* evidence = nullptr;
  taxonomy::Language claimed;
  /// Is the strategy one of its techniques for the word?
  std::function<bool(const taxonomy::Word&, const taxonomy::Strategy&)> has;
};

struct StrategyUse {
  taxonomy::Strategy strategy;
  bool is_had = false;                          ///< by the algorithm
  std::optional<MeasuredTechnique> measured{};  ///< of all words that print alike; unset where it brought nothing
};

struct Cause {
  std::string word;
  std::size_t length = 0;
  taxonomy::Symbol light = taxonomy::Symbol::La;
  bool is_claimed = false;  ///< by the algorithm: it is found too rarely; else it cannot be found
  record::Estimate energy;  ///< picture-mean luminance, as the witness has it
  double share = 0;         ///< of all known energy
  std::string witness;
  BrightPixel brightest{};  ///< of the witness
  std::uint64_t found_count = 0;
  std::optional<double> samples_needed{};  ///< unset where nothing was found
  std::vector<StrategyUse> strategies;     ///< all that there are
  std::vector<std::string> finders;        ///< candidates that claim the word, cheapest first
};

struct Diagnosis {
  std::string algorithm, title;
  VerdictOptions options;
  double total = 0;                   ///< energy of all words that somebody vouches for
  double unreachable = 0;             ///< share of it that the algorithm cannot find
  double rare = 0;                    ///< share of it that takes more samples than the budget
  std::vector<Cause> causes;          ///< what cannot be found, then what is rare; by energy, most first
  std::vector<Candidate> candidates;  ///< by seconds, those without last
  bool has_measured = false;          ///< the techniques that the algorithm used are known
};

/// Takes witnesses as verify() does. `measured` may be empty.
Diagnosis diagnose(const Suspect& suspect, const std::vector<Witness>& witnesses, std::vector<Candidate> candidates,
                   const std::vector<MeasuredTechnique>& measured, const taxonomy::Language& words_of_scene,
                   const VerdictOptions& options = {});

/// Samples per pixel until the root-mean-square error of pixels is `error` of the mean luminance; unset when the
/// picture is black.
std::optional<double> samples_for_picture(const NoisyImage& image, double samples_per_pixel, double error);

}  // namespace heckbert::report
