// Records that keep their sums, on disk: written from a stream of sums and read as one.

#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include <cassert>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include <heckbert/record/deep_chunk.h>
#include <heckbert/record/exr.h>
#include <heckbert/record/file.h>
#include <heckbert/record/parallel.h>
#include <heckbert/record/paths_part.h>
#include <heckbert/record/record_header.h>
#include <heckbert/record/sums_parts.h>

namespace heckbert::record {

namespace {

using exr::require;

constexpr const char* kOthers = "the sums are not those of the means";

/// A file whose sums are read while they are asked for.
struct OpenSums {
  explicit OpenSums(const std::filesystem::path& p)
      : path(p),
        bytes(exr::check_is_exr(path)),
        file(path.c_str(), exr::threads(), false),
        means(exr::read_file_totals(file, bytes)),
        means_part(file, 0),
        sums_part(exr::sums_part(file)),
        offsets(exr::read_path_offsets(means_part, bytes)) {}

  std::filesystem::path path;
  std::uint64_t bytes;
  Imf::MultiPartInputFile file;
  Record means;  ///< without pixels
  Imf::DeepScanLineInputPart means_part, sums_part;
  std::vector<std::size_t> offsets;  ///< as in Record
};

/// Reads rows in both parts and compares them; each thread has its own.
class RowReader {
 public:
  RowReader(const OpenSums& open, const std::vector<std::uint32_t>& samples, SumsBand& band)
      : open_(open),
        samples_(samples),
        band_(band),
        means_(open.means_part, open.means.words.size()),
        sums_(open.sums_part, exr::entry_sums_layout()) {}

  /// The row of this number in the band.
  void operator()(std::size_t row) {
    const Window& window = open_.means.info.window;
    const auto above = static_cast<std::size_t>(band_.window.y0 - window.y0);
    const PixelRow pixels = pixel_row(window, open_.offsets, above + row);
    const std::size_t of_band = pixels.offsets.front() - open_.offsets[above * pixels.pixel_count()];
    entries_.resize(pixels.offsets.back() - pixels.offsets.front());
    const auto sums = std::span(band_.entries).subspan(of_band, entries_.size());
    means_.read(pixels.y, pixels.offsets, entries_);
    sums_.read(pixels.y, sums.size(), reinterpret_cast<char*>(sums.data()));
    std::size_t e = 0;
    for (std::size_t i = 0; i < pixels.pixel_count(); ++i) {
      const std::uint32_t samples = samples_[pixels.first_pixel + i];
      band_.counts[row * pixels.pixel_count() + i] =
          static_cast<std::uint32_t>(pixels.offsets[i + 1] - pixels.offsets[i]);
      for (; e < pixels.offsets[i + 1] - pixels.offsets.front(); ++e) {
        sums[e].word = entries_[e].word;
        sums[e].count = entries_[e].count;
        require(mean_of(sums[e].sum, samples) == entries_[e].energy, kOthers);
      }
    }
  }
  const std::vector<std::uint64_t>& counts() const { return means_.counts(); }

 private:
  const OpenSums& open_;
  const std::vector<std::uint32_t>& samples_;
  SumsBand& band_;
  exr::PathRowReader means_;
  exr::DeepRowReader sums_;
  std::vector<Entry> entries_;
};

SumsPass pass_of(std::shared_ptr<const OpenSums> open, std::shared_ptr<const std::vector<std::uint32_t>> samples) {
  std::vector<std::uint64_t> counts(open->means.words.size());
  return [open = std::move(open), samples = std::move(samples), counts = std::move(counts)](SumsBand& band) mutable {
    exr::reading(open->path, [&] {
      const Window& window = open->means.info.window;
      const auto width = static_cast<std::size_t>(window.width());
      const auto offset_of = [&](int y) { return open->offsets[static_cast<std::size_t>(y - window.y0) * width]; };
      band.counts.resize(band.window.pixel_count());
      band.entries.resize(offset_of(band.window.y1) - offset_of(band.window.y0));
      for (const RowReader& reader : exr::in_parallel(static_cast<std::size_t>(band.window.height()),
                                                      [&] { return RowReader(*open, *samples, band); }))
        std::ranges::transform(counts, reader.counts(), counts.begin(), std::plus<>());
      if (band.window.y1 == window.y1) exr::check_counts(counts, open->means);
    });
  };
}

}  // namespace

SumsStream open_sums(const std::filesystem::path& path) {
  return exr::reading(path, [&] {
    const auto open = std::make_shared<OpenSums>(path);
    SumsStream stream{.info = open->means.info, .totals = exr::read_sums_totals(open->file, open->means), .begin = {}};
    require(totals_of(stream) == open->means, kOthers);
    const auto samples = std::make_shared<const std::vector<std::uint32_t>>(stream.totals.samples);
    stream.begin = [open, samples] { return pass_of(open, samples); };
    return stream;
  });
}

Sums read_sums(const std::filesystem::path& path) {
  return collected(open_sums(path));
}

void write_sums(const Sums& sums, const std::filesystem::path& path) {
  write_sums(stream_of(sums), path);
}

void write_sums(const SumsStream& sums, const std::filesystem::path& path) {
  assert(!sums.folding);
  const Record means = totals_of(sums);  // floats, since reading compares them with the sums
  exr::write_record_file(means, exr::means_of_bands(sums, Precision::Float), &sums, path);
}

void write_record(const Record& totals, const SumsStream& sums, const std::filesystem::path& path) {
  exr::write_record_file(totals, exr::means_of_bands(sums, totals.info.precision), nullptr, path);
}

}  // namespace heckbert::record
