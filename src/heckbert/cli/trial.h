#pragma once
// Algorithms run against each other: each renders the same picture many times over, independently, and the renders are
// the batches of its evidence.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <heckbert/report/evidence.h>
#include <heckbert/report/verdict.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/language.h>
#include <heckbert/transport/claims.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {

/// What a picture for comparing is, unless flags say otherwise: small, because every algorithm has to make it. The side
/// is the longer one; the other follows the scene's own picture.
inline constexpr int kTrialSide = 128, kTrialSamples = 64, kReferenceFactor = 4;

/// How many times as coarse the renders are through which an error is followed to the ones on trial, coarsest first.
inline constexpr double kCoarser[] = {4, 2};

/// The same algorithm with a coarser setting.
struct CoarserRun {
  double size = 0;  ///< of the option that makes it finer
  report::Evidence evidence{};
};

/// An algorithm and what it rendered.
struct TrialRun {
  const transport::AlgorithmFacts* algorithm = nullptr;
  report::Evidence evidence{};
  double seconds = 0;
  double size = 0;                    ///< of the option that makes it finer; 0: nothing does
  std::vector<CoarserRun> coarser{};  ///< as kCoarser
};

/// Independent renders, so many of each algorithm: record::kBatches, and fewer where each has to solve the whole scene
/// again, or where all pixels of a sample share photons or virtual lights: means of single samples are far from normal
/// there, and later samples may be finer than the first.
int batches_of(const transport::AlgorithmFacts& algorithm);

/// Renders batches_of() times with an equal part of settings.samples_per_pixel each, at least one, and seeds that
/// all follow from settings.seed. Keeps pictures of the languages. The hooks are told of all renders together.
/// Nothing when it was stopped. Errors: as render().
std::optional<TrialRun> run_trial(const transport::AlgorithmFacts& algorithm, const transport::Scene& scene,
                                  const transport::RenderSettings& settings,
                                  std::span<const taxonomy::Language> pictures, const transport::RenderHooks& hooks);

/// run_trial() with the settings, and where the algorithm is right only in the limit with coarser ones too. Nothing
/// when it was stopped. Errors: as render().
std::optional<TrialRun> run_refined_trial(const transport::AlgorithmFacts& algorithm, const transport::Scene& scene,
                                          const transport::RenderSettings& settings,
                                          std::span<const taxonomy::Language> pictures,
                                          const transport::RenderHooks& hooks);

/// The settings of everything that trials with these settings are compared with: other samples, and `samples` of them
/// per pixel.
transport::RenderSettings reference_settings(transport::RenderSettings trials, int samples);

/// The kinds of lights that the scene has.
std::vector<taxonomy::Symbol> kinds_of_lights(const transport::Scene& scene);
taxonomy::Symbol kind_of_eye(const transport::Scene& scene);

/// All words between these lights and this eye.
taxonomy::Language words_between(const std::vector<taxonomy::Symbol>& lights, taxonomy::Symbol eye);

/// Can the algorithm render the scene? Radiosity knows no media.
bool takes(const transport::AlgorithmFacts& algorithm, const transport::Scene& scene);

/// The algorithms whose word is taken, in this order: the reference path tracer, and as many unbiased others as it
/// takes for every word between the scene's lights and its eye that some unbiased algorithm claims.
std::vector<const transport::AlgorithmFacts*> trusted_algorithms(const transport::Scene& scene);

/// By trusted algorithm: the words that none before it claims.
std::vector<taxonomy::Language> shares_of(const std::vector<const transport::AlgorithmFacts*>& trusted,
                                          const std::vector<taxonomy::Symbol>& lights, taxonomy::Symbol eye);

/// Runs as report::verify() takes them; they refer to the evidence of the runs.
std::vector<report::Witness> witnesses_of(const std::vector<TrialRun>& trusted);
std::vector<report::Trial> trials_of(const std::vector<TrialRun>& runs, taxonomy::Symbol eye);

/// How many times the samples a trial is repeated with before it is believed that a grammar's prediction failed: what
/// was a few bright paths that chance left out shows itself, an error stays.
inline constexpr int kRepeatFactor = 4;

/// Runs an algorithm with these settings; nothing when it was stopped.
using RunAgain =
    std::function<std::optional<TrialRun>(const transport::AlgorithmFacts&, const transport::RenderSettings&)>;

/// report::verify() of the runs, made with `settings`. Those of which a prediction failed, in a way that is not known
/// of the algorithm, are run again with other seeds and kRepeatFactor times the samples, and all are judged anew.
/// Nothing when it was stopped.
std::optional<report::Verification> verify_twice(std::vector<TrialRun>& runs,
                                                 const std::vector<report::Witness>& witnesses,
                                                 const std::vector<taxonomy::Symbol>& lights, taxonomy::Symbol eye,
                                                 const report::VerdictOptions& options,
                                                 const transport::RenderSettings& settings, const RunAgain& run_again);

}  // namespace heckbert::cli
