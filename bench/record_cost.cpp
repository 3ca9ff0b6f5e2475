// What recording every word costs: the processor time of a render with the record on over that with the record off
// (nothing spelt, one colour added per contribution), same scene, same seed, in turn; the median of the ratios of each
// pair, since the speed of a machine drifts. Also the peak memory of either.
//
// Usage: record_cost [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]     defaults 5 64 512

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <vector>

#include <fmt/format.h>

#include <heckbert/import/import.h>
#include <heckbert/transport/render.h>

namespace {

using namespace heckbert;

/// Processor time of all threads, so that other work on the machine matters little.
template <class F>
double seconds(F f) {
  const std::clock_t start = std::clock();
  f();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Of this process so far, in MB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
  const int samples = argc > 2 ? std::atoi(argv[2]) : 64;
  const int size = argc > 3 ? std::atoi(argv[3]) : 512;
  if (rounds < 1 || samples < 1 || size < 1) {
    fmt::print(stderr, "usage: record_cost [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]\n");
    return 2;
  }
  for (const char* name : {"cornell", "lecture"}) {
    const transport::Scene scene = import::load_scene_or_builtin(name).scene;
    const transport::RenderSettings settings{.width = size, .height = size, .samples_per_pixel = samples};
    std::vector<double> ratios, with, without;
    double memory_without = 0;
    std::size_t words = 0, entries = 0;
    for (int round = 0; round < rounds; ++round) {
      without.push_back(seconds([&] { transport::render_picture_only(scene, settings); }));
      if (round == 0) memory_without = peak_memory();
      with.push_back(seconds([&] {
        const record::Record record = transport::render(scene, settings);
        words = record.words.size();
        entries = record.entries.size();
      }));
      ratios.push_back(with.back() / without.back());
    }
    fmt::print(
        "{} {}x{}, {} samples, {} rounds: record on {:.2f} s, off {:.2f} s, ratio on/off {:.3f} ({:.3f} to {:.3f});"
        " {} words, {:.1f} entries per pixel; peak memory {:.0f} MB, {:.0f} MB before the first record\n",
        name, size, size, samples, rounds, median(with), median(without), median(ratios),
        *std::min_element(ratios.begin(), ratios.end()), *std::max_element(ratios.begin(), ratios.end()), words,
        static_cast<double>(entries) / (static_cast<double>(size) * size), peak_memory(), memory_without);
  }
}
