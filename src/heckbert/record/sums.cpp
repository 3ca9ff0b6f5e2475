#include <heckbert/record/sums.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace heckbert::record {

namespace {

std::string to_text(const Window& window) {
  return fmt::format("{},{},{},{}", window.x0, window.y0, window.x1, window.y1);
}

/// The pixels of a row that a tile covers, as indices into the tile and into the window.
struct Row {
  std::size_t from, to, width;
};
Row row_of(const Window& tile, const Window& window, int y) {
  const auto width = [](const Window& w) { return static_cast<std::size_t>(w.width()); };
  return {static_cast<std::size_t>(y - tile.y0) * width(tile),
          static_cast<std::size_t>(y - window.y0) * width(window) + static_cast<std::size_t>(tile.x0 - window.x0),
          width(tile)};
}

/// All words of the tiles, sorted; and for each tile, the places of its own words among them.
std::vector<taxonomy::Word> united_words(const std::vector<Tile>& tiles,
                                         std::vector<std::vector<std::uint32_t>>& places) {
  std::vector<taxonomy::Word> words;
  for (const Tile& tile : tiles) {
    std::vector<taxonomy::Word> both;
    std::ranges::set_union(words, tile.words, std::back_inserter(both));
    words = std::move(both);
  }
  for (const Tile& tile : tiles) {
    std::vector<std::uint32_t>& place = places.emplace_back();
    auto at = words.begin();
    for (const taxonomy::Word& word : tile.words) {
      at = std::lower_bound(at, words.end(), word);
      place.push_back(static_cast<std::uint32_t>(at - words.begin()));
    }
  }
  return words;
}

void add_up_batches(Tile& sum, const std::vector<Tile>& tiles, const std::vector<std::vector<std::uint32_t>>& places) {
  std::vector<BatchSum>& all = sum.batch_sums;
  for (std::size_t t = 0; t < tiles.size(); ++t)
    for (const BatchSum& found : tiles[t].batch_sums)
      all.push_back({places[t][found.word], found.batch, found.count, found.sum});
  const auto place = [](const BatchSum& batch) { return std::pair(batch.word, batch.batch); };
  std::ranges::sort(all, {}, place);
  std::size_t last = 0;
  for (std::size_t b = 1; b < all.size(); ++b) {
    if (place(all[b]) != place(all[last])) {
      all[++last] = all[b];
      continue;
    }
    all[last].count += all[b].count;
    all[last].sum += all[b].sum;
  }
  if (!all.empty()) all.resize(last + 1);
}

void add_to_row(std::vector<RgbSum>& sum, const std::vector<RgbSum>& pixels, const Row& row, std::size_t pixel_count) {
  if (pixels.empty()) return;
  sum.resize(pixel_count);
  for (std::size_t i = 0; i < row.width; ++i) sum[row.to + i] += pixels[row.from + i];
}

/// What tells scenes apart: the contents where they are known, whatever the file is called.
std::string identity_of(const RenderInfo& info) {
  return info.scene_hash.empty() ? "the scene called " + info.scene : info.scene_hash;
}
std::string scene_text(const RenderInfo& info) {
  return info.scene_hash.empty() ? info.scene : fmt::format("{}, contents {}", info.scene, info.scene_hash);
}

std::string source_text(const RenderInfo& info) {
  return info.has_batches ? "a render of this tool" : "an import without batches";
}

/// The same list, unless they differ: then what either has, in an order that both agree upon.
std::vector<std::string> either(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  if (a == b) return a;
  std::vector<std::string> both = a;
  both.insert(both.end(), b.begin(), b.end());
  std::ranges::sort(both);
  both.erase(std::unique(both.begin(), both.end()), both.end());
  return both;
}

Tile added(Tile a, Tile b) {
  const Window window = a.window;
  std::vector<Tile> both;
  both.push_back(std::move(a));
  both.push_back(std::move(b));
  return added(window, std::move(both));
}

}  // namespace

std::uint32_t added_counts(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (a > kMost - b) throw std::overflow_error(fmt::format("a pixel has more than {} paths of one word", kMost));
  return a + b;
}

void check_alike(const RenderInfo& a, const RenderInfo& b) {
  const auto check = [](std::string_view what, const auto& first, const auto& second) {
    if (first != second) throw MergeError(fmt::format("the {} differs: '{}' and '{}'", what, first, second));
  };
  if (identity_of(a) != identity_of(b)) check("scene", scene_text(a), scene_text(b));
  check("algorithm", a.algorithm, b.algorithm);
  check("method", a.method, b.method);
  check("size", fmt::format("{}x{}", a.width, a.height), fmt::format("{}x{}", b.width, b.height));
  check("crop", to_text(a.window), to_text(b.window));
  check("depth", a.max_depth, b.max_depth);
  check("sampler", a.sampler, b.sampler);
  check("filter", a.filter, b.filter);
  check("label rule", a.labels, b.labels);
  check("tool version", a.version, b.version);
  check("source", source_text(a), source_text(b));
}

