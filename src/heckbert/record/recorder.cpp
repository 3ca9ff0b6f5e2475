#include <heckbert/record/recorder.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace heckbert::record {

namespace {

/// `order` with order[i] = the old place of what comes i-th when sorted.
std::vector<std::uint32_t> sorting_order(const std::vector<taxonomy::Word>& words) {
  std::vector<std::uint32_t> order(words.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return words[a] < words[b]; });
  return order;
}

std::uint64_t& count_of(Tally& tally, Technique technique) {
  if (technique.merged) return tally.merges;
  if (technique == Technique::Hit) return tally.hits;
  return technique == Technique::NextEvent ? tally.next_events : tally.connections;
}

}  // namespace

TileRecorder::TileRecorder(const RenderInfo& info, const SampleMap* sample_map)
    : window_(info.window),
      samples_of_the_whole_(samples_of(info).front().of),
      sample_map_(sample_map),
      mean_repeats_(sample_map == nullptr ? 1.0f : static_cast<float>(sample_map->mean())) {}

void TileRecorder::begin_tile(const Window& window) {
  assert(tile_nodes_.empty() && pixel_samples_ == 0 && "the tile before has ended");
  tile_ = Tile{};
  tile_.window = window;
  tile_.samples.resize(window.pixel_count());
  pixels_.assign(window.pixel_count(), {});
}

void TileRecorder::begin_sample(int x, int y, int sample) {
  if (pixel_samples_ == 0 || x != x_ || y != y_) {
    finish_pixel();
    const Window& window = tile_.window;
    assert(x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1);
    x_ = x;
    y_ = y;
    pixel_ = static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
             static_cast<std::size_t>(x - window.x0);
    if (sample_map_ != nullptr) batch_weight_ = 1.0f / static_cast<float>(sample_map_->at(x, y));
    assert(pixels_[pixel_].last == 0 && "all samples of a pixel arrive together");
  }
  ++pixel_samples_;
  ++tile_.tally.samples;
  batch_ = static_cast<std::size_t>(batch_of(sample, samples_of_the_whole_));
}

void TileRecorder::add(const Contribution& contribution) {
  Rgb value = contribution.value;
  if (!accept(value)) return;
  const RgbSum sum = sum_of(value);
  if (contribution.word >= slots_.size()) slots_.resize(words().size());
  Slot& slot = slots_[contribution.word];
  if (slot.count == 0) enlist(contribution.word, slot);
  ++slot.count;
  slot.sum += sum;
  Found& found = batches_[slot.tile_word][batch_];
  ++found.count;
  found.sum += batch_weight_ == 1.0f ? sum : RgbSum(value * batch_weight_);
  ++count_of(tile_.tally, contribution.technique);
}

void TileRecorder::add(std::span<const Contribution> contributions) {
  for (const Contribution& contribution : contributions) add(contribution);
}

void TileRecorder::splat(int x, int y, const Contribution& contribution) {
  assert(sample_map_ == nullptr);
  if (x < window_.x0 || x >= window_.x1 || y < window_.y0 || y >= window_.y1) return;
  Rgb value = contribution.value;
  if (is_black(value) || !accept(value)) return;
  const auto pixel = static_cast<std::size_t>(y - window_.y0) * static_cast<std::size_t>(window_.width()) +
                     static_cast<std::size_t>(x - window_.x0);
  sum_of(value);
  splats_.add(pixel, contribution.word, batch_, value);
  ++count_of(tile_.tally, contribution.technique);
}

void TileRecorder::sort_splats() {
  splats_.sort(words());
}

Tile TileRecorder::end_splats() {
  return splats_.tile(window_);
}

void TileRecorder::add_non_path(NonPath buffer, Rgb value) {
  if (!accept(value)) return;
  std::vector<RgbSum>& pixels = buffer == NonPath::Ambient ? tile_.ambient : tile_.phantom;
  if (pixels.empty()) pixels.resize(pixels_.size());
  pixels[pixel_] += sum_of(value);
}

void TileRecorder::end_path(PathEnd end) {
  Tally& tally = tile_.tally;
  switch (end) {
    case PathEnd::EscapedUnlit:
      ++tally.escaped_unlit;
      [[fallthrough]];
    case PathEnd::Escaped:
      ++tally.escaped;
      break;
    case PathEnd::Absorbed:
      ++tally.absorbed;
      break;
    case PathEnd::DepthLimit:
      ++tally.depth_limited;
      break;
    case PathEnd::Roulette:
      ++tally.roulette;
      break;
  }
}

