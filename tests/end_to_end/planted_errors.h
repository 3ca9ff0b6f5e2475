#pragma once
// What `heckbert verify` does with one algorithm on one scene, with a planted error or without.

#include <heckbert/cli/trial.h>
#include <heckbert/report/verdict.h>
#include <heckbert/transport/fault.h>

namespace heckbert::cli {

/// A room with a lamp, a point light, glossy and diffuse surfaces, a mirror and a ball of glass.
transport::Scene room_of_everything();

struct Trials {
  transport::Scene scene;
  transport::RenderSettings settings;
  std::vector<TrialRun> trusted;
};

/// Runs the references.
Trials prepared(transport::Scene scene, const transport::RenderSettings& settings);

/// Runs the reference path tracer's code with an error in it, or without.
report::Verification path_tracer_on_trial(const Trials& trials, transport::Fault fault,
                                          const report::VerdictOptions& options = {});

/// The errors that verification must find, each in these words and in no others.
struct PlantedError {
  transport::Fault fault;
  const char* name;
  const char* words;  ///< that it makes wrong
};
inline constexpr PlantedError kPlantedErrors[] = {
    {transport::Fault::HalvedLobe, "halved lobe", "L G .* E"},
    {transport::Fault::DroppedWeight, "dropped weight", "La N .* E"},
    {transport::Fault::MissingCosine, "missing cosine", "L N .* E"},
    {transport::Fault::WrongLightDensity, "wrong density of a light", "La N .* E"},
};

/// Every planted error is found, in the right words.
void expect_planted_errors_are_found(const Trials& trials);

/// Of so many verifications without an error, under seeds of their own, how many raise alarm.
int false_alarms(int verifications, const transport::RenderSettings& settings, double significance);

}  // namespace heckbert::cli
