#include <heckbert/record/exr.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfTestFile.h>
#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include <heckbert/record/header_check.h>

namespace heckbert::record::exr {

namespace {

constexpr std::array<std::pair<const char*, std::string RenderInfo::*>, 7> kTexts{{
    {"heckbert.scene", &RenderInfo::scene},
    {"heckbert.scene_hash", &RenderInfo::scene_hash},
    {"heckbert.algorithm", &RenderInfo::algorithm},
    {"heckbert.sampler", &RenderInfo::sampler},
    {"heckbert.filter", &RenderInfo::filter},
    {"heckbert.labels", &RenderInfo::labels},
    {"heckbert.version", &RenderInfo::version},
}};
constexpr std::array<std::pair<const char*, int RenderInfo::*>, 2> kNumbers{{
    {"heckbert.samples_per_pixel", &RenderInfo::samples_per_pixel},
    {"heckbert.max_depth", &RenderInfo::max_depth},
}};
constexpr const char* kSeed = "heckbert.seed";  // as text: OpenEXR has no 64-bit attribute
constexpr const char* kPartial = "heckbert.partial";
constexpr const char* kHasBatches = "heckbert.has_batches";
constexpr const char* kCutOffUnknown = "heckbert.cut_off_unknown";  // absent when it was estimated
constexpr const char* kParts = "heckbert.parts";  // "seed of first last"; absent when all of one render
constexpr const char* kPrecision = "heckbert.precision";
constexpr const char* kGlossy = "heckbert.glossy";
constexpr const char* kIgnored = "heckbert.ignored";  // absent when there is nothing
constexpr const char* kMethod = "heckbert.method";    // likewise

struct ColourChannel {
  const char* name;
  std::size_t offset;
};
constexpr std::array<ColourChannel, 3> kColourChannels{
    {{"R", offsetof(Rgb, r)}, {"G", offsetof(Rgb, g)}, {"B", offsetof(Rgb, b)}}};

std::string_view name_of(Precision precision) {
  return kPrecisions[static_cast<std::size_t>(precision)].name;
}

Precision precision_of(const std::string& name) {
  for (const PrecisionFacts& facts : kPrecisions)
    if (facts.name == name) return facts.precision;
  throw std::runtime_error(fmt::format("the header attribute '{}' is '{}'", kPrecision, name));
}

taxonomy::GlossyRule glossy_of(const std::string& name) {
  for (const taxonomy::GlossyRuleFacts& facts : taxonomy::kGlossyRules)
    if (facts.name == name) return facts.rule;
  throw std::runtime_error(fmt::format("the header attribute '{}' is '{}'", kGlossy, name));
}

[[noreturn]] void refuse_number(const std::string& digits, const std::string& name) {
  throw std::runtime_error(fmt::format("the header attribute '{}' is '{}', not a whole number", name, digits));
}

Imf::StringVector texts_of(const std::vector<SampleRange>& parts) {
  Imf::StringVector texts;
  for (const SampleRange& part : parts)
    texts.push_back(fmt::format("{} {} {} {}", part.seed, part.of, part.first, part.last));
  return texts;
}

/// Throws std::runtime_error unless the texts are those of a list of ranges that fits what `info` already says.
void read_parts(const Imf::StringVector& texts, RenderInfo& info) {
  std::vector<SampleRange> parts;
  for (const std::string& text : texts) {
    SampleRange& part = parts.emplace_back();
    std::istringstream(text) >> part.seed >> part.of >> part.first >> part.last;
    const bool is_range = 0 <= part.first && part.first < part.last && part.last <= part.of;
    const bool is_sorted = parts.size() < 2 || parts[parts.size() - 2] < part;
    if (!is_range || !is_sorted) parts.clear();
    if (parts.empty()) break;
  }
  const int samples = info.samples_per_pixel;
  if (!parts.empty()) set_samples(info, parts);
  if (texts_of(info.parts) != texts || info.samples_per_pixel != samples)
    throw std::runtime_error(fmt::format("the header attribute '{}' does not fit the samples", kParts));
}

}  // namespace

int threads() {
  static const bool is_pool_ready = [] {
    if (Imf::globalThreadCount() == 0)
      Imf::setGlobalThreadCount(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    return true;
  }();
  return is_pool_ready ? Imf::globalThreadCount() : 0;
}

Window window_of(const Imath::Box2i& box) {
  return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}
Imath::Box2i box_of(const Window& window) {
  return {{window.x0, window.y0}, {window.x1 - 1, window.y1 - 1}};
}

Imf::Header header_for(const RenderInfo& info) {
  Imf::Header header(box_of({0, 0, info.width, info.height}), box_of(info.window));
  for (const auto& [name, field] : kTexts) header.insert(name, Imf::StringAttribute(info.*field));
  for (const auto& [name, field] : kNumbers) header.insert(name, Imf::IntAttribute(info.*field));
  header.insert(kSeed, Imf::StringAttribute(std::to_string(info.seed)));
  header.insert(kPartial, Imf::IntAttribute(info.partial ? 1 : 0));
  header.insert(kHasBatches, Imf::IntAttribute(info.has_batches ? 1 : 0));
  if (!info.knows_cut_off) header.insert(kCutOffUnknown, Imf::IntAttribute(1));
  if (!info.parts.empty()) header.insert(kParts, Imf::StringVectorAttribute(texts_of(info.parts)));
  header.insert(kGlossy,
                Imf::StringAttribute(std::string(taxonomy::kGlossyRules[static_cast<std::size_t>(info.glossy)].name)));
  header.insert(kPrecision, Imf::StringAttribute(std::string(name_of(info.precision))));
  if (!info.method.empty()) header.insert(kMethod, Imf::StringAttribute(info.method));
  if (!info.ignored.empty()) header.insert(kIgnored, Imf::StringVectorAttribute(info.ignored));
  return header;
}

RenderInfo info_of(const Imf::Header& header) {
  RenderInfo info;
  const Window picture = window_of(header.displayWindow());
  info.width = picture.width();
  info.height = picture.height();
  info.window = window_of(header.dataWindow());
  for (const auto& [name, field] : kTexts) info.*field = attribute<Imf::StringAttribute>(header, name);
  for (const auto& [name, field] : kNumbers) info.*field = attribute<Imf::IntAttribute>(header, name);
  info.seed = parse_number(attribute<Imf::StringAttribute>(header, kSeed), kSeed);
  info.partial = attribute<Imf::IntAttribute>(header, kPartial) != 0;
  info.has_batches = attribute<Imf::IntAttribute>(header, kHasBatches) != 0;
  info.knows_cut_off = header.find(kCutOffUnknown) == header.end();
  if (header.find(kParts) != header.end()) read_parts(attribute<Imf::StringVectorAttribute>(header, kParts), info);
  info.glossy = glossy_of(attribute<Imf::StringAttribute>(header, kGlossy));
  info.precision = precision_of(attribute<Imf::StringAttribute>(header, kPrecision));
  if (header.find(kMethod) != header.end()) info.method = attribute<Imf::StringAttribute>(header, kMethod);
  if (header.find(kIgnored) != header.end()) info.ignored = attribute<Imf::StringVectorAttribute>(header, kIgnored);
  return info;
}

std::uint64_t parse_number(const std::string& digits, const std::string& name) {
  std::uint64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || stop != end) refuse_number(digits, name);
  return value;
}

Quanta parse_quanta(const std::string& digits, const std::string& name) {
  constexpr std::size_t kMostDigits = 38;  // 10^38 < 2^128
  if (digits.empty() || digits.size() > kMostDigits) refuse_number(digits, name);
  Quanta value = 0;
  for (const char digit : digits) {
    if (digit < '0' || digit > '9') refuse_number(digits, name);
    value = 10 * value + static_cast<Quanta>(digit - '0');
  }
  return value;
}

void insert_rgb(Imf::FrameBuffer& frame, const std::string& prefix, const Rgb* pixels, const Window& window) {
  const Imath::Box2i box = box_of(window);
  for (const ColourChannel& channel : kColourChannels) {
    const char* first = reinterpret_cast<const char*>(pixels) + channel.offset;
    frame.insert(prefix + channel.name, Imf::Slice::Make(Imf::FLOAT, first, box, sizeof(Rgb)));
  }
}

void insert_rgb(Imf::ChannelList& channels, const std::string& prefix) {
  for (const ColourChannel& channel : kColourChannels) channels.insert(prefix + channel.name, Imf::Channel(Imf::FLOAT));
}

OutputStream::OutputStream(const std::filesystem::path& path) : Imf::OStream(path.c_str()) {
  errno = 0;
  file_.open(path, std::ios::binary | std::ios::trunc);
  check();
}

void OutputStream::write(const char bytes[], int count) {
  file_.write(bytes, count);
  check();
}

std::uint64_t OutputStream::tellp() {
  return static_cast<std::uint64_t>(file_.tellp());
}

void OutputStream::seekp(std::uint64_t place) {
  file_.seekp(static_cast<std::streamoff>(place));
  check();
}

void OutputStream::close() {
  file_.close();
  check();
}

void OutputStream::check() {
  if (file_) return;
  if (error_ == 0) error_ = errno;
  throw std::runtime_error(std::generic_category().message(error_));
}

bool can_unpack_to(std::uint64_t unpacked_bytes, std::uint64_t file_bytes) {
  constexpr std::uint64_t kMostDeflated = 1032;
  return unpacked_bytes / kMostDeflated <= file_bytes;
}

std::uint64_t check_is_exr(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) throw std::runtime_error(std::generic_category().message(EISDIR));
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(std::generic_category().message(errno));
  if (!Imf::isOpenExrFile(path.c_str())) throw std::runtime_error("this is not an OpenEXR file");
  const std::uint64_t file_bytes = std::filesystem::file_size(path);
  check_headers(in, file_bytes);
  return file_bytes;
}

}  // namespace heckbert::record::exr
