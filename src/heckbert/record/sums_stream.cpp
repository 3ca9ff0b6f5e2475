#include <heckbert/record/sums_stream.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

#include <heckbert/record/paths_part.h>
#include <heckbert/record/word_sums.h>

namespace heckbert::record {

namespace {

std::size_t pixel_of(const Window& window, int y) {
  return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width());
}

/// Adds up what several streams have of a band.
class MergingPass {
 public:
  using Places = std::vector<std::vector<std::uint32_t>>;

  MergingPass(std::vector<SumsPass> passes, std::shared_ptr<const Places> places)
      : passes_(std::move(passes)), places_(std::move(places)), bands_(passes_.size()) {}

  void operator()(SumsBand& sum) {
    for (std::size_t s = 0; s < bands_.size(); ++s) {
      bands_[s].window = sum.window;
      passes_[s](bands_[s]);
    }
    sum.counts.clear();
    sum.entries.clear();
    std::vector<std::size_t> next(bands_.size());
    for (std::size_t pixel = 0; pixel < sum.window.pixel_count(); ++pixel) {
      const std::size_t first = sum.entries.size();
      for (std::size_t s = 0; s < bands_.size(); ++s)
        for (std::uint32_t e = 0; e < bands_[s].counts[pixel]; ++e) {
          sum.entries.push_back(bands_[s].entries[next[s]++]);
          sum.entries.back().word = (*places_)[s][sum.entries.back().word];
        }
      add_up_equals(sum.entries, first);
      sum.counts.push_back(static_cast<std::uint32_t>(sum.entries.size() - first));
    }
  }

 private:
  std::vector<SumsPass> passes_;
  std::shared_ptr<const Places> places_;  ///< by stream and its word: the place among all words
  std::vector<SumsBand> bands_;
};

SumsStream added(RenderInfo info, std::vector<SumsStream> streams) {
  SumsStream sum{.info = std::move(info), .totals = {}, .begin = {}};
  std::vector<Tile> totals;
  std::vector<std::function<SumsPass()>> begins;
  for (SumsStream& stream : streams) {
    assert(!stream.folding);
    totals.push_back(std::move(stream.totals));
    begins.push_back(std::move(stream.begin));
  }
  auto places = std::make_shared<MergingPass::Places>();
  sum.totals = added_totals(sum.info.window, totals, *places);
  sum.info.partial = is_partial(sum.info, sum.totals);
  sum.begin = [begins = std::move(begins), places = std::shared_ptr<const MergingPass::Places>(std::move(places))] {
    std::vector<SumsPass> passes;
    for (const auto& begin : begins) passes.push_back(begin());
    return MergingPass(std::move(passes), places);
  };
  return sum;
}

}  // namespace

std::vector<Rgb> means_of(const std::vector<RgbSum>& sums, const std::vector<std::uint32_t>& samples) {
  std::vector<Rgb> means(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) means[i] = mean_of(sums[i], samples[i]);
  return means;
}

SumsStream stream_of(const Sums& sums) {
  const Tile& tile = sums.tile;
  Tile totals{.window = tile.window,
              .words = tile.words,
              .samples = tile.samples,
              .offsets = {},
              .entries = {},
              .batch_sums = tile.batch_sums,
              .ambient = tile.ambient,
              .phantom = tile.phantom,
              .tally = tile.tally};
  const auto pass = [&tile](SumsBand& band) {
    const std::size_t first = pixel_of(tile.window, band.window.y0), last = pixel_of(tile.window, band.window.y1);
    const auto entry = [&](std::size_t pixel) {
      return tile.entries.begin() + static_cast<std::ptrdiff_t>(tile.offsets[pixel]);
    };
    band.counts.clear();
    for (std::size_t pixel = first; pixel < last; ++pixel)
      band.counts.push_back(static_cast<std::uint32_t>(tile.offsets[pixel + 1] - tile.offsets[pixel]));
    band.entries.assign(entry(first), entry(last));
  };
  return {sums.info, std::move(totals), [pass] { return pass; }};
}

SumsStream merged(std::vector<SumsStream> streams) {
  assert(!streams.empty());
  RenderInfo info = streams.front().info;
  for (std::size_t s = 1; s < streams.size(); ++s) info = info_of_both(info, streams[s].info);
  return added(std::move(info), std::move(streams));
}

SumsStream completed(SumsStream begun, SumsStream rest) {
  RenderInfo info = rest.info;
  std::vector<SumsStream> both;
  both.push_back(std::move(begun));
  both.push_back(std::move(rest));
  return added(std::move(info), std::move(both));
}

Sums collected(const SumsStream& stream) {
  Sums sums{stream.info, stream.totals};
  Tile& tile = sums.tile;
  SumsBand band{.window = tile.window, .counts = {}, .entries = {}};
  stream.begin()(band);
  tile.offsets.reserve(band.counts.size() + 1);
  tile.offsets.push_back(0);
  for (const std::uint32_t count : band.counts) tile.offsets.push_back(tile.offsets.back() + count);
  tile.entries = std::move(band.entries);
  return sums;
}

Record totals_of(const SumsStream& stream, Precision precision) {
  Record record = means_of_words(stream.info, stream.totals);
  record.info.precision = precision;
  record.ambient = means_of(stream.totals.ambient, stream.totals.samples);
  record.phantom = means_of(stream.totals.phantom, stream.totals.samples);
  record.folding = stream.folding;
  if (precision == Precision::Half)
    rows_of(stream)([&](const PixelRow& row) {
      for (const Entry& entry : row.entries) exr::count_rounding(record.tally, entry.energy);
    });
  return record;
}

Rows rows_of(const SumsStream& stream) {
  return [&stream](const RowVisitor& visit) {
    const SumsPass pass = stream.begin();
    const Window& window = stream.info.window;
    SumsBand band;
    std::vector<Entry> entries;
    for (int y = window.y0; y < window.y1; ++y) {
      band.window = {window.x0, y, window.x1, y + 1};
      pass(band);
      const std::size_t first_pixel = pixel_of(window, y);
      std::vector<std::size_t> offsets{0};
      entries.clear();
      const EntrySum* next = band.entries.data();
      for (std::size_t i = 0; i < band.counts.size(); ++i) {
        const std::uint32_t samples = stream.totals.samples[first_pixel + i];
        for (std::uint32_t e = 0; e < band.counts[i]; ++e, ++next)
          entries.push_back({next->word, mean_of(next->sum, samples), next->count});
        offsets.push_back(entries.size());
      }
      visit({.y = y, .first_pixel = first_pixel, .offsets = offsets, .entries = entries});
    }
  };
}

}  // namespace heckbert::record
