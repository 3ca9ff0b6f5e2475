#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfFloatVectorAttribute.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <heckbert/record/atomic_file.h>
#include <heckbert/record/exr.h>
#include <heckbert/record/file.h>
#include <heckbert/record/sums_parts.h>

namespace heckbert::record {

namespace {

constexpr int kLayoutVersion = 2;
constexpr const char* kLayout = "heckbert.record";
constexpr const char* kBatchMeans = "heckbert.batch_means";
constexpr const char* kWords = "heckbert.words";
constexpr const char* kPathsPart = "paths";
constexpr const char* kIdChannel = "id";

std::string tally_name(std::string_view name) {
  return fmt::format("heckbert.tally.{}", name);
}

struct EntryChannel {
  const char* name;
  Imf::PixelType type;
  std::size_t offset;  // within Entry
};
constexpr std::array<EntryChannel, 5> kEntryChannels{{
    {kIdChannel, Imf::UINT, offsetof(Entry, word)},
    {"R", Imf::FLOAT, offsetof(Entry, energy) + offsetof(Rgb, r)},
    {"G", Imf::FLOAT, offsetof(Entry, energy) + offsetof(Rgb, g)},
    {"B", Imf::FLOAT, offsetof(Entry, energy) + offsetof(Rgb, b)},
    {"count", Imf::UINT, offsetof(Entry, count)},
}};
constexpr std::array<std::pair<const char*, Imf::PixelType>, 2> kZeroChannels{{{"A", Imf::HALF}, {"Z", Imf::FLOAT}}};
constexpr std::uint64_t kBytesPerEntry = 5 * 4 + 2 + 4;

struct NonPathPart {
  const char* name;
  std::vector<Rgb> Record::*buffer;
};
constexpr std::array<NonPathPart, 2> kNonPathParts{{{"ambient", &Record::ambient}, {"phantom", &Record::phantom}}};

/// The base address that OpenEXR wants, from which x and y count: the one of pixel (0, 0), wherever the window starts.
template <class T>
char* base_of(std::vector<T>& pixels, const Window& window) {
  const std::ptrdiff_t before = static_cast<std::ptrdiff_t>(window.y0) * window.width() + window.x0;
  return reinterpret_cast<char*>(pixels.data()) - before * static_cast<std::ptrdiff_t>(sizeof(T));
}

/// Lets OpenEXR write from and read into entries in place: it asks for the address of each pixel's first value in each
/// channel. Costs 40 bytes per pixel, against some 20 per word that a pixel holds.
struct EntryFrame {
  explicit EntryFrame(const Window& window) : counts(window.pixel_count()) {
    for (std::vector<char*>& channel : first_values) channel.resize(window.pixel_count());
    const std::size_t width = static_cast<std::size_t>(window.width());
    buffer.insertSampleCountSlice({Imf::UINT, base_of(counts, window), sizeof(unsigned), sizeof(unsigned) * width});
    for (std::size_t c = 0; c < kEntryChannels.size(); ++c)
      buffer.insert(kEntryChannels[c].name, {kEntryChannels[c].type, base_of(first_values[c], window), sizeof(char*),
                                             sizeof(char*) * width, sizeof(Entry)});
  }

  void point_at(Entry* entries, const std::vector<std::size_t>& offsets) {
    for (std::size_t c = 0; c < kEntryChannels.size(); ++c)
      for (std::size_t i = 0; i < counts.size(); ++i)
        first_values[c][i] = counts[i] == 0 ? nullptr  // a record without entries has none to point at
                                            : reinterpret_cast<char*>(entries + offsets[i]) + kEntryChannels[c].offset;
  }

