#include <heckbert/record/path_stream_header.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

#include <fmt/format.h>

#include <heckbert/record/path_stream.h>
#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/label.h>

namespace heckbert::record {

namespace {

constexpr int kLargestSide = 1 << 14;
constexpr int kMostSamples = 1 << 30;

struct Encoding {
  PathStreamEncoding encoding;
  std::string_view name;
};
constexpr std::array<Encoding, 2> kEncodings{
    {{PathStreamEncoding::Text, "text"}, {PathStreamEncoding::Binary, "binary"}}};

class HeaderReader {
 public:
  explicit HeaderReader(StreamLines& lines) : lines_(lines) {}

  PathStreamHeader read() {
    read_first_line();
    bool is_whole = false;
    while (!is_whole && lines_.next()) {
      is_whole = lines_.text() == "paths";
      if (!is_whole) read_line();
    }
    if (!is_whole) lines_.refuse(0, 1, "the stream ends within its header; expected more lines and then 'paths'");
    for (const PathStreamKey& key : kPathStreamKeys)
      if (key.is_required && !seen_.contains(key.name))
        lines_.refuse(0, lines_.text().size(), fmt::format("the header lacks '{} {}'", key.name, key.value));
    check_window();
    lines_.check();
    return header_;
  }

 private:
  void read_first_line() {
    if (!lines_.next()) lines_.refuse(0, 1, fmt::format("the stream is empty; expected '{} text'", kPathStreamMagic));
    for (const Encoding& encoding : kEncodings) {
      if (lines_.text() != fmt::format("{} {}", kPathStreamMagic, encoding.name)) continue;
      header_.encoding = encoding.encoding;
      return;
    }
    lines_.refuse(0, lines_.text().size(),
                  fmt::format("this is no path stream; expected '{0} text' or '{0} binary'", kPathStreamMagic));
    lines_.check();
  }

  void read_line() {
    const std::string& line = lines_.text();
    fields_ = fields_of(line);
    const StreamField name = fields_.front();
    const auto key = std::ranges::find(kPathStreamKeys, name.text, &PathStreamKey::name);
    if (key == kPathStreamKeys.end()) return refuse_key(name);
    if (!seen_.insert(key->name).second)
      return lines_.refuse(name.offset, name.text.size(), fmt::format("'{}' is told twice", name.text));
    key_ = key->name;
    value_ = key->value;
    if (key_ == "size") {
      if (expect(2)) read_size();
    } else if (key_ == "crop") {
      if (expect(4)) read_crop();
    } else if (key_ == "samples") {
      if (expect(1)) header_.info.samples_per_pixel = number(1, 1, kMostSamples);
    } else if (key_ == "depth") {
      if (expect(1)) header_.info.max_depth = number(1, 0, std::numeric_limits<int>::max());
    } else if (key_ == "seed") {
      if (expect(1)) header_.info.seed = number<std::uint64_t>(1, 0, std::numeric_limits<std::uint64_t>::max());
    } else if (key_ == "light") {
      if (expect(1)) header_.light = symbol(1, taxonomy::Role::Light);
    } else if (key_ == "eye") {
      if (expect(1)) header_.eye = symbol(1, taxonomy::Role::Eye);
    } else {
      std::string& text = key_ == "scene" ? header_.info.scene : header_.info.algorithm;
      if (fields_.size() > 1) text = line.substr(fields_[1].offset);
    }
  }

  void refuse_key(StreamField name) {
    std::vector<std::string> names{"paths"};
    for (const PathStreamKey& key : kPathStreamKeys) names.emplace_back(key.name);
    const std::string near = nearest(name.text, names);
    lines_.refuse(name.offset, name.text.size(), fmt::format("a header has no '{}'", name.text),
                  near.empty() ? "" : taxonomy::did_you_mean(near));
  }

  bool expect(std::size_t values) {
    if (fields_.size() == values + 1) return true;
    lines_.refuse(0, lines_.text().size(), fmt::format("expected '{} {}'", key_, value_));
    return false;
  }

  template <class T = int>
  T number(std::size_t field, T low, T high) {
    const std::string_view text = fields_[field].text;
    T value = low;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < low || value > high) {
      lines_.refuse(fields_[field].offset, text.size(),
                    fmt::format("expected a whole number from {} to {}", low, high));
      return low;
    }
    return value;
  }

