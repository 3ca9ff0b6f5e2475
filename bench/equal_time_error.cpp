// What next-event estimation and multiple importance weights are worth: the error at equal time of the reference path
// tracer over its error when it finds lamps by running into them alone. The error is the root of the mean square over
// the pixels, from pairs of independent renders, so it needs no reference picture; time is processor time. At equal
// time the mean square goes as the square error times the cost.
//
// Usage: equal_time_error [PAIRS [SAMPLES_PER_PIXEL [SIZE]]]     defaults 4 16 128

#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include <heckbert/import/import.h>
#include <heckbert/transport/render.h>

namespace {

using namespace heckbert;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Cost {
  double square_error = 0, seconds = 0;
  double product() const { return square_error * seconds; }
};

/// Adds one pair of renders.
void measure(Cost& cost, const transport::Scene& scene, transport::RenderSettings settings, std::uint64_t seed) {
  std::array<record::Image, 2> pictures;
  const double start = processor_seconds();
  for (std::uint64_t i = 0; i < 2; ++i) {
    settings.seed = seed + i;
    pictures[i] = record::beauty(transport::render(scene, settings));
  }
  cost.seconds += processor_seconds() - start;
  double sum = 0;
  for (std::size_t p = 0; p < pictures[0].pixels.size(); ++p) {
    const double d = static_cast<double>(luminance(pictures[0].pixels[p]) - luminance(pictures[1].pixels[p]));
    sum += 0.5 * d * d;
  }
  cost.square_error += sum / static_cast<double>(pictures[0].pixels.size());
}

}  // namespace

int main(int argc, char** argv) {
  const int pairs = argc > 1 ? std::atoi(argv[1]) : 4;
  const int samples = argc > 2 ? std::atoi(argv[2]) : 16;
  const int size = argc > 3 ? std::atoi(argv[3]) : 128;
  if (pairs < 1 || samples < 1 || size < 1) {
    fmt::print(stderr, "usage: equal_time_error [PAIRS [SAMPLES_PER_PIXEL [SIZE]]]\n");
    return 2;
  }
  for (const char* name : {"cornell", "lecture", "caustic"}) {
    const transport::Scene scene = import::load_scene_or_builtin(name).scene;
    transport::RenderSettings with{.width = size, .height = size, .samples_per_pixel = samples, .threads = 1};
    transport::RenderSettings without = with;
    without.algorithm = transport::AlgorithmId::PathHits;
    Cost next_event, hits;
    for (int pair = 0; pair < pairs; ++pair) {
      measure(next_event, scene, with, 1 + 4 * static_cast<std::uint64_t>(pair));
      measure(hits, scene, without, 3 + 4 * static_cast<std::uint64_t>(pair));
    }
    fmt::print("{}: error at equal time, next event over hits alone: {:.3f}; per path {:.3f}, time per path {:.2f}\n",
               name, std::sqrt(next_event.product() / hits.product()),
               std::sqrt(next_event.square_error / hits.square_error), next_event.seconds / hits.seconds);
  }
}
