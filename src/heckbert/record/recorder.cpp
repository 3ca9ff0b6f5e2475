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

}  // namespace

TileRecorder::TileRecorder(const RenderInfo& info, const SampleMap* sample_map)
    : samples_per_pixel_(info.samples_per_pixel),
      sample_map_(sample_map),
      mean_repeats_(sample_map == nullptr ? 1.0 : sample_map->mean()) {}

void TileRecorder::begin_tile(const Window& window) {
  assert(tile_nodes_.empty() && pixel_samples_ == 0 && "the tile before has ended");
  tile_ = Tile{};
  tile_.window = window;
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
    if (sample_map_ != nullptr) batch_weight_ = 1.0 / sample_map_->at(x, y);
    assert(pixels_[pixel_].last == 0 && "all samples of a pixel arrive together");
  }
  ++pixel_samples_;
  ++tile_.tally.samples;
  batch_ = 3 * static_cast<std::size_t>(batch_of(sample, samples_per_pixel_));
}

void TileRecorder::add(const Contribution& contribution) {
  const Rgb value = contribution.value;
  if (!accept(value)) return;
  if (contribution.word >= slots_.size()) slots_.resize(words().size());
  Slot& slot = slots_[contribution.word];
  if (slot.count == 0) enlist(contribution.word, slot);
  const double r = static_cast<double>(value.r), g = static_cast<double>(value.g), b = static_cast<double>(value.b);
  ++slot.count;
  slot.r += r;
  slot.g += g;
  slot.b += b;
  double* sums = &batch_sums_[slot.tile_word][batch_];
  sums[0] += batch_weight_ * r;
  sums[1] += batch_weight_ * g;
  sums[2] += batch_weight_ * b;
  ++(contribution.technique == Technique::Hit ? tile_.tally.hits : tile_.tally.next_events);
}

void TileRecorder::add(std::span<const Contribution> contributions) {
  for (const Contribution& contribution : contributions) add(contribution);
}

void TileRecorder::add_non_path(NonPath buffer, Rgb value) {
  if (!accept(value)) return;
  std::vector<Rgb>& pixels = buffer == NonPath::Ambient ? tile_.ambient : tile_.phantom;
  if (pixels.empty()) pixels.resize(pixels_.size());
  pixels[pixel_] += value;
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
  const double light = mean_repeats_ * batch_weight_ * static_cast<double>(luminance(value));
  tile_.tally.cut_off += light;
  tile_.tally.cut_off_squares += light * light;
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
  tile_.batch_sums.reserve(words.size());
  for (const std::uint32_t old : order) {
    tile_.words.push_back(std::move(words[old]));
    tile_.batch_sums.push_back(batch_sums_[old]);
  }

  // Counting sort, first by word and then, keeping that order, by pixel.
  std::vector<std::size_t> places(order.size() + 1);
  for (Entry& entry : entries_) {
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
  batch_sums_.clear();
  entries_.clear();
  return std::exchange(tile_, Tile{});
}

bool TileRecorder::accept(Rgb value) {
  if (is_recordable(value)) return true;
  ++(is_finite(value) ? tile_.tally.rejected_negative : tile_.tally.rejected_not_finite);
  return false;
}

void TileRecorder::enlist(taxonomy::WordTrie::Node node, Slot& slot) {
  pixel_nodes_.push_back(node);
  if (slot.tile_word != kNoWord) return;
  slot.tile_word = static_cast<std::uint32_t>(tile_nodes_.size());
  tile_nodes_.push_back(node);
  batch_sums_.emplace_back();
}

void TileRecorder::finish_pixel() {
  if (pixel_samples_ == 0) return;
  const double samples = pixel_samples_;
  pixels_[pixel_].first = static_cast<std::uint32_t>(entries_.size());
  for (const auto node : pixel_nodes_) {
    Slot& slot = slots_[node];
    const Rgb mean{static_cast<float>(slot.r / samples), static_cast<float>(slot.g / samples),
                   static_cast<float>(slot.b / samples)};
    entries_.push_back({slot.tile_word, mean, slot.count});
    slot.r = slot.g = slot.b = 0;
    slot.count = 0;
  }
  pixels_[pixel_].last = static_cast<std::uint32_t>(entries_.size());
  for (std::vector<Rgb>* buffer : {&tile_.ambient, &tile_.phantom})
    if (!buffer->empty()) (*buffer)[pixel_] = (*buffer)[pixel_] / static_cast<float>(pixel_samples_);
  pixel_nodes_.clear();
  pixel_samples_ = 0;
}

}  // namespace heckbert::record
