#include <heckbert/record/recorder.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace heckbert::record {

namespace {

void add_to(BatchSums& sums, const BatchSums& more) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += more[i];
}

/// `order` with order[i] = the old place of what comes i-th when sorted.
std::vector<std::uint32_t> sorting_order(const std::vector<taxonomy::Word>& words) {
  std::vector<std::uint32_t> order(words.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return words[a] < words[b]; });
  return order;
}

void require(bool holds, const char* claim) {
  if (!holds) throw std::logic_error(claim);
}

}  // namespace

TileRecorder::TileRecorder(const RenderInfo& info) : samples_per_pixel_(info.samples_per_pixel) {}

void TileRecorder::begin_tile(const Window& window) {
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
  sums[0] += r;
  sums[1] += g;
  sums[2] += b;
  ++(contribution.technique == Technique::Hit ? tile_.tally.hits : tile_.tally.next_events);
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

Assembler::Assembler(RenderInfo info) : info_(std::move(info)) {}

void Assembler::submit(std::size_t number, Tile tile) {
  const Window &inner = tile.window, &outer = info_.window;
  require(inner.x0 >= outer.x0 && inner.x1 <= outer.x1 && inner.y0 >= outer.y0 && inner.y1 <= outer.y1 &&
              inner.x0 < inner.x1 && inner.y0 < inner.y1,
          "a tile lies inside the picture's window");
  require(tile.offsets.size() == inner.pixel_count() + 1 && tile.offsets.back() == tile.entries.size() &&
              tile.batch_sums.size() == tile.words.size(),
          "a tile's lists fit its window and words");
  require(std::is_sorted(tile.words.begin(), tile.words.end()), "a tile's words are sorted");

  const std::lock_guard lock(mutex_);
  require(number >= next_ && !waiting_.contains(number), "a tile is submitted once");
  waiting_.emplace(number, std::move(tile));
  for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_; first = waiting_.begin()) {
    merge(std::move(first->second));
    waiting_.erase(first);
    ++next_;
  }
}

void Assembler::merge(Tile tile) {
  std::vector<std::uint32_t> id(tile.words.size());
  for (std::size_t w = 0; w < id.size(); ++w) {
    const auto [place, is_new] = ids_.try_emplace(std::move(tile.words[w]), static_cast<std::uint32_t>(ids_.size()));
    id[w] = place->second;
    if (is_new)
      batch_sums_.push_back(tile.batch_sums[w]);
    else
      add_to(batch_sums_[id[w]], tile.batch_sums[w]);
  }
  for (Entry& entry : tile.entries) entry.word = id[entry.word];
  tile.words = {};
  tile.batch_sums = {};
  merged_.push_back(std::move(tile));
}

Record Assembler::finish(bool partial) {
  for (auto& [number, tile] : waiting_) merge(std::move(tile));
  waiting_.clear();

  Record record;
  record.info = info_;
  record.info.partial = partial;
  const Window& window = info_.window;

  std::vector<std::uint32_t> rank(ids_.size());
  for (const auto& [word, id] : ids_) {
    rank[id] = static_cast<std::uint32_t>(record.words.size());
    record.words.push_back(word);
  }

  const auto sizes = batch_sizes(info_.samples_per_pixel);
  record.batch_means.resize(record.words.size() * kBatches);
  for (std::size_t id = 0; id < batch_sums_.size(); ++id) {
    for (std::size_t batch = 0; batch < kBatches; ++batch) {
      if (sizes[batch] == 0) continue;
      const double samples = sizes[batch] * static_cast<double>(window.pixel_count());
      const double* sums = &batch_sums_[id][3 * batch];
      record.batch_means[rank[id] * kBatches + batch] = {static_cast<float>(sums[0] / samples),
                                                         static_cast<float>(sums[1] / samples),
                                                         static_cast<float>(sums[2] / samples)};
    }
  }

  // Row by row across the tiles; a tile's entries are freed with its last row, so that the peak is one copy of all
  // entries and a band of tiles.
  std::sort(merged_.begin(), merged_.end(), [](const Tile& a, const Tile& b) { return a.window.x0 < b.window.x0; });
  std::vector<std::vector<Tile*>> rows(static_cast<std::size_t>(window.height()));
  std::size_t entry_count = 0;
  for (Tile& tile : merged_) {
    record.tally += tile.tally;
    entry_count += tile.entries.size();
    for (int y = tile.window.y0; y < tile.window.y1; ++y)
      rows[static_cast<std::size_t>(y - window.y0)].push_back(&tile);
    if (!tile.ambient.empty()) record.ambient.resize(window.pixel_count());
    if (!tile.phantom.empty()) record.phantom.resize(window.pixel_count());
  }
  record.entries.reserve(entry_count);
  record.offsets.reserve(window.pixel_count() + 1);
  record.offsets.push_back(0);
  for (int y = window.y0; y < window.y1; ++y) {
    const auto row = static_cast<std::size_t>(y - window.y0);
    const auto pad_to = [&](int x) {
      const std::size_t pixels =
          row * static_cast<std::size_t>(window.width()) + static_cast<std::size_t>(x - window.x0);
      require(record.offsets.size() <= pixels + 1, "tiles do not overlap");
      record.offsets.resize(pixels + 1, record.entries.size());
    };
    for (Tile* tile : rows[row]) {
      pad_to(tile->window.x0);
      const std::size_t width = static_cast<std::size_t>(tile->window.width());
      const std::size_t first = static_cast<std::size_t>(y - tile->window.y0) * width;
      const std::size_t pixel = record.offsets.size() - 1;
      const auto copy_row = [&](const std::vector<Rgb>& from, std::vector<Rgb>& to) {
        if (!from.empty()) std::copy_n(&from[first], width, &to[pixel]);
      };
      copy_row(tile->ambient, record.ambient);
      copy_row(tile->phantom, record.phantom);
      for (std::size_t i = first; i < first + width; ++i) {
        for (std::size_t e = tile->offsets[i]; e < tile->offsets[i + 1]; ++e) {
          record.entries.push_back(tile->entries[e]);
          record.entries.back().word = rank[tile->entries[e].word];
        }
        record.offsets.push_back(record.entries.size());
      }
      if (y == tile->window.y1 - 1) tile->entries = {};
    }
    pad_to(window.x1);
  }
  return record;
}

}  // namespace heckbert::record
