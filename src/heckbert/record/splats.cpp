#include <heckbert/record/splats.h>

#include <algorithm>
#include <utility>

#include <heckbert/record/sums.h>

namespace heckbert::record {

using taxonomy::WordTrie;

std::size_t Splats::bytes() const {
  constexpr std::size_t kTableOverhead = 4 * sizeof(void*);
  return splats_.size() * sizeof(Splat) + batches_.size() * (sizeof(decltype(batches_)::value_type) + kTableOverhead);
}

void Splats::add(std::size_t pixel, WordTrie::Node word, std::size_t batch, Rgb light) {
  splats_.push_back({static_cast<std::uint32_t>(pixel), word, light});
  Found& found = batches_[std::uint64_t{word} * kBatches + batch];
  found.sum += RgbSum(light);
  ++found.count;
}

void Splats::sort(const WordTrie& words) {
  std::vector<std::pair<taxonomy::Word, WordTrie::Node>> found;
  for (const auto& [key, sums] : batches_) {
    const auto node = static_cast<WordTrie::Node>(key / kBatches);
    if (places_.try_emplace(node).second) found.emplace_back(words.word(node), node);
  }
  std::sort(found.begin(), found.end());
  for (auto& [word, node] : found) {
    places_[node] = static_cast<std::uint32_t>(words_.size());
    words_.push_back(std::move(word));
  }
  for (Splat& splat : splats_) splat.word = places_[splat.word];
  std::sort(splats_.begin(), splats_.end(),
            [](const Splat& a, const Splat& b) { return std::pair(a.pixel, a.word) < std::pair(b.pixel, b.word); });
}

Tile Splats::tile(const Window& window) {
  Tile tile;
  tile.window = window;
  tile.samples.resize(window.pixel_count());
  tile.offsets.reserve(window.pixel_count() + 1);
  for (const Splat& splat : splats_) {
    const bool is_new_pixel = tile.offsets.size() <= splat.pixel;
    if (is_new_pixel) tile.offsets.resize(splat.pixel + 1, tile.entries.size());
    if (is_new_pixel || tile.entries.back().word != splat.word)
      tile.entries.push_back({.word = splat.word, .count = 0, .sum = {}});
    EntrySum& entry = tile.entries.back();
    entry.count = added_counts(entry.count, 1);
    entry.sum += RgbSum(splat.light);
  }
  tile.offsets.resize(window.pixel_count() + 1, tile.entries.size());

  for (const auto& [key, found] : batches_)
    tile.batch_sums.push_back({places_[static_cast<WordTrie::Node>(key / kBatches)],
                               static_cast<std::uint32_t>(key % kBatches), found.count, found.sum});
  std::ranges::sort(tile.batch_sums, {}, [](const BatchSum& batch) { return std::pair(batch.word, batch.batch); });
  tile.words = std::exchange(words_, {});
  splats_.clear();
  batches_.clear();
  places_.clear();
  return tile;
}

}  // namespace heckbert::record
