#include <heckbert/record/splats.h>

#include <algorithm>
#include <utility>

#include <heckbert/record/sums.h>

namespace heckbert::record {

using taxonomy::WordTrie;

void Splats::add(std::size_t pixel, WordTrie::Node word, std::size_t batch, const RgbSum& sum) {
  Sum& here = sums_[static_cast<std::uint64_t>(pixel) << 32 | word];
  here.sum += sum;
  here.count = added_counts(here.count, 1);
  BatchSums& batches = batches_[word];
  batches.sums[batch] += sum;
  ++batches.counts[batch];
}

Tile Splats::tile(const Window& window, const WordTrie& words) {
  Tile tile;
  tile.window = window;
  tile.samples.resize(window.pixel_count());

  std::vector<std::pair<taxonomy::Word, WordTrie::Node>> found;
  found.reserve(batches_.size());
  for (const auto& [node, sums] : batches_) found.emplace_back(words.word(node), node);
  std::sort(found.begin(), found.end());
  std::unordered_map<WordTrie::Node, std::uint32_t> ranks;
  for (auto& [word, node] : found) {
    const auto rank = static_cast<std::uint32_t>(tile.words.size());
    ranks[node] = rank;
    const BatchSums& batches = batches_.at(node);
    for (std::uint32_t b = 0; b < kBatches; ++b)
      if (batches.counts[b] > 0) tile.batch_sums.push_back({rank, b, batches.counts[b], batches.sums[b]});
    tile.words.push_back(std::move(word));
  }

  std::vector<std::pair<std::uint64_t, const Sum*>> order;  // by pixel, then by rank of the word
  order.reserve(sums_.size());
  for (const auto& [key, sum] : sums_) {
    const auto node = static_cast<WordTrie::Node>(key & 0xffff'ffffu);
    order.emplace_back((key >> 32) << 32 | ranks.at(node), &sum);
  }
  std::sort(order.begin(), order.end());
  tile.offsets.reserve(window.pixel_count() + 1);
  tile.entries.reserve(order.size());
  for (const auto& [key, sum] : order) {
    tile.offsets.resize((key >> 32) + 1, tile.entries.size());
    tile.entries.push_back({static_cast<std::uint32_t>(key & 0xffff'ffffu), sum->count, sum->sum});
  }
  tile.offsets.resize(window.pixel_count() + 1, tile.entries.size());
  sums_.clear();
  batches_.clear();
  return tile;
}

}  // namespace heckbert::record
