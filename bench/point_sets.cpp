// What do evenly spread points gain? The same scenes with Sobol and with random points, equal samples: the ratio of the
// variances of pixels, of the variances of the picture's mean, and of the times, for all light that was scattered.
//
//   point_sets [side of the picture in pixels] [pairs of seeds]

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include <heckbert/import/import.h>
#include <heckbert/record/statistics.h>
#include <heckbert/transport/render.h>

namespace {

using namespace heckbert;
using transport::SamplerKind;

struct Spread {
  double pixel_variance = 0;  ///< mean over pixels
  double mean_variance = 0;   ///< of the picture's mean, as its intervals say
  double seconds = 0;         ///< of the processor
};

/// From pairs of renders with different seeds: half the squared difference is the variance of one.
Spread measure(const transport::Scene& scene, SamplerKind sampler, int side, int samples, int pairs) {
  Spread spread;
  for (int pair = 0; pair < pairs; ++pair) {
    record::Image image[2];
    for (int i = 0; i < 2; ++i) {
      const transport::RenderSettings settings{.width = side,
                                               .height = side,
                                               .samples_per_pixel = samples,
                                               .seed = static_cast<std::uint64_t>(2 * pair + i + 1),
                                               .threads = 1,
                                               .sampler = sampler};
      const std::clock_t start = std::clock();
      const record::Record record = transport::render(scene, settings);
      spread.seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      // Without LE: the few pixels on the rim of a lamp would outweigh all others.
      std::vector<bool> scattered;
      for (const taxonomy::Word& word : record.words) scattered.push_back(!word.events.empty());
      image[i] = record::image_of(record, scattered);
      const auto all = record::energy(record, scattered);
      spread.mean_variance += all.standard_error * all.standard_error / (2 * pairs);
    }
    double sum = 0;
    for (std::size_t p = 0; p < image[0].pixels.size(); ++p) {
      const double d =
          static_cast<double>(luminance(image[0].pixels[p])) - static_cast<double>(luminance(image[1].pixels[p]));
      sum += 0.5 * d * d;
    }
    spread.pixel_variance += sum / static_cast<double>(image[0].pixels.size()) / pairs;
  }
  return spread;
}

}  // namespace

int main(int argc, char** argv) {
  const int side = argc > 1 ? std::atoi(argv[1]) : 64;
  const int pairs = argc > 2 ? std::atoi(argv[2]) : 4;
  fmt::print("{}x{} pixels, {} pairs of seeds; random over sobol, above 1 is a gain (time: sobol over random)\n", side,
             side, pairs);
  fmt::print("{:10} {:>8} {:>16} {:>22} {:>6}\n", "scene", "samples", "pixel variance", "picture mean variance",
             "time");
  for (const char* name : {"cornell", "lecture", "caustic"}) {
    const transport::Scene scene = import::load_scene_or_builtin(name).scene;
    for (const int samples : {16, 64, 256, 1024}) {
      const Spread random = measure(scene, SamplerKind::Random, side, samples, pairs);
      const Spread sobol = measure(scene, SamplerKind::Sobol, side, samples, pairs);
      fmt::print("{:10} {:8} {:16.2f} {:22.2f} {:6.2f}\n", name, samples, random.pixel_variance / sobol.pixel_variance,
                 random.mean_variance / sobol.mean_variance, sobol.seconds / random.seconds);
      std::fflush(stdout);
    }
  }
}
