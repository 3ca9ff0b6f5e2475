#include <heckbert/record/header_check.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace heckbert::record::exr {

namespace {

struct FixedSize {
  std::string_view type;
  std::uint64_t bytes;
};

/// The types whose values have one size. Of the others, OpenEXR takes all bytes as they are, or they are read below.
constexpr auto kFixedSizes = std::to_array<FixedSize>({
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
});

/// What is left of a value or of the file.
class Bytes {
 public:
  Bytes(std::istream& in, std::uint64_t left) : in_(in), left_(left) {}

  std::uint64_t left() const { return left_; }
  bool skip(std::uint64_t count) {
    if (count > left_) return false;
    constexpr std::uint64_t kShort = 4096;  // seeking throws away what the stream has read ahead
    if (count < kShort)
      in_.ignore(static_cast<std::streamsize>(count));
    else
      in_.seekg(static_cast<std::streamoff>(count), std::ios::cur);
    left_ -= count;
    return in_.good();
  }
  /// A number of four bytes, little-endian; nothing where there is none.
  std::optional<std::uint32_t> number() {
    std::array<unsigned char, 4> bytes{};
    if (bytes.size() > left_ || !in_.read(reinterpret_cast<char*>(bytes.data()), bytes.size())) return std::nullopt;
    left_ -= bytes.size();
    std::uint32_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
    return value;
  }
  /// Up to a zero byte, which is taken too; nothing where there is none.
  std::optional<std::string> text() {
    std::string text;
    for (char c = 0; left_ > 0 && in_.get(c); text += c) {
      --left_;
      if (c == '\0') return text;
    }
    return std::nullopt;
  }

 private:
  std::istream& in_;
  std::uint64_t left_;
};

bool is_list_of_texts(Bytes value) {
  while (value.left() > 0) {
    const auto length = value.number();
    if (!length || !value.skip(*length)) return false;
  }
  return true;
}

bool is_list_of_channels(Bytes value) {
  constexpr std::uint64_t kAfterName = 16;  // pixel type, linearity, two sampling rates
  for (;;) {
    const auto name = value.text();
    if (!name) return false;
    if (name->empty()) return value.left() == 0;
    if (!value.skip(kAfterName)) return false;
  }
}

bool is_preview(Bytes value) {
  const auto width = value.number(), height = value.number();
  return width && height && value.left() == 4 * std::uint64_t{*width} * *height;
}

/// OpenEXR allocates for every line, and for every pixel of one, before it looks for them. A line has a place in the
/// table of chunks, of eight bytes, that at most 256 lines share; a pixel of a line has at least a byte, which deflate
/// packs to a 1032nd at best (zlib, "Technical Details").
bool is_window_of(std::uint64_t file_bytes, Bytes value) {
  std::array<std::int64_t, 4> corners{};  // x and y of the first, x and y of the last
  for (std::int64_t& corner : corners) {
    const auto number = value.number();
    if (!number) return false;
    corner = static_cast<std::int32_t>(*number);
  }
  const std::int64_t columns = corners[2] - corners[0] + 1, lines = corners[3] - corners[1] + 1;
  const auto is_most = [](std::int64_t count, std::uint64_t most) {
    return count > 0 && static_cast<std::uint64_t>(count) <= most;
  };
  return is_most(columns, 1032 * file_bytes) && is_most(lines, 256 / 8 * file_bytes);
}

bool fits(std::string_view name, std::string_view type, Bytes value, std::uint64_t file_bytes) {
  const auto fixed = std::ranges::find(kFixedSizes, type, &FixedSize::type);
  if (fixed != kFixedSizes.end())
    return value.left() == fixed->bytes && (name != "dataWindow" || is_window_of(file_bytes, value));
  if (type == "stringvector") return is_list_of_texts(value);
  if (type == "chlist") return is_list_of_channels(value);
  if (type == "preview") return is_preview(value);
  return true;
}

/// Where the header ends is where the stream is left.
void check_header(Bytes& file, std::istream& in, std::uint64_t file_bytes, bool has_manifest = false) {
  for (;;) {
    const auto name = file.text();
    const auto refuse = [&](std::string_view why) {
      throw std::runtime_error(fmt::format("the file is damaged: {} '{}'", why, name.value_or("")));
    };
    if (!name) refuse("its header ends inside the attribute");
    if (name->empty()) return;
    const auto type = file.text();
    const auto size = file.number();
    if (!type || !size || *size > file.left()) refuse("its header ends inside the attribute");
    const auto value = in.tellg();
    if (!fits(*name, *type, Bytes(in, *size), file_bytes)) refuse("sizes do not fit in the attribute");
    in.clear();
    in.seekg(value);
    file.skip(*size);
    if (*type != "idmanifest") continue;

    // OpenEXR 3.1 takes four bytes more than the manifest has, which are of the next attribute's name. So what follows
    // must be well-formed when it is read from either place, and end in the same one.
    if (has_manifest) refuse("there is a second id manifest");
    const auto next = in.tellg();
    Bytes eaten = file;
    if (!eaten.skip(4)) refuse("its header ends inside the attribute");
    check_header(eaten, in, file_bytes, true);
    const auto end = in.tellg();
    in.seekg(next);
    check_header(file, in, file_bytes, true);
    if (in.tellg() != end) refuse("sizes do not fit behind the attribute");
    return;
  }
}

}  // namespace

void check_headers(std::istream& in, std::uint64_t file_bytes) {
  Bytes file(in, file_bytes);
  constexpr std::uint32_t kSeveralParts = 1u << 12;
  file.number();
  const bool is_single = (file.number().value_or(0) & kSeveralParts) == 0;
  do check_header(file, in, file_bytes);
  while (!is_single && in.peek() != '\0');  // an empty header ends the list
}

}  // namespace heckbert::record::exr