std::vector<SampleRange> samples_of_both(const RenderInfo& a, const RenderInfo& b) {
  try {
    return united(samples_of(a), samples_of(b));
  } catch (const std::invalid_argument& common) {
    throw MergeError(fmt::format("both have {}", common.what()));
  }
}

void add_up_equals(std::vector<EntrySum>& entries, std::size_t first) {
  const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, entries.end(), [](const EntrySum& a, const EntrySum& b) { return a.word < b.word; });
  std::size_t last = first;
  for (std::size_t e = first + 1; e < entries.size(); ++e) {
    if (entries[e].word != entries[last].word) {
      entries[++last] = entries[e];
      continue;
    }
    entries[last].count = added_counts(entries[last].count, entries[e].count);
    entries[last].sum += entries[e].sum;
  }
  if (first < entries.size()) entries.resize(last + 1);
}

bool is_partial(const RenderInfo& info, const Tile& tile) {
  const auto all = static_cast<std::uint32_t>(info.samples_per_pixel);
  return std::ranges::any_of(tile.samples, [&](std::uint32_t taken) { return taken < all; });
}

Tile added_totals(const Window& window, const std::vector<Tile>& tiles,
                  std::vector<std::vector<std::uint32_t>>& places) {
  Tile sum;
  sum.window = window;
  sum.samples.resize(window.pixel_count());
  sum.words = united_words(tiles, places);
  add_up_batches(sum, tiles, places);
  for (const Tile& tile : tiles) {
    sum.tally += tile.tally;
    for (int y = tile.window.y0; y < tile.window.y1; ++y) {
      const Row row = row_of(tile.window, window, y);
      for (std::size_t i = 0; i < row.width; ++i) sum.samples[row.to + i] += tile.samples[row.from + i];
      add_to_row(sum.ambient, tile.ambient, row, window.pixel_count());
      add_to_row(sum.phantom, tile.phantom, row, window.pixel_count());
    }
  }
  return sum;
}

Tile added(const Window& window, std::vector<Tile> tiles) {
  std::vector<std::vector<std::uint32_t>> places;
  Tile sum = added_totals(window, tiles, places);

  std::vector<std::vector<std::size_t>> tiles_of_row(static_cast<std::size_t>(window.height()));
  std::size_t entry_count = 0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    entry_count += tiles[t].entries.size();
    for (int y = tiles[t].window.y0; y < tiles[t].window.y1; ++y)
      tiles_of_row[static_cast<std::size_t>(y - window.y0)].push_back(t);
  }
  sum.entries.reserve(entry_count);
  sum.offsets.reserve(window.pixel_count() + 1);
  for (int y = window.y0; y < window.y1; ++y) {
    const std::vector<std::size_t>& here = tiles_of_row[static_cast<std::size_t>(y - window.y0)];
    for (int x = window.x0; x < window.x1; ++x) {
      sum.offsets.push_back(sum.entries.size());
      int sources = 0;
      for (const std::size_t t : here) {
        const Tile& tile = tiles[t];
        if (x < tile.window.x0 || x >= tile.window.x1) continue;
        const std::size_t pixel = row_of(tile.window, window, y).from + static_cast<std::size_t>(x - tile.window.x0);
        for (std::size_t e = tile.offsets[pixel]; e < tile.offsets[pixel + 1]; ++e) {
          sum.entries.push_back(tile.entries[e]);
          sum.entries.back().word = places[t][tile.entries[e].word];
        }
        ++sources;
      }
      if (sources > 1) add_up_equals(sum.entries, sum.offsets.back());
    }
  }
  sum.offsets.push_back(sum.entries.size());
  return sum;
}

RenderInfo info_of_both(const RenderInfo& a, const RenderInfo& b) {
  check_alike(a, b);
  RenderInfo info = a;
  set_samples(info, samples_of_both(a, b));
  info.scene = std::min(a.scene, b.scene);
  if (a.glossy != b.glossy) info.glossy = taxonomy::GlossyRule::Keep;
  info.ignored = either(a.ignored, b.ignored);
  return info;
}

Sums merged(Sums a, Sums b) {
  RenderInfo info = info_of_both(a.info, b.info);
  Sums sums{std::move(info), added(std::move(a.tile), std::move(b.tile))};
  sums.info.partial = is_partial(sums.info, sums.tile);
  return sums;
}

std::string doubt_of(const RenderInfo& a, const RenderInfo& b) {
  for (const SampleRange& first : samples_of(a))
    for (const SampleRange& second : samples_of(b))
      if (first.seed == second.seed && first.of != second.of)
        return fmt::format("{} and {}: with the same seed, some of them may be the same, and count twice",
                           to_text(first), to_text(second));
  return {};
}

Record record_of(Sums sums) {
  const bool partial = sums.info.partial;
  Assembler assembler(std::move(sums.info));
  assembler.submit(std::move(sums.tile));
  return assembler.finish(partial);
}

}  // namespace heckbert::record
