#include <heckbert/cli/trial.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/strategies.h>
#include <heckbert/taxonomy/symbol_set.h>
#include <heckbert/transport/hash.h>
#include <heckbert/transport/method_options.h>
#include <heckbert/transport/travel.h>

namespace heckbert::cli {

using taxonomy::Symbol;
using transport::claimed_by;

namespace {

constexpr int kFewBatches = 8;

/// Hooks for one render after another, which tell the hooks of all of them how far they are together.
class Together {
 public:
  Together(const transport::RenderHooks& all, std::size_t renders) : all_(all), renders_(renders) {}

  /// For the render that begins. Refers to this.
  transport::RenderHooks next() {
    done_ += begun_ ? 1 : 0;
    begun_ = true;
    rays_before_ += std::exchange(rays_, 0);
    transport::RenderHooks hooks{.progress = {}, .stop = all_.stop};
    if (all_.progress)
      hooks.progress = [this](const transport::Progress& one) {
        rays_ = one.rays;
        all_.progress({(done_ + one.fraction) / static_cast<double>(renders_), rays_before_ + rays_, seconds()});
      };
    return hooks;
  }
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  const transport::RenderHooks& all_;
  std::size_t renders_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool begun_ = false;
  double done_ = 0;
  std::uint64_t rays_before_ = 0, rays_ = 0;
};

/// Of a claimed word: whatever technique the algorithm has for it ends with the walk from the light in the lens.
bool is_by_lens(const transport::AlgorithmFacts& algorithm, const taxonomy::Word& word) {
  const std::vector<taxonomy::Strategy> strategies = taxonomy::strategies(word);
  return std::none_of(strategies.begin(), strategies.end(), [&](const taxonomy::Strategy& strategy) {
    return strategy.eye_vertices > 0 && transport::has_technique(algorithm, word, strategy.light_vertices);
  });
}

}  // namespace

int batches_of(const transport::AlgorithmFacts& algorithm) {
  return algorithm.patches || algorithm.passes ? kFewBatches : record::kBatches;
}

std::optional<TrialRun> run_trial(const transport::AlgorithmFacts& algorithm, const transport::Scene& scene,
                                  const transport::RenderSettings& settings,
                                  std::span<const taxonomy::Language> pictures, const transport::RenderHooks& hooks) {
  TrialRun run{.algorithm = &algorithm};
  const int batches = batches_of(algorithm);
  Together renders(hooks, static_cast<std::size_t>(batches));
  for (int batch = 0; batch < batches; ++batch) {
    transport::RenderSettings part = settings;
    part.algorithm = algorithm.id;
    part.samples_per_pixel = std::max(1, settings.samples_per_pixel / batches);
    part.seed = transport::mix(settings.seed + transport::kWeyl * static_cast<std::uint64_t>(batch + 1));
    run.evidence.add(transport::render(scene, part, renders.next()), pictures);
    if (hooks.stop != nullptr && *hooks.stop) return std::nullopt;
  }
  run.seconds = renders.seconds();
  return run;
}

std::optional<TrialRun> run_refined_trial(const transport::AlgorithmFacts& algorithm, const transport::Scene& scene,
                                          const transport::RenderSettings& settings,
                                          std::span<const taxonomy::Language> pictures,
                                          const transport::RenderHooks& hooks) {
  const transport::MethodOption* option =
      algorithm.accuracy == transport::Accuracy::Consistent ? transport::refining_option(algorithm.id) : nullptr;
  Together runs(hooks, option == nullptr ? 1 : 1 + std::size(kCoarser));
  std::optional<TrialRun> run = run_trial(algorithm, scene, settings, pictures, runs.next());
  if (!run || option == nullptr) return run;
  run->size = option->get(settings.method);
  for (const double factor : kCoarser) {
    transport::RenderSettings coarse = settings;
    option->set(coarse.method, factor * run->size);
    std::optional<TrialRun> coarser = run_trial(algorithm, scene, coarse, {}, runs.next());
    if (!coarser) return std::nullopt;
    run->coarser.push_back({option->get(coarse.method), std::move(coarser->evidence)});
  }
  return run;
}

transport::RenderSettings reference_settings(transport::RenderSettings trials, int samples) {
  trials.seed = ~trials.seed;
  trials.samples_per_pixel = samples;
  return trials;
}

std::vector<Symbol> kinds_of_lights(const transport::Scene& scene) {
  std::vector<Symbol> kinds;
  const bool has_lamps = std::any_of(scene.materials.begin(), scene.materials.end(),
                                     [](const transport::Material& m) { return !is_black(m.emission); });
  if (has_lamps) kinds.push_back(Symbol::La);
  if (!scene.point_lights.empty() || !scene.spot_lights.empty()) kinds.push_back(Symbol::Lp);
  if (!scene.distant_lights.empty()) kinds.push_back(Symbol::Ld);
  if (!is_black(scene.environment) || scene.environment_image) kinds.push_back(Symbol::Le);
  return kinds;
}

Symbol kind_of_eye(const transport::Scene& scene) {
  const bool is_lens = scene.camera.projection == transport::Projection::Perspective && scene.camera.lens_radius > 0;
  return is_lens ? Symbol::El : Symbol::Ep;
}

taxonomy::Language words_between(const std::vector<Symbol>& lights, Symbol eye) {
  taxonomy::Language words;
  for (const Symbol light : lights)
    words = words | taxonomy::compile(fmt::format("{} .* {}", taxonomy::name(light), taxonomy::name(eye)));
  return words;
}

bool takes(const transport::AlgorithmFacts& algorithm, const transport::Scene& scene) {
  return !algorithm.patches || !transport::has_bodies(scene);
}

std::vector<const transport::AlgorithmFacts*> trusted_algorithms(const transport::Scene& scene) {
  std::vector<const transport::AlgorithmFacts*> trusted{&transport::kAlgorithms.front()};
  taxonomy::Language left = words_between(kinds_of_lights(scene), kind_of_eye(scene)) - claimed_by(*trusted.front());
  for (const transport::AlgorithmFacts& algorithm : transport::kAlgorithms) {
    if (algorithm.accuracy != transport::Accuracy::Unbiased || !takes(algorithm, scene)) continue;
    const taxonomy::Language claimed = claimed_by(algorithm);
    if ((claimed & left).is_empty()) continue;
    trusted.push_back(&algorithm);
    left = left - claimed;
  }
  return trusted;
}

std::vector<taxonomy::Language> shares_of(const std::vector<const transport::AlgorithmFacts*>& trusted,
                                          const std::vector<Symbol>& lights, Symbol eye) {
  taxonomy::Language left = words_between(lights, eye);
  std::vector<taxonomy::Language> shares;
  for (const transport::AlgorithmFacts* algorithm : trusted) {
    shares.push_back(claimed_by(*algorithm) & left);
    left = left - shares.back();
  }
  return shares;
}

std::vector<report::Witness> witnesses_of(const std::vector<TrialRun>& trusted) {
  std::vector<report::Witness> witnesses;
  for (const TrialRun& run : trusted)
    witnesses.push_back({std::string(run.algorithm->name), &run.evidence, claimed_by(*run.algorithm)});
  return witnesses;
}

std::vector<report::Trial> trials_of(const std::vector<TrialRun>& runs, Symbol eye) {
  std::vector<report::Trial> trials;
  for (const TrialRun& run : runs) {
    trials.push_back({.algorithm = std::string(run.algorithm->name),
                      .title = std::string(run.algorithm->title),
                      .grammar = std::string(run.algorithm->grammar),
                      .evidence = &run.evidence,
                      .claimed = claimed_by(*run.algorithm),
                      .may_be_wrong = run.algorithm->accuracy == transport::Accuracy::Biased,
                      .shares_light = run.algorithm->passes,
                      .is_by_lens = {}});
    if (eye == Symbol::El)
      trials.back().is_by_lens = [&algorithm = *run.algorithm](const taxonomy::Word& word) {
        return is_by_lens(algorithm, word);
      };
    if (run.coarser.empty()) continue;
    const transport::MethodOption& option = *transport::refining_option(run.algorithm->id);
    report::Refinement refinement{.option = std::string(option.name), .order = option.order, .size = run.size};
    for (const CoarserRun& stage : run.coarser) refinement.coarser.push_back({stage.size, &stage.evidence});
    trials.back().refinement = std::move(refinement);
  }
  return trials;
}

std::optional<report::Verification> verify_twice(std::vector<TrialRun>& runs,
                                                 const std::vector<report::Witness>& witnesses,
                                                 const std::vector<Symbol>& lights, Symbol eye,
                                                 const report::VerdictOptions& options,
                                                 const transport::RenderSettings& settings, const RunAgain& run_again) {
  transport::RenderSettings again = settings;
  again.seed = transport::mix(settings.seed + transport::kWeyl * (record::kBatches + 1));
  again.samples_per_pixel *= kRepeatFactor;
  const report::Verification first = report::verify(trials_of(runs, eye), witnesses, lights, options);
  bool is_doubtful = false;
  for (TrialRun& run : runs) {
    const bool failed = std::any_of(first.verdicts.begin(), first.verdicts.end(), [&](const auto& verdict) {
      return verdict.algorithm == run.algorithm->name && !verdict.is_expected;
    });
    if (!failed) continue;
    std::optional<TrialRun> repeated = run_again(*run.algorithm, again);
    if (!repeated) return std::nullopt;
    run = std::move(*repeated);
    is_doubtful = true;
  }
  return is_doubtful ? report::verify(trials_of(runs, eye), witnesses, lights, options) : first;
}

}  // namespace heckbert::cli