  taxonomy::Symbol symbol(std::size_t field, taxonomy::Role role) {
    const std::string_view text = fields_[field].text;
    for (const taxonomy::SymbolFacts& facts : taxonomy::kSymbols)
      if (facts.role == role && text.size() == 2 && text[0] == facts.letter && text[1] == facts.subscript)
        return facts.symbol;
    lines_.refuse(fields_[field].offset, text.size(), fmt::format("expected one of {}", value_));
    return {};
  }

  void read_size() {
    header_.info.width = number(1, 1, kLargestSide);
    header_.info.height = number(2, 1, kLargestSide);
  }

  void read_crop() {
    const auto side = [&](std::size_t field) { return number(field, 0, kLargestSide); };
    header_.info.window = {side(1), side(2), side(3), side(4)};
    const Window& crop = header_.info.window;
    if (crop.x0 >= crop.x1 || crop.y0 >= crop.y1)
      lines_.refuse(0, lines_.text().size(), "the crop is empty; X1 must exceed X0 and Y1 must exceed Y0");
  }

  void check_window() {
    RenderInfo& info = header_.info;
    if (!seen_.contains("crop")) info.window = {0, 0, info.width, info.height};
    if (info.window.x1 > info.width || info.window.y1 > info.height)
      lines_.refuse(0, lines_.text().size(),
                    fmt::format("the crop reaches beyond the picture of {}x{}", info.width, info.height));
  }

  StreamLines& lines_;
  PathStreamHeader header_{
      .info = {.scene = "another renderer's", .algorithm = "imported", .max_depth = -1, .version = HECKBERT_VERSION}};
  std::set<std::string_view> seen_;
  std::vector<StreamField> fields_;  // of the line
  std::string_view key_, value_;     // of the line: its key and what follows it
};

}  // namespace

bool StreamLines::next() {
  while (std::getline(stream_, text_)) {
    ++number_;
    bytes_ += text_.size() + 1;
    while (!text_.empty() && taxonomy::is_blank(text_.back())) text_.pop_back();
    const std::size_t first = text_.find_first_not_of(" \t");
    if (first != std::string::npos && text_[first] != '#') return true;
  }
  text_.clear();
  ++number_;
  return false;
}

void StreamLines::refuse(std::size_t offset, std::size_t length, std::string message, std::string suggestion) {
  note(diagnose(source_, text_, offset, std::max<std::size_t>(length, 1), std::move(message), std::move(suggestion)));
}

void StreamLines::refuse(std::size_t offset, const InputError& error) {
  for (const Diagnostic& inner : error.diagnostics()) {
    // Columns count characters, and so does the offset in front of the inner text.
    Diagnostic outer = diagnose(source_, text_, offset, inner.length, inner.message, inner.suggestion);
    outer.column += inner.column - 1;
    outer.length = inner.length;
    outer.code = inner.code;
    note(std::move(outer));
  }
}

void StreamLines::note(Diagnostic diagnostic) {
  constexpr std::size_t kMostErrors = 20;
  diagnostic.line = number_;
  errors_.push_back(std::move(diagnostic));
  if (errors_.size() < kMostErrors) return;
  Diagnostic& last = errors_.emplace_back();
  last.source = source_;
  last.message = "and perhaps more: reading stopped here";
  check();
}

void StreamLines::check() const {
  if (!errors_.empty()) throw InputError(errors_);
}

std::vector<StreamField> fields_of(std::string_view line) {
  std::vector<StreamField> fields;
  for (std::size_t at = 0; at < line.size();) {
    if (taxonomy::is_blank(line[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < line.size() && !taxonomy::is_blank(line[at])) {
      const auto label = line[at] == '\'' ? taxonomy::read_label(line, at) : std::nullopt;
      at += label ? label->length : 1;
    }
    fields.push_back({line.substr(begin, at - begin), begin});
  }
  return fields;
}

PathStreamHeader read_path_stream_header(StreamLines& lines) {
  return HeaderReader(lines).read();
}

}  // namespace heckbert::record