  std::vector<unsigned> counts;  // by pixel
  std::array<std::vector<char*>, kEntryChannels.size()> first_values;
  Imf::DeepFrameBuffer buffer;
};

// Writing.

Imf::IDManifest manifest_of(const Imf::StringVector& words) {
  Imf::IDManifest manifest;
  Imf::IDManifest::ChannelGroupManifest& group = manifest.add(kIdChannel);
  group.setComponent("word");
  group.setLifetime(Imf::IDManifest::LIFETIME_FRAME);
  group.setHashScheme(Imf::IDManifest::NOTHASHED);
  group.setEncodingScheme(Imf::IDManifest::ID_SCHEME);
  for (std::size_t w = 0; w < words.size(); ++w) group.insert(w, words[w]);
  return manifest;
}

Imf::Header paths_header(const Record& record) {
  Imf::Header header = exr::header_for(record.info);
  header.setName(kPathsPart);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  for (const EntryChannel& channel : kEntryChannels) header.channels().insert(channel.name, Imf::Channel(channel.type));
  for (const auto& [name, type] : kZeroChannels) header.channels().insert(name, Imf::Channel(type));
  header.insert(kLayout, Imf::IntAttribute(kLayoutVersion));
  Imf::StringVector words;
  for (const taxonomy::Word& word : record.words) words.push_back(taxonomy::fine(word));
  header.insert(kWords, Imf::StringVectorAttribute(words));
  Imf::addIDManifest(header, manifest_of(words));
  for (const TallyFacts& facts : kTallyFields)
    header.insert(tally_name(facts.name), Imf::StringAttribute(std::to_string(record.tally.*facts.field)));
  for (const TallySumFacts& facts : kTallySums)
    header.insert(tally_name(facts.name), Imf::StringAttribute(fmt::to_string(record.tally.*facts.field)));
  Imf::FloatVector means;
  means.reserve(3 * record.batch_means.size());
  for (const Rgb& mean : record.batch_means) means.insert(means.end(), {mean.r, mean.g, mean.b});
  header.insert(kBatchMeans, Imf::FloatVectorAttribute(means));
  return header;
}

Imf::Header non_path_header(const Record& record, const char* name) {
  Imf::Header header(exr::box_of({0, 0, record.info.width, record.info.height}), exr::box_of(record.info.window));
  header.setName(name);
  header.setType(Imf::SCANLINEIMAGE);
  header.compression() = Imf::ZIP_COMPRESSION;
  exr::insert_rgb(header.channels(), "");
  return header;
}

void write_entries(Imf::DeepScanLineOutputPart part, const Record& record) {
  const Window& window = record.info.window;
  EntryFrame frame(window);
  for (std::size_t i = 0; i < frame.counts.size(); ++i)
    frame.counts[i] = static_cast<unsigned>(record.offsets[i + 1] - record.offsets[i]);
  // OpenEXR takes the same frame buffer for writing as for reading, hence without const.
  frame.point_at(const_cast<Entry*>(record.entries.data()), record.offsets);
  float zero = 0;
  char* zero_sample = reinterpret_cast<char*>(&zero);
  for (const auto& [name, type] : kZeroChannels)
    frame.buffer.insert(name, {type, reinterpret_cast<char*>(&zero_sample), 0, 0, 0});
  part.setFrameBuffer(frame.buffer);
  part.writePixels(window.height());
}

void write_non_path(Imf::OutputPart part, const std::vector<Rgb>& pixels, const Window& window) {
  Imf::FrameBuffer frame;
  exr::insert_rgb(frame, "", pixels.data(), window);
  part.setFrameBuffer(frame);
  part.writePixels(window.height());
}

// Reading. Failures throw std::runtime_error with the reason alone; exr::reading adds the file.

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

void check_layout(const Imf::Header& header) {
  const std::string wanted =
      fmt::format("expected a record, that is a deep EXR with the attribute '{}' = {}", kLayout, kLayoutVersion);
  require(header.hasType() && header.type() == Imf::DEEPSCANLINE, fmt::format("this is a flat EXR; {}", wanted));
  const auto* layout = header.findTypedAttribute<Imf::IntAttribute>(kLayout);
  require(layout != nullptr, fmt::format("this is a deep EXR of another kind; {}", wanted));
  require(layout->value() == kLayoutVersion,
          fmt::format("this is a record of layout version {}; {}", layout->value(), wanted));
  for (const EntryChannel& channel : kEntryChannels) {
    const Imf::Channel* found = header.channels().findChannel(channel.name);
    require(found != nullptr && found->type == channel.type,
            fmt::format("the channel '{}' is missing or of another type", channel.name));
  }
}

void check_info(const RenderInfo& info) {
  const Window& window = info.window;
  require(window.x0 >= 0 && window.y0 >= 0 && window.x1 <= info.width && window.y1 <= info.height,
          "the data window reaches beyond the picture");
  require(info.samples_per_pixel >= 1, "the number of samples per pixel is not positive");
}

std::vector<taxonomy::Word> read_words(const Imf::Header& header, std::uint64_t file_bytes) {
  require(Imf::hasIDManifest(header), "the id manifest is missing");
  const Imf::CompressedIDManifest& packed = Imf::idManifest(header);
  require(exr::can_unpack_to(packed._uncompressedDataSize, file_bytes),
          "the file is damaged: its id manifest promises more words than it can hold");
  const Imf::IDManifest manifest(packed);
  const std::size_t group = manifest.find(kIdChannel);
  require(group < manifest.size(), "the id manifest does not tell about the channel 'id'");
  std::vector<taxonomy::Word> words;
  words.reserve(manifest[group].size());
  for (auto i = manifest[group].begin(); !(i == manifest[group].end()); ++i) {
    require(i.id() == words.size() && i.text().size() == 1, "the id manifest does not number the words 0, 1, 2 ...");
    const std::string& text = i.text().front();
    try {
      words.push_back(taxonomy::parse_word(text));
    } catch (const InputError&) {
      throw std::runtime_error(fmt::format("the id manifest has '{}', which is not a word", text));
    }
    require(taxonomy::fine(words.back()) == text, fmt::format("the id manifest has '{}' without subscripts", text));
    require(words.size() < 2 || words[words.size() - 2] < words.back(), "the words of the id manifest are not sorted");
  }
  return words;
}

std::vector<Rgb> read_batch_means(const Imf::Header& header, std::size_t word_count) {
  const std::vector<float>& means = exr::attribute<Imf::FloatVectorAttribute>(header, kBatchMeans);
  require(means.size() == word_count * kBatches * 3,
          fmt::format("the header attribute '{}' has {} numbers for {} words", kBatchMeans, means.size(), word_count));
  std::vector<Rgb> result(means.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {means[3 * i], means[3 * i + 1], means[3 * i + 2]};
    if (!is_recordable(result[i]))
      throw std::runtime_error(fmt::format("the header attribute '{}' has a negative or infinite number", kBatchMeans));
  }
  return result;
}

/// Throws unless the entries keep the promises of Record.
void check_entries(const Record& record) {
  std::vector<char> is_present(record.words.size());
  for (std::size_t i = 0; i + 1 < record.offsets.size(); ++i) {
    for (std::size_t e = record.offsets[i]; e < record.offsets[i + 1]; ++e) {
      const Entry& entry = record.entries[e];
      if (entry.word >= is_present.size()) throw std::runtime_error("a pixel has an id that the id manifest lacks");
      if (e > record.offsets[i] && record.entries[e - 1].word >= entry.word)
        throw std::runtime_error("a pixel's ids are not ascending");
      if (!is_recordable(entry.energy))
        throw std::runtime_error("a pixel has an energy that is negative or not finite");
      if (entry.count == 0) throw std::runtime_error("a pixel has a word without contributions");
      is_present[entry.word] = 1;
    }
  }
  require(std::find(is_present.begin(), is_present.end(), 0) == is_present.end(),
          "the id manifest has a word that no pixel has");
}

void read_entries(Imf::DeepScanLineInputPart part, std::uint64_t file_bytes, Record& record) {
  const Window& window = record.info.window;
  EntryFrame frame(window);
  part.setFrameBuffer(frame.buffer);
  part.readPixelSampleCounts(window.y0, window.y1 - 1);

  record.offsets.reserve(frame.counts.size() + 1);
  record.offsets.push_back(0);
  for (const unsigned count : frame.counts) record.offsets.push_back(record.offsets.back() + count);
  require(exr::can_unpack_to(record.offsets.back() * kBytesPerEntry, file_bytes),
          "the file is damaged: it promises more samples than it can hold");
  record.entries.resize(record.offsets.back());

  frame.point_at(record.entries.data(), record.offsets);
  part.readPixels(window.y0, window.y1 - 1);
  check_entries(record);
}

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

/// With `sums`, which `record` has the means of, their parts too.
void write(const Record& record, const Sums* sums, const std::filesystem::path& path) {
  exr::writing(path, [&] {
    std::vector<Imf::Header> headers{paths_header(record)};
    for (const NonPathPart& part : kNonPathParts)
      if (!(record.*part.buffer).empty()) headers.push_back(non_path_header(record, part.name));
    const int first_sums_part = static_cast<int>(headers.size());
    if (sums != nullptr)
      for (const Imf::Header& header : exr::sums_headers(*sums)) headers.push_back(header);
    AtomicFile target(path);
    exr::OutputStream stream(target.temporary());
    {
      Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()), false, exr::threads());
      write_entries(Imf::DeepScanLineOutputPart(file, 0), record);
      int number = 1;
      for (const NonPathPart& part : kNonPathParts)
        if (const auto& pixels = record.*part.buffer; !pixels.empty())
          write_non_path(Imf::OutputPart(file, number++), pixels, record.info.window);
      if (sums != nullptr) exr::write_sums_parts(file, first_sums_part, *sums);
    }
    stream.close();
    target.commit();
  });
}

