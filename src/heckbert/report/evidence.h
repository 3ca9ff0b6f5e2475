#pragma once
// What independent renders of one scene by one algorithm say, batch by batch: the energy of every word in the whole
// picture and in every block of pixels. Every render is a batch. Hence nothing is supposed about how an algorithm makes
// its samples: photons and virtual lights that all pixels of a render share are not shared by two batches.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/word.h>

namespace heckbert::report {

/// Mean luminance of something as each batch alone has it, and from how many contributions.
struct Series {
  record::BatchSeries values{};  ///< batches not in use are zero
  std::uint64_t count = 0;
  Series& operator+=(const Series& other);
};

struct BrightPixel {
  int x = 0, y = 0;
  double luminance = 0;  ///< in the brightest batch, or on average where a record has the batches
};

/// A picture with its spread: by pixel the mean, and the standard error of its luminance.
struct NoisyImage {
  record::Image mean;
  std::vector<double> standard_error;
};

/// Pixels of a side of a block.
inline constexpr int kBlockSize = 32;

/// The windows that a picture is cut into, row by row; those at the right and lower edge may be smaller.
std::vector<record::Window> blocks_of(const record::Window& window);

struct WordEvidence {
  Series picture;
  std::map<std::size_t, Series> blocks{};  ///< by number in blocks_of(); those without contributions are left out
  BrightPixel brightest{};
};

class Evidence {
 public:
  /// One more independent render of the same picture. Images of `languages`, the same each time, are kept with their
  /// spread. Errors: std::invalid_argument for a record of another window, for more than record::kBatches, and behind
  /// take_batches_of.
  void add(const record::Record& batch, std::span<const taxonomy::Language> languages = {});
  /// The batches of one render, as the first and only evidence; it says nothing about blocks. Errors:
  /// std::invalid_argument when there is some already.
  void take_batches_of(const record::Record& record, std::span<const taxonomy::Language> languages = {});

  int batches() const { return batches_; }
  const record::Window& window() const { return window_; }
  /// Samples per pixel of all batches together; the mean over the pixels where these have different numbers.
  double samples_per_pixel() const { return samples_per_pixel_; }
  record::BatchStatistics statistics(double confidence) const { return {weights_, confidence}; }
  bool has_blocks() const { return has_blocks_; }
  const std::map<taxonomy::Word, WordEvidence>& words() const { return words_; }
  /// Luminance that a contribution of a word of which none was found would have added to the picture's mean, as
  /// record::contribution_if_none() has it.
  double contribution_if_none() const;
  /// By number of the language.
  NoisyImage image(std::size_t language) const;

 private:
  struct Pixels {
    std::vector<Rgb> sum;
    std::vector<double> luminance, squares;
  };
  void add_images(const record::Record& batch, std::span<const taxonomy::Language> languages);

  record::Window window_{};
  int batches_ = 0;
  double samples_per_pixel_ = 0;
  record::RenderInfo weights_{};  ///< says how much each batch counts, and no more
  bool has_blocks_ = true;
  std::map<taxonomy::Word, WordEvidence> words_;
  std::vector<Pixels> images_;
  int image_batches_ = 0;
};

}  // namespace heckbert::report
