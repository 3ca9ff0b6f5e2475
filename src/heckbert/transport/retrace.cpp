#include <heckbert/transport/retrace.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <heckbert/record/record.h>
#include <heckbert/transport/stage.h>

namespace heckbert::transport {

namespace {

/// Spells words and keeps nothing else: what was found is taken from the walk.
class SpellingSink final : public record::PathSink {
 public:
  void begin_sample(int, int, int) override {}
  void add(const record::Contribution&) override {}
  void add_non_path(record::NonPath, Rgb) override {}
  void end_path(record::PathEnd) override {}
};

}  // namespace

std::vector<RetracedPath> retrace(const Scene& scene, const RenderSettings& settings, int x, int y) {
  if (facts(settings.algorithm).from_light)
    throw std::invalid_argument(
        fmt::format("{} walks from the light too: which of these walks brought paths to a pixel "
                    "was not kept, and none is traced again",
                    facts(settings.algorithm).title));
  const Stage stage(scene, settings);
  const World& world = stage.world();
  SpellingSink sink;
  world.labels.number_in(sink.words());
  const SamplePlan plan{settings.sampler, settings.seed, settings.samples_per_pixel};
  std::vector<RetracedPath> paths;
  for (int sample = 0; sample < settings.samples_per_pixel; ++sample) {
    std::vector<record::Contribution> found;
    Trail trail;
    Walk walk{.sink = sink, .found = found, .sampler = Sampler(plan, x, y, sample), .bodies = world.bodies_at_eye};
    walk.trail = &trail;
    trace(world, walk, x, y, settings.algorithm);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!record::is_recordable(found[i].value)) continue;
      std::reverse(trail.of_found[i].begin(), trail.of_found[i].end());
      paths.push_back(
          {sink.words().word(found[i].word), sample, found[i].technique, found[i].value, std::move(trail.of_found[i])});
    }
  }
  return paths;
}

}  // namespace heckbert::transport