Record read_means(Imf::MultiPartInputFile& file, std::uint64_t file_bytes) {
  const Imf::Header& header = file.header(0);
  check_layout(header);
  for (int part = 0; part < file.parts(); ++part)
    require(file.partComplete(part), "the file is incomplete: scan lines are missing");

  Record record;
  record.info = exr::info_of(header);
  check_info(record.info);
  require(exr::can_unpack_to(record.info.window.pixel_count() * sizeof(unsigned), file_bytes),
          "the file is damaged: it promises more pixels than it can hold");
  for (const TallyFacts& facts : kTallyFields)
    record.tally.*facts.field =
        exr::parse_number(exr::attribute<Imf::StringAttribute>(header, tally_name(facts.name)), tally_name(facts.name));
  for (const TallySumFacts& facts : kTallySums)
    record.tally.*facts.field =
        exr::parse_quanta(exr::attribute<Imf::StringAttribute>(header, tally_name(facts.name)), tally_name(facts.name));
  record.words = read_words(header, file_bytes);
  record.batch_means = read_batch_means(header, record.words.size());
  read_entries(Imf::DeepScanLineInputPart(file, 0), file_bytes, record);
  for (int number = 1; number < file.parts(); ++number)
    for (const NonPathPart& part : kNonPathParts)
      if (file.header(number).name() == part.name)
        record.*part.buffer = read_non_path(Imf::InputPart(file, number), record.info.window);
  return record;
}

}  // namespace

void write_record(const Record& record, const std::filesystem::path& path) {
  write(record, nullptr, path);
}

void write_sums(const Sums& sums, const std::filesystem::path& path) {
  write(record_of(sums), &sums, path);
}

Record read_record(const std::filesystem::path& path) {
  return exr::reading(path, [&] {
    const std::uint64_t file_bytes = exr::check_is_exr(path);
    Imf::MultiPartInputFile file(path.c_str(), exr::threads(), false);
    return read_means(file, file_bytes);
  });
}

Sums read_sums(const std::filesystem::path& path) {
  return exr::reading(path, [&] {
    const std::uint64_t file_bytes = exr::check_is_exr(path);
    Imf::MultiPartInputFile file(path.c_str(), exr::threads(), false);
    const Record record = read_means(file, file_bytes);
    require(exr::has_sums(file),
            "this record has means and no sums, so nothing can be added to it exactly; expected one of 'heckbert "
            "render --exact', --part or --checkpoint, or an interrupted one");
    return exr::read_sums_parts(file, record);
  });
}

}  // namespace heckbert::record
