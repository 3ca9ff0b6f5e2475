#pragma once
// The record: energy and count by pixel and word; what a render leaves behind and every later question is answered
// from. Sparse and exact (design decision 4): a pixel holds only the words that were found there.
//
// Beauty is the sum of the words in the order of the word list, added in double and rounded once (design decision 5),
// and so is the image of any language.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/record/folding.h>
#include <heckbert/record/rgb.h>
#include <heckbert/record/samples.h>
#include <heckbert/record/sum.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/word.h>

namespace heckbert::record {

/// Pixels [x0, x1) x [y0, y1) of a picture, y downwards.
struct Window {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  std::size_t pixel_count() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()); }
  bool operator==(const Window&) const = default;
};

/// How finely the energies of pixels are kept in a file. Sums over the picture are as exact in either.
enum class Precision : std::uint8_t { Half, Float };

struct PrecisionFacts {
  Precision precision;
  std::string_view name, meaning;
};

inline constexpr std::array<PrecisionFacts, 2> kPrecisions{{
    {Precision::Half, "half", "11 bits, from 3e-8 to 65504"},
    {Precision::Float, "float", "24 bits"},
}};

/// What was rendered and how; stored in the file's header.
struct RenderInfo {
  std::string scene{};       ///< file or built-in name
  std::string scene_hash{};  ///< of its contents, 16 hexadecimal digits; empty: not known
  std::string algorithm{};   ///< "path", "whitted", ...
  std::string method{};      ///< what this algorithm was told beyond that, "flat=1"; empty: nothing
  std::string sampler{};     ///< "sobol", ...
  std::string filter{};      ///< of the pixels, with its radius: "box 0.5"
  int width = 0, height = 0;
  Window window{};  ///< the part that was rendered; the whole picture unless cropped
  int samples_per_pixel = 0;
  std::uint64_t seed = 0;
  /// Which samples these are, when they are not all those of the render with `seed`; else empty. See set_samples().
  std::vector<SampleRange> parts{};
  /// False: the samples came without their numbers, as one batch, and no interval is known.
  bool has_batches = true;
  /// False: what the depth limit cut off was not estimated.
  bool knows_cut_off = true;
  int max_depth = 0;     ///< most scatterings per path
  bool partial = false;  ///< interrupted: some pixels have no samples
  /// What the expressions declared with the render say of glossy bounces.
  taxonomy::GlossyRule glossy = taxonomy::GlossyRule::Keep;
  std::string labels{};                ///< what letters are labelled with, "object,light-group"; empty: nothing
  std::string version{};               ///< of the tool
  std::vector<std::string> ignored{};  ///< what the scene's file says and was not used, in sentences with their places
  Precision precision = Precision::Float;  ///< of the energies by pixel, where they are or will be written
  bool operator==(const RenderInfo&) const = default;
};

/// Which samples every pixel has, as united() lists them.
std::vector<SampleRange> samples_of(const RenderInfo& info);
/// Sets samples_per_pixel, seed (of the first range) and parts. Takes: what united() gives, not empty.
void set_samples(RenderInfo& info, const std::vector<SampleRange>& ranges);
/// How many samples of a pixel are in each batch. Their sum is samples_per_pixel.
std::array<int, kBatches> batch_sizes(const RenderInfo& info);
/// How many batches have samples; intervals need two.
int batches_in_use(const RenderInfo& info);

/// What happened to the walks; every sample that was not recorded is counted here.
struct Tally {
  std::uint64_t samples = 0;  ///< camera samples begun
  /// Contributions, by technique: no vertex from the light, one, several, and walks that met.
  std::uint64_t hits = 0, next_events = 0, connections = 0, merges = 0;
  std::uint64_t contributions() const { return hits + next_events + connections + merges; }
  std::uint64_t escaped = 0, escaped_unlit = 0, absorbed = 0, depth_limited = 0, roulette = 0;
  std::uint64_t rejected_not_finite = 0, rejected_negative = 0;
  /// Contributions brighter than kMostLight, added as kMostLight, and those too faint for a quantum (sum.h).
  std::uint64_t clamped = 0, vanished = 0;
  /// Energies of a word at a pixel that half precision cannot hold: written as 65504, or as 0.
  std::uint64_t half_clamped = 0, half_vanished = 0;
  /// Luminance that the depth limit cut off, as the tracer estimates it: sum over the samples, and sum of the squares.
  Quanta cut_off = 0, cut_off_squares = 0;
  Tally& operator+=(const Tally& other);
  bool operator==(const Tally&) const = default;
};

struct TallyFacts {
  std::string_view name;  ///< as in file headers and JSON
  std::uint64_t Tally::*field;
};

