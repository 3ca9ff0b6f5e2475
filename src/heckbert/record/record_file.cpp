#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>

#include <array>
#include <utility>

#include <heckbert/record/atomic_file.h>
#include <heckbert/record/exr.h>
#include <heckbert/record/file.h>
#include <heckbert/record/paths_part.h>
#include <heckbert/record/record_header.h>
#include <heckbert/record/sums_parts.h>
#include <heckbert/record/words_part.h>

namespace heckbert::record {

namespace {

using exr::require;

constexpr const char* kPathsPart = "paths";
/// For tools that flatten: nothing covers anything.
constexpr std::array<std::pair<const char*, Imf::PixelType>, 2> kZeroChannels{{{"A", Imf::HALF}, {"Z", Imf::FLOAT}}};

struct NonPathPart {
  const char* name;
  std::vector<Rgb> Record::*buffer;
};
constexpr std::array<NonPathPart, 2> kNonPathParts{{{"ambient", &Record::ambient}, {"phantom", &Record::phantom}}};

Imf::Header paths_header(const Record& record) {
  Imf::Header header = exr::header_for(record.info);
  header.setName(kPathsPart);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  for (const exr::DeepChannel& channel : exr::paths_layout(record.info.precision).channels)
    header.channels().insert(channel.name, Imf::Channel(channel.type));
  for (const auto& [name, type] : kZeroChannels) header.channels().insert(name, Imf::Channel(type));
  exr::insert_totals(header, record);
  return header;
}

Imf::Header non_path_header(const Record& record, const char* name) {
  Imf::Header header = exr::part_header(record.info, name, Imf::SCANLINEIMAGE, record.info.window);
  exr::insert_rgb(header.channels(), "");
  return header;
}

void write_non_path(Imf::OutputPart part, const std::vector<Rgb>& pixels, const Window& window) {
  Imf::FrameBuffer frame;
  exr::insert_rgb(frame, "", pixels.data(), window);
  part.setFrameBuffer(frame);
  part.writePixels(window.height());
}

// Reading. Failures throw std::runtime_error with the reason alone; exr::reading adds the file.

std::vector<Rgb> read_non_path(Imf::InputPart part, const Window& window) {
  require(exr::window_of(part.header().dataWindow()) == window,
          fmt::format("the part '{}' has another data window", part.header().name()));
  std::vector<Rgb> pixels(window.pixel_count());
  Imf::FrameBuffer frame;
  exr::insert_rgb(frame, "", pixels.data(), window);
  part.setFrameBuffer(frame);
  part.readPixels(window.y0, window.y1 - 1);
  return pixels;
}

/// All but what there is by pixel.
Record read_picture_totals(Imf::MultiPartInputFile& file, std::uint64_t file_bytes) {
  const Imf::Header& header = file.header(0);
  exr::check_layout(header);
  for (int part = 0; part < file.parts(); ++part)
    require(file.partComplete(part), "the file is incomplete: scan lines are missing");
  Record record = exr::read_totals(header, file_bytes);
  exr::read_words(file, file_bytes, record);
  return record;
}

void read_non_path_parts(Imf::MultiPartInputFile& file, Record& record) {
  for (int number = 1; number < file.parts(); ++number)
    for (const NonPathPart& part : kNonPathParts)
      if (file.header(number).name() == part.name)
        record.*part.buffer = read_non_path(Imf::InputPart(file, number), record.info.window);
}

}  // namespace

Record exr::read_file_totals(Imf::MultiPartInputFile& file, std::uint64_t file_bytes) {
  Record record = read_picture_totals(file, file_bytes);
  read_non_path_parts(file, record);
  return record;
}

void exr::write_record_file(const Record& record, const std::function<void(DeepBand&)>& fill, const SumsStream* sums,
                            const std::filesystem::path& path) {
  exr::writing(path, [&] {
    std::vector<Imf::Header> headers{paths_header(record)};
    if (!record.words.empty()) headers.push_back(exr::words_header(record));
    for (const NonPathPart& part : kNonPathParts)
      if (!(record.*part.buffer).empty()) headers.push_back(non_path_header(record, part.name));
    const int first_sums_part = static_cast<int>(headers.size());
    if (sums != nullptr)
      for (const Imf::Header& header : exr::sums_headers(*sums)) headers.push_back(header);
    AtomicFile target(path);
    exr::OutputStream stream(target.temporary());
    {
      Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()), false, exr::threads());
      exr::write_deep(Imf::DeepScanLineOutputPart(file, 0), record.info.window,
                      exr::paths_layout(record.info.precision), kZeroChannels, fill);
      int number = 1;
      if (!record.words.empty()) exr::write_words(file, number++, record);
      for (const NonPathPart& part : kNonPathParts)
        if (const auto& pixels = record.*part.buffer; !pixels.empty())
          write_non_path(Imf::OutputPart(file, number++), pixels, record.info.window);
      if (sums != nullptr) exr::write_sums_parts(file, first_sums_part, *sums);
    }
    stream.close();
    target.commit();
  });
}

