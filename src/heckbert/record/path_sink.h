#pragma once
// Where a tracer puts what it found. This is the whole interface between tracing and recording: another renderer can
// feed a record through it. One sink serves one thread; it owns the trie in which that thread's words grow.
//
// The order of calls is begin_sample, then any number of add, add_non_path and end_path, then the next begin_sample.
// All samples of a pixel arrive together.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include <heckbert/record/rgb.h>
#include <heckbert/taxonomy/word_trie.h>

namespace heckbert::record {

/// How a path was found: by a walk of s vertices from the light and one of t from the eye, the ends included, joined in
/// the middle. A path of n scatterings has n + 2 vertices, so that t follows from s. Where two walks are taken to have
/// met although they only came near each other (photon mapping), one vertex is of both, and s + t is one more.
struct Technique {
  std::uint16_t light_vertices = 0;  ///< s
  bool merged = false;
  static const Technique Hit;        ///< s = 0: the walk from the eye ran into the light
  static const Technique NextEvent;  ///< s = 1: a point of the light was joined to it

  constexpr std::size_t eye_vertices(std::size_t scatterings) const {
    return scatterings + (merged ? 3u : 2u) - light_vertices;
  }
  auto operator<=>(const Technique&) const = default;
};
inline constexpr Technique Technique::Hit{0, false};
inline constexpr Technique Technique::NextEvent{1, false};

/// Light that no path carries: the ambient term, and the lecture's mirror ray continued at a diffuse surface.
enum class NonPath : std::uint8_t { Ambient, Phantom };

/// Why a walk from the eye stopped: it left the scene, for a sky or for nothing at all; it was absorbed; it was cut off
/// at the depth limit; or roulette ended it.
enum class PathEnd : std::uint8_t { Escaped, EscapedUnlit, Absorbed, DepthLimit, Roulette };

/// One finished path's value at one pixel: L f G / p with every weight applied; radiance per channel, for one sample
/// (not yet divided by the number of samples).
struct Contribution {
  taxonomy::WordTrie::Node word = 0;  ///< a finished word of the sink's own trie
  Rgb value;
  Technique technique = Technique::Hit;
};

class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void begin_sample(int x, int y, int sample) = 0;
  /// NaN, infinite and negative values are counted as rejected, never added.
  virtual void add(const Contribution& contribution) = 0;
  /// All of them, in their order: one call per sample is cheaper than one per path.
  virtual void add(std::span<const Contribution> contributions) {
    for (const Contribution& contribution : contributions) add(contribution);
  }
  /// Light that a walk from the light brings to some pixel of the picture, as part of the sample under way. The value
  /// is already divided by the number of such walks that make up one sample of every pixel. Only sinks of algorithms
  /// that splat take any. Errors: std::logic_error otherwise.
  virtual void splat(int /*x*/, int /*y*/, const Contribution& /*contribution*/) {
    throw std::logic_error("this sink takes no light for other pixels than the sample's");
  }
  virtual void add_non_path(NonPath buffer, Rgb value) = 0;
  virtual void end_path(PathEnd end) = 0;
  /// Light of this sample that the depth limit cut off, as far as the tracer can tell: an unbiased estimate or nothing.
  virtual void add_cut_off(Rgb) {}

  taxonomy::WordTrie& words() { return words_; }

 private:
  taxonomy::WordTrie words_;
};

}  // namespace heckbert::record