inline constexpr std::array<TallyFacts, 16> kTallyFields{{
    {"samples", &Tally::samples},
    {"hits", &Tally::hits},
    {"next_events", &Tally::next_events},
    {"connections", &Tally::connections},
    {"merges", &Tally::merges},
    {"escaped", &Tally::escaped},
    {"escaped_unlit", &Tally::escaped_unlit},
    {"absorbed", &Tally::absorbed},
    {"depth_limited", &Tally::depth_limited},
    {"roulette", &Tally::roulette},
    {"rejected_not_finite", &Tally::rejected_not_finite},
    {"rejected_negative", &Tally::rejected_negative},
    {"clamped", &Tally::clamped},
    {"vanished", &Tally::vanished},
    {"half_clamped", &Tally::half_clamped},
    {"half_vanished", &Tally::half_vanished},
}};

struct TallySumFacts {
  std::string_view name;  ///< as in file headers
  Quanta Tally::*field;
};

inline constexpr std::array<TallySumFacts, 2> kTallySums{{
    {"cut_off", &Tally::cut_off},
    {"cut_off_squares", &Tally::cut_off_squares},
}};

/// Light that can be: finite and not negative in every channel.
inline bool is_recordable(Rgb value) {
  return is_finite(value) && value.r >= 0 && value.g >= 0 && value.b >= 0;
}

struct Entry {
  std::uint32_t word = 0;   ///< index into Record::words
  Rgb energy;               ///< mean over the pixel's samples
  std::uint32_t count = 0;  ///< contributions
  bool operator==(const Entry&) const = default;
};

struct Record {
  RenderInfo info;
  Tally tally;
  std::vector<taxonomy::Word> words;  ///< sorted, distinct, each present in some entry
  std::vector<std::uint64_t> counts;  ///< by word: contributions in the whole picture
  std::vector<std::size_t> offsets;   ///< pixel i of the window, row by row, has entries [offsets[i], offsets[i+1])
  std::vector<Entry> entries;         ///< within a pixel sorted by word
  /// Per word and batch, the picture mean of the energy estimated from that batch alone; shape words x kBatches,
  /// row by row. Batches not in use are zero. The mean is over all pixels of the window: in a partial render the
  /// pixels without samples count as black.
  std::vector<Rgb> batch_means;
  std::vector<Rgb> ambient, phantom;  ///< non-path light, mean over samples, one per pixel; empty when never added
  std::optional<Folding> folding{};   ///< where there were more words than the memory was to hold
  bool operator==(const Record&) const = default;

  std::span<const Entry> pixel(int x, int y) const;  ///< x, y in picture coordinates, inside info.window
};

/// A picture over a window, row by row.
struct Image {
  Window window;
  std::vector<Rgb> pixels;
  Rgb at(int x, int y) const;
};

/// By word of the record: is it in the language? `rule` says what the language's letters mean for glossy events.
std::vector<bool> members(const Record& record, const taxonomy::Language& language,
                          taxonomy::GlossyRule rule = taxonomy::GlossyRule::Keep);

/// By word of the record: does it stand for words of which some are in the language and some may not be? Never, unless
/// the record is folded, and not for languages that stay exact.
std::vector<bool> undecided(const Record& record, const taxonomy::Language& language,
                            taxonomy::GlossyRule rule = taxonomy::GlossyRule::Keep);

/// Many languages asked at once. Words that are in the same ones have the same outcome; few outcomes occur.
struct Outcomes {
  std::vector<std::uint32_t> of_word;
  std::vector<std::vector<bool>> members;  ///< by outcome, then by language
};

/// The words are walked once for all of the languages.
Outcomes outcomes(const Record& record, std::span<const taxonomy::Language> languages,
                  taxonomy::GlossyRule rule = taxonomy::GlossyRule::Keep);
/// By language, then by word. Takes: outcomes of as many languages.
std::vector<std::vector<bool>> sets_of(const Outcomes& outcomes, std::size_t languages);
/// As sets_of(outcomes()).
std::vector<std::vector<bool>> members(const Record& record, std::span<const taxonomy::Language> languages,
                                       taxonomy::GlossyRule rule = taxonomy::GlossyRule::Keep);

/// The sum of all words at every pixel. O(entries).
Image beauty(const Record& record);
/// The sum of the chosen words at every pixel, in the same order of addition as beauty(). `chosen` is by word.
Image image_of(const Record& record, const std::vector<bool>& chosen);
/// The same for many sets of words, which may overlap, in one pass.
std::vector<Image> images_of(const Record& record, const std::vector<std::vector<bool>>& sets);

}  // namespace heckbert::record
