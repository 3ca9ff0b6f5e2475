#include "end_to_end/planted_errors.h"

#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/transport/material.h>

namespace heckbert::cli {
namespace {

using transport::Scene;

void add(Scene& scene, transport::Geometry geometry, transport::Material material) {
  scene.materials.push_back(std::move(material));
  scene.shapes.push_back({.name = "",
                          .geometry = std::move(geometry),
                          .material = static_cast<std::uint32_t>(scene.materials.size() - 1)});
}

const transport::AlgorithmFacts& path_tracer() {
  return transport::kAlgorithms.front();
}

}  // namespace

/// The lamp is wide, so that it is found by chance often enough for its weight to matter.
Scene room_of_everything() {
  using namespace transport;
  Scene scene;
  scene.name = "room of everything";
  add(scene, make_box({-2, -1, -2}, {2, 2, 2}, true), {.name = "wall", .lobes = {Lambert{Rgb(0.6f)}}});
  add(scene, make_quad({-1.5f, 1.99f, -1.5f}, {3, 0, 0}, {0, 0, 3}), {.name = "lamp", .emission = Rgb(1)});
  add(scene, make_quad({-1.99f, -0.5f, -1}, {0, 0, 2}, {0, 1.5f, 0}), {.name = "mirror", .lobes = {Mirror{Rgb(0.9f)}}});
  add(scene, Sphere{{0.8f, -0.4f, 0.2f}, 0.5f}, {.name = "glass", .lobes = {Dielectric{}}});
  add(scene, make_box({-1.5f, -1, -1.5f}, {1.5f, -0.9f, 1.5f}),
      {.name = "lacquer", .lobes = {Lambert{Rgb(0.3f)}, ggx(Rgb(0.4f), 0.4f)}});
  scene.point_lights.push_back({.position = {-1, 1.5f, 1}, .intensity = Rgb(1)});
  scene.camera = {.position = {1.6f, 0.4f, 1.8f}, .look_at = {-0.4f, -0.2f, -0.4f}, .vertical_fov_degrees = 70};
  return scene;
}

Trials prepared(Scene scene, const transport::RenderSettings& settings) {
  Trials trials{std::move(scene), settings, {}};
  trials.trusted.push_back(*run_trial(path_tracer(), trials.scene,
                                      reference_settings(settings, kReferenceFactor * settings.samples_per_pixel), {},
                                      {}));
  return trials;
}

report::Verification path_tracer_on_trial(const Trials& trials, transport::Fault fault,
                                          const report::VerdictOptions& options) {
  const RunAgain run = [&](const transport::AlgorithmFacts& algorithm, const transport::RenderSettings& settings) {
    return run_trial(algorithm, trials.scene, settings, {}, {});
  };
  transport::plant(fault);
  std::vector<TrialRun> runs;
  runs.push_back(*run(path_tracer(), trials.settings));
  report::Verification verification = *verify_twice(runs, witnesses_of(trials.trusted), kinds_of_lights(trials.scene),
                                                    kind_of_eye(trials.scene), options, trials.settings, run);
  transport::plant(transport::Fault::None);
  return verification;
}

void expect_planted_errors_are_found(const Trials& trials) {
  for (const PlantedError& error : kPlantedErrors) {
    SCOPED_TRACE(error.name);
    const taxonomy::Language wrong = taxonomy::compile(error.words);
    std::size_t found = 0;
    for (const report::AlgorithmVerdict& verdict :
         path_tracer_on_trial(trials, error.fault, {.spelling = report::Spelling::Fine}).verdicts)
      for (const report::WordFinding& word : verdict.words) {
        EXPECT_NE(word.standing, report::Standing::Missing);
        EXPECT_NE(word.standing, report::Standing::Unclaimed);
        if (word.standing != report::Standing::Differs || word.pooled > 1) continue;
        EXPECT_TRUE(wrong.contains(taxonomy::parse_word(word.word))) << word.word << " is innocent";
        ++found;
      }
    EXPECT_GE(found, 3u);
  }
}

int false_alarms(int verifications, const transport::RenderSettings& settings, double significance) {
  int alarms = 0;
  for (int i = 1; i <= verifications; ++i) {
    transport::RenderSettings seeded = settings;
    seeded.seed = static_cast<std::uint64_t>(i);
    const report::Verification verification = path_tracer_on_trial(
        prepared(room_of_everything(), seeded), transport::Fault::None, {.significance = significance});
    bool alarm = false;
    for (const report::AlgorithmVerdict& verdict : verification.verdicts) alarm |= !verdict.is_expected;
    alarms += alarm ? 1 : 0;
  }
  return alarms;
}

}  // namespace heckbert::cli