void write_record(const Record& record, const std::filesystem::path& path) {
  const Precision precision = record.info.precision;
  Record totals{.info = record.info,
                .tally = record.tally,
                .words = record.words,
                .counts = record.counts,
                .offsets = {},
                .entries = {},
                .batch_means = record.batch_means,
                .ambient = record.ambient,
                .phantom = record.phantom,
                .folding = record.folding};
  if (precision == Precision::Half)
    for (const Entry& entry : record.entries) exr::count_rounding(totals.tally, entry.energy);
  std::size_t pixel = 0;
  const auto fill = [&](exr::DeepBand& band) {
    for (std::size_t i = 0; i < band.window.pixel_count(); ++i, ++pixel) {
      band.counts.push_back(static_cast<unsigned>(record.offsets[pixel + 1] - record.offsets[pixel]));
      for (std::size_t e = record.offsets[pixel]; e < record.offsets[pixel + 1]; ++e)
        exr::append_entry(band.samples, precision, record.entries[e]);
    }
  };
  exr::write_record_file(totals, fill, nullptr, path);
}

struct RecordFile::Open {
  explicit Open(const std::filesystem::path& p)
      : path(p), bytes(exr::check_is_exr(path)), file(path.c_str(), exr::threads(), false) {}

  std::filesystem::path path;
  std::uint64_t bytes;
  Imf::MultiPartInputFile file;
  Record totals{};
};

RecordFile::RecordFile(const std::filesystem::path& path) {
  exr::reading(path, [&] {
    open_ = std::make_unique<Open>(path);
    open_->totals = exr::read_file_totals(open_->file, open_->bytes);
  });
}

RecordFile::RecordFile(RecordFile&&) noexcept = default;
RecordFile& RecordFile::operator=(RecordFile&&) noexcept = default;
RecordFile::~RecordFile() = default;

const Record& RecordFile::totals() const {
  return open_->totals;
}

Record RecordFile::whole() const {
  return exr::reading(open_->path, [&] {
    Record record = open_->totals;
    exr::read_paths(open_->file, open_->bytes, record);
    return record;
  });
}

void RecordFile::visit_rows(const RowVisitor& visit) const {
  exr::reading(open_->path, [&] { exr::visit_paths(open_->file, open_->bytes, open_->totals, visit); });
}

Rows rows_of(const RecordFile& file) {
  return [&file](const RowVisitor& visit) { file.visit_rows(visit); };
}

Record read_record(const std::filesystem::path& path) {
  return exr::reading(path, [&] {
    const std::uint64_t file_bytes = exr::check_is_exr(path);
    Imf::MultiPartInputFile file(path.c_str(), exr::threads(), false);
    Record record = exr::read_file_totals(file, file_bytes);
    exr::read_paths(file, file_bytes, record);
    return record;
  });
}

Record read_record_totals(const std::filesystem::path& path) {
  return exr::reading(path, [&] {
    const std::uint64_t file_bytes = exr::check_is_exr(path);
    Imf::MultiPartInputFile file(path.c_str(), exr::threads(), false);
    return read_picture_totals(file, file_bytes);
  });
}

}  // namespace heckbert::record