void TileRecorder::add_cut_off(Rgb value) {
  if (!accept(value)) return;
  // A mean over the picture, however often its pixels are repeated.
  const float light = mean_repeats_ * batch_weight_ * luminance(value);
  tile_.tally.cut_off += quanta_of(std::min(light, kMostLight));
  tile_.tally.cut_off_squares += quanta_of(std::min(light * light, kMostLight));
}

Tile TileRecorder::end_tile() {
  finish_pixel();

  std::vector<taxonomy::Word> words;
  words.reserve(tile_nodes_.size());
  for (const auto node : tile_nodes_) words.push_back(this->words().word(node));
  const std::vector<std::uint32_t> order = sorting_order(words);
  std::vector<std::uint32_t> rank(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;

  tile_.words.reserve(words.size());
  for (std::uint32_t w = 0; w < order.size(); ++w) {
    tile_.words.push_back(std::move(words[order[w]]));
    for (std::uint32_t b = 0; b < kBatches; ++b)
      if (const Found& found = batches_[order[w]][b]; found.count > 0)
        tile_.batch_sums.push_back({w, b, found.count, found.sum});
  }

  // Counting sort, first by word and then, keeping that order, by pixel.
  std::vector<std::size_t> places(order.size() + 1);
  for (EntrySum& entry : entries_) {
    entry.word = rank[entry.word];
    ++places[entry.word + 1];
  }
  std::partial_sum(places.begin(), places.end(), places.begin());
  struct Place {
    std::uint32_t entry, pixel;
  };
  std::vector<Place> by_word(entries_.size());
  tile_.offsets.reserve(pixels_.size() + 1);
  tile_.offsets.push_back(0);
  for (std::uint32_t pixel = 0; pixel < pixels_.size(); ++pixel) {
    const Range& range = pixels_[pixel];
    for (std::uint32_t e = range.first; e < range.last; ++e) by_word[places[entries_[e].word]++] = {e, pixel};
    tile_.offsets.push_back(tile_.offsets.back() + (range.last - range.first));
  }
  tile_.entries.resize(entries_.size());
  std::vector<std::size_t> next(tile_.offsets.begin(), tile_.offsets.end() - 1);
  for (const Place& place : by_word) tile_.entries[next[place.pixel]++] = entries_[place.entry];

  for (const auto node : tile_nodes_) slots_[node].tile_word = kNoWord;
  tile_nodes_.clear();
  batches_.clear();
  entries_.clear();
  return std::exchange(tile_, Tile{});
}

bool TileRecorder::accept(Rgb value) {
  if (is_recordable(value)) return true;
  ++(is_finite(value) ? tile_.tally.rejected_negative : tile_.tally.rejected_not_finite);
  return false;
}

RgbSum TileRecorder::sum_of(Rgb& value) {
  if (max_channel(value) > kMostLight) [[unlikely]] {
    value = clamped(value);
    ++tile_.tally.clamped;
  }
  const RgbSum sum(value);
  if (vanishes(value, sum)) [[unlikely]]
    ++tile_.tally.vanished;
  return sum;
}

void TileRecorder::enlist(taxonomy::WordTrie::Node node, Slot& slot) {
  pixel_nodes_.push_back(node);
  if (slot.tile_word != kNoWord) return;
  slot.tile_word = static_cast<std::uint32_t>(tile_nodes_.size());
  tile_nodes_.push_back(node);
  batches_.emplace_back();
}

void TileRecorder::finish_pixel() {
  if (pixel_samples_ == 0) return;
  tile_.samples[pixel_] = static_cast<std::uint32_t>(pixel_samples_);
  pixels_[pixel_].first = static_cast<std::uint32_t>(entries_.size());
  for (const auto node : pixel_nodes_) {
    Slot& slot = slots_[node];
    entries_.push_back({slot.tile_word, slot.count, slot.sum});
    slot.sum = {};
    slot.count = 0;
  }
  pixels_[pixel_].last = static_cast<std::uint32_t>(entries_.size());
  pixel_nodes_.clear();
  pixel_samples_ = 0;
}

}  // namespace heckbert::record
