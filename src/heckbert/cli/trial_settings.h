#pragma once
// Flags of the commands that run algorithms against each other.

#include <string>

#include <CLI/CLI.hpp>

#include <heckbert/cli/settings.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {

/// Adds the argument SCENE.
void add_scene_to_try(CLI::App& command, std::string& name);

/// Of flags, of the scene where it says how deep, and of kTrialSide and kTrialSamples.
transport::RenderSettings settings_to_try(const Settings& settings, const transport::RenderDefaults& scene);

}  // namespace heckbert::cli
