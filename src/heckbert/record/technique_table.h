#pragma once
// Which techniques found the paths of each word, and how much each of them brought: the pyramid of Veach's figure 10.3
// by word, in numbers. Every value has its weight applied, so a word's techniques add up to its energy.

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <heckbert/record/path_sink.h>
#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>
#include <heckbert/record/sum.h>

namespace heckbert::record {

/// What one technique found of one word.
struct TechniqueSum {
  taxonomy::Word word;
  Technique technique;
  std::uint64_t count = 0;                  ///< contributions
  std::array<RgbSum, kBatches> by_batch{};  ///< over all pixels and the samples of each batch
  bool operator==(const TechniqueSum&) const = default;
};

/// Sorted by word, then by technique.
using TechniqueTable = std::vector<TechniqueSum>;

/// A sink that asks how paths were found, not where they are seen.
class TechniqueRecorder final : public PathSink {
 public:
  explicit TechniqueRecorder(const RenderInfo& info);
  void begin_sample(int x, int y, int sample) override;
  void add(const Contribution& contribution) override;
  void splat(int x, int y, const Contribution& contribution) override;
  void add_non_path(NonPath, Rgb) override {}
  void end_path(PathEnd) override {}

  TechniqueTable table();

 private:
  struct Found {
    std::uint64_t count = 0;
    std::array<RgbSum, kBatches> by_batch{};
  };
  Window window_;
  int samples_of_the_whole_ = 0;
  std::size_t batch_ = 0;
  std::map<std::pair<taxonomy::WordTrie::Node, Technique>, Found> found_;
};

/// Both, exactly: any order of additions gives the same table.
TechniqueTable added(const TechniqueTable& a, const TechniqueTable& b);

/// Picture-mean luminance that this technique brought, with its interval at `confidence`. Takes a render of one seed,
/// not a part of one.
Estimate energy_of(const TechniqueSum& sum, const RenderInfo& info, double confidence = 0.95);

}  // namespace heckbert::record
