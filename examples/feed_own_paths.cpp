// Another renderer's paths, asked by heckbert: a renderer that prints a path stream (docs/path-stream.md). It is the
// smallest with an answer to check: closed rooms whose walls emit 1, reflect half the light diffusely and a fifth like
// mirrors, so that a word with d D's and s S's is worth 0.5^d 0.2^s. Nothing of heckbert is included or linked.
//
//   feed_own_paths | heckbert record import - -o rooms.paths.exr
//   heckbert classify rooms.paths.exr

#include <cstdio>
#include <map>
#include <random>
#include <string>

namespace {

constexpr int kWidth = 8, kHeight = 8, kSamples = 1000, kDepth = 12;

struct Sum {
  double light = 0;
  unsigned long paths = 0;
};

/// All paths of one pixel, added up by word. Walls are met from the eye on, so that a word grows at its front.
std::map<std::string, Sum> trace_pixel(std::mt19937& random) {
  std::map<std::string, Sum> sums;
  for (int sample = 0; sample < kSamples; ++sample) {
    std::string met = "E";
    for (int depth = 0; depth <= kDepth; ++depth) {
      // This wall emits: a path is finished, and the walk goes on unless the wall absorbs it.
      Sum& sum = sums['L' + met];
      sum.light += 1;
      sum.paths += 1;
      const auto tenths = random() % 10;
      if (tenths >= 7) break;
      met.insert(met.begin(), tenths < 5 ? 'D' : 'S');
    }
  }
  return sums;
}

}  // namespace

int main() {
  std::printf("heckbert-paths 1 text\n");
  std::printf("scene closed rooms\n");
  std::printf("size %d %d\n", kWidth, kHeight);
  std::printf("samples %d\n", kSamples);
  std::printf("depth %d\n", kDepth);
  std::printf("light La\neye Ep\n");
  std::printf("paths\n");
  std::mt19937 random(1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (const auto& [word, sum] : trace_pixel(random))
        std::printf("%d %d %s %.9g %.9g %.9g %lu\n", x, y, word.c_str(), sum.light, sum.light, sum.light, sum.paths);
  std::printf("end\n");
}
