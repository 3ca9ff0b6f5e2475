#include <heckbert/cli/pilot.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include <heckbert/cli/settings.h>

namespace heckbert::cli {
namespace {

constexpr int kShrink = 8;             ///< pilot pictures are smaller than the picture by this, each way
constexpr double kEnoughShare = 0.04;  ///< of the whole time: a pilot that took this long can be trusted
constexpr int kMaxPilotSamples = 1'024;
constexpr int kMostToPlan = 32;  ///< samples of a pilot that plans: a block of pixels then has two thousand
constexpr int kMeanRepeats = 4;  ///< so that a quiet pixel can have a quarter of the samples

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int shrunk(int pixels) {
  return std::max(1, pixels / kShrink);
}

}  // namespace

Plan plan_for(const transport::Scene& scene, const transport::RenderSettings& settings, double seconds,
              const std::atomic<bool>& stop) {
  const Clock::time_point start = Clock::now();
  transport::RenderSettings pilot = settings;
  pilot.width = shrunk(settings.width);
  pilot.height = shrunk(settings.height);
  double pixels = static_cast<double>(settings.width) * settings.height;
  if (settings.crop) {
    const record::Window crop = *settings.crop;
    pixels = static_cast<double>(crop.pixel_count());
    pilot.crop = record::Window{std::min(crop.x0 / kShrink, pilot.width - 1),
                                std::min(crop.y0 / kShrink, pilot.height - 1), 0, 0};
    pilot.crop->x1 = std::clamp(crop.x1 / kShrink, pilot.crop->x0 + 1, pilot.width);
    pilot.crop->y1 = std::clamp(crop.y1 / kShrink, pilot.crop->y0 + 1, pilot.height);
  }

  Plan plan;
  for (pilot.samples_per_pixel = 1;; pilot.samples_per_pixel *= 4) {
    const Clock::time_point pilot_start = Clock::now();
    const record::Record record = transport::render(scene, pilot, {.progress = {}, .stop = &stop});
    const double took = std::max(seconds_since(pilot_start), 1e-6);
    plan.samples_per_second = static_cast<double>(record.tally.samples) / took;
    if (stop || took > kEnoughShare * seconds || pilot.samples_per_pixel >= kMaxPilotSamples) break;
  }
  plan.seconds = seconds_since(start);
  const double fitting = std::max(0.0, seconds - plan.seconds) * plan.samples_per_second / pixels;
  plan.samples_per_pixel = static_cast<int>(std::clamp(std::floor(fitting), 1.0, static_cast<double>(kMaxSamples)));
  return plan;
}

transport::RenderSettings adapted(const transport::Scene& scene, transport::RenderSettings settings,
                                  std::span<const taxonomy::Language> classes, const std::atomic<bool>& stop) {
  const int samples = settings.samples_per_pixel;
  transport::RenderSettings pilot = settings;
  pilot.samples_per_pixel = std::clamp(static_cast<int>(kPilotShare / 2 * samples), 1, kMostToPlan);
  const auto rendered = [&](std::uint64_t seed) {
    pilot.seed = seed;
    return transport::render(scene, pilot, {.progress = {}, .stop = &stop});
  };
  // Seeds of samples that the render does not take.
  const record::Record first = rendered(~settings.seed), second = rendered(~settings.seed - 1);
  settings.samples_per_pixel = std::max(1, samples / kMeanRepeats);
  settings.sample_map =
      record::plan_samples(first, second, classes, static_cast<double>(samples) / settings.samples_per_pixel);
  return settings;
}

}  // namespace heckbert::cli
