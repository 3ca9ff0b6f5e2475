#pragma once
// What the commands that run algorithms against each other have in common.

#include <atomic>
#include <span>
#include <string>
#include <vector>

#include <heckbert/cli/console.h>
#include <heckbert/cli/settings.h>
#include <heckbert/cli/trial.h>
#include <heckbert/transport/render.h>

namespace CLI {
class App;
}

namespace heckbert::cli {

/// Adds the argument SCENE.
void add_scene_to_try(CLI::App& command, std::string& name);

/// Of flags, of the scene where it says how deep, and of kTrialSide and kTrialSamples.
transport::RenderSettings settings_to_try(const Settings& settings, const transport::RenderDefaults& scene);

/// How an algorithm is run: run_trial() or run_refined_trial().
using Runner = decltype(run_trial);

/// Runs it, tells so on the console and puts it behind `runs`. False when it was stopped.
bool try_out(Runner& run_it, const transport::AlgorithmFacts& algorithm, const transport::Scene& scene,
             const transport::RenderSettings& settings, std::span<const taxonomy::Language> pictures,
             const std::atomic<bool>& stop, const Console& console, std::vector<TrialRun>& runs);

}  // namespace heckbert::cli
