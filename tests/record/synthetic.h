#pragma once
// Made-up light: what arrives at a pixel is a function of (seed, pixel, sample), so that two ways of recording it can
// be compared. Words follow a long tail and some places see fewer of them than others; some contributions are black,
// some samples find nothing.

#include <cstdint>
#include <random>
#include <vector>

#include <heckbert/record/recorder.h>

namespace heckbert::record {

struct Found {
  taxonomy::Word word;
  Rgb value;
  Technique technique = Technique::Hit;
};

inline taxonomy::WordTrie::Node node_of(taxonomy::WordTrie& trie, const taxonomy::Word& word) {
  auto node = trie.eye(word.eye);
  for (auto event = word.events.rbegin(); event != word.events.rend(); ++event) node = trie.step(node, *event);
  return trie.step(node, word.light);
}

class MadeUpLight {
 public:
  explicit MadeUpLight(std::uint64_t seed, std::size_t vocabulary = 60) : seed_(seed) {
    using taxonomy::Symbol;
    constexpr std::array kEvents{Symbol::Dr, Symbol::Dt, Symbol::Gr, Symbol::Gt, Symbol::Sr, Symbol::St, Symbol::V};
    constexpr std::array kLights{Symbol::La, Symbol::Lp, Symbol::Ld, Symbol::Le};
    std::mt19937_64 random(seed);
    for (std::size_t w = 0; w < vocabulary; ++w) {
      taxonomy::Word word{kLights[random() % kLights.size()], {}, random() % 4 == 0 ? Symbol::El : Symbol::Ep};
      for (std::size_t i = 0; i < w % 9; ++i) word.events.push_back(kEvents[random() % kEvents.size()]);
      vocabulary_.push_back(word);  // may repeat an earlier one
    }
  }

  std::vector<Found> sample(int x, int y, int sample) const {
    std::seed_seq key{static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                      static_cast<std::uint32_t>(sample)};
    std::mt19937 random(key);
    const auto uniform = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    const auto in_reach = vocabulary_.size() * static_cast<std::size_t>(1 + (x / 8 + y / 8) % 3) / 3;
    std::vector<Found> found(random() % 8);
    for (Found& f : found) {
      const float u = uniform();
      f.word = vocabulary_[static_cast<std::size_t>(u * u * u * static_cast<float>(in_reach))];
      if (random() % 10 != 0) f.value = {uniform(), 3 * uniform(), 0.01f * uniform()};
      f.technique = random() % 2 == 0 ? Technique::Hit : Technique::NextEvent;
    }
    return found;
  }

  void send_sample(PathSink& sink, int x, int y, int sample_number) const {
    sink.begin_sample(x, y, sample_number);
    for (const Found& f : sample(x, y, sample_number)) sink.add({node_of(sink.words(), f.word), f.value, f.technique});
    sink.end_path(PathEnd::Absorbed);
  }

  Tile tile(TileRecorder& recorder, const Window& window, int samples_per_pixel) const {
    recorder.begin_tile(window);
    for (int y = window.y0; y < window.y1; ++y)
      for (int x = window.x0; x < window.x1; ++x)
        for (int s = 0; s < samples_per_pixel; ++s) send_sample(recorder, x, y, s);
    return recorder.end_tile();
  }

 private:
  std::uint64_t seed_;
  std::vector<taxonomy::Word> vocabulary_;
};

inline RenderInfo info_for(const Window& window, int samples_per_pixel) {
  RenderInfo info;
  info.scene = "made-up";
  info.algorithm = "path";
  info.width = window.x1 + 3;
  info.height = window.y1 + 2;
  info.window = window;
  info.samples_per_pixel = samples_per_pixel;
  info.seed = 18446744073709551615u;
  info.max_depth = 12;
  info.version = "0.1";
  info.ignored = {"room.xml:7: shape \"hair\" is not known: left out", "room.xml:9: <medium> is not read"};
  return info;
}

/// The tiles of a window, row by row.
inline std::vector<Window> tiles_of(const Window& window, int size) {
  std::vector<Window> tiles;
  for (int y = window.y0; y < window.y1; y += size)
    for (int x = window.x0; x < window.x1; x += size)
      tiles.push_back({x, y, std::min(x + size, window.x1), std::min(y + size, window.y1)});
  return tiles;
}

inline Record record_of(const MadeUpLight& light, const RenderInfo& info, int tile_size = 8) {
  TileRecorder recorder(info);
  Assembler assembler(info);
  for (const Window& window : tiles_of(info.window, tile_size))
    assembler.submit(light.tile(recorder, window, info.samples_per_pixel));
  return assembler.finish(false);
}

}  // namespace heckbert::record
