// What each algorithm costs at equal samples: processor time over that of the path tracer, on the same scene, one
// thread, in turn; the median of the ratios of each pair. Aim: bidirectional path tracing at most 3.5 times. An
// algorithm that takes no such scene is left out.
//
// Usage: algorithms [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]     defaults 3 16 128

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include <heckbert/import/import.h>
#include <heckbert/transport/render.h>

namespace {

using namespace heckbert;

double seconds_of(const transport::Scene& scene, const transport::RenderSettings& settings) {
  const std::clock_t start = std::clock();
  transport::render(scene, settings);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 3;
  const int samples = argc > 2 ? std::atoi(argv[2]) : 16;
  const int size = argc > 3 ? std::atoi(argv[3]) : 128;
  if (rounds < 1 || samples < 1 || size < 1) {
    fmt::print(stderr, "usage: algorithms [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]\n");
    return 2;
  }
  for (const char* name : {"cornell", "lecture", "caustic"}) {
    const transport::Scene scene = import::load_scene_or_builtin(name).scene;
    const transport::RenderSettings path{.width = size, .height = size, .samples_per_pixel = samples, .threads = 1};
    for (const transport::AlgorithmFacts& algorithm : transport::kAlgorithms) {
      transport::RenderSettings settings = path;
      settings.algorithm = algorithm.id;
      std::vector<double> ratios;
      try {
        for (int round = 0; round < rounds; ++round) {
          const double reference = seconds_of(scene, path);
          ratios.push_back(seconds_of(scene, settings) / reference);
        }
        fmt::print("{:<10} {:<20} {:.2f}\n", name, algorithm.name, median(ratios));
      } catch (const std::invalid_argument& refusal) {
        fmt::print("{:<10} {:<20} {}\n", name, algorithm.name, refusal.what());
      }
    }
  }
}
