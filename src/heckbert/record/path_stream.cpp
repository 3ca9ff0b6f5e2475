#include <heckbert/record/path_stream.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include <heckbert/record/path_rows.h>
#include <heckbert/record/path_stream_header.h>
#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/label.h>

namespace heckbert::record {

namespace {

/// The kinds of a word's ends, where its text does not tell them, are those of the header.
taxonomy::Word word_of(std::string_view text, const PathStreamHeader& header) {
  taxonomy::Word word = taxonomy::parse_word(text);
  for (std::size_t at = 0; at < text.size(); ++at) {
    while (at < text.size() && text[at] == '\'') at += taxonomy::read_label(text, at)->length;
    if (at + 1 < text.size() && taxonomy::is_lower(text[at + 1])) continue;
    if (text.substr(at, 1) == "L") word.light = header.light;
    if (text.substr(at, 1) == "E" || text.substr(at, 1) == "C") word.eye = header.eye;
  }
  return word;
}

// Text: "X Y WORD R G B COUNT".

class TextRows {
 public:
  TextRows(StreamLines& lines, const PathStreamHeader& header, PathRows& rows)
      : lines_(lines), header_(header), rows_(rows) {}

  void read() {
    while (lines_.next()) {
      if (lines_.text() == "end") return lines_.check();
      read_line();
    }
    lines_.refuse(0, 1, "the stream is torn: it stops without the line 'end'");
    lines_.check();
  }

 private:
  void read_line() {
    const std::vector<StreamField> fields = fields_of(lines_.text());
    if (fields.size() != 7) return lines_.refuse(0, lines_.text().size(), "expected 'X Y WORD R G B COUNT'");
    const Window& window = header_.info.window;
    const auto x = whole(fields[0], window.x0, window.x1 - 1, "a column of the rendered pixels");
    const auto y = whole(fields[1], window.y0, window.y1 - 1, "a row of the rendered pixels");
    const auto word = number_of_word(fields[2]);
    const auto r = real(fields[3]), g = real(fields[4]), b = real(fields[5]);
    const auto count = whole(fields[6], 1, std::numeric_limits<std::int32_t>::max(), "the number of paths");
    if (x && y && word && r && g && b && count)
      rows_.add(*x, *y, *word, {*r, *g, *b}, static_cast<std::uint32_t>(*count));
  }

  std::optional<int> whole(StreamField field, int low, int high, std::string_view what) {
    int value = 0;
    if (parse(field.text, value) && value >= low && value <= high) return value;
    lines_.refuse(field.offset, field.text.size(), fmt::format("expected {}, {} to {}", what, low, high));
    return {};
  }

  std::optional<float> real(StreamField field) {
    float value = 0;
    if (parse(field.text, value)) return value;
    lines_.refuse(field.offset, field.text.size(), "expected a number");
    return {};
  }

  template <class T>
  static bool parse(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
  }

  std::optional<PathRows::WordId> number_of_word(StreamField field) {
    const auto known = words_.find(std::string(field.text));
    if (known != words_.end()) return known->second;
    try {
      return words_[std::string(field.text)] = rows_.word(word_of(field.text, header_));
    } catch (const InputError& error) {
      lines_.refuse(field.offset, error);
      return {};
    }
  }

  StreamLines& lines_;
  const PathStreamHeader& header_;
  PathRows& rows_;
  std::unordered_map<std::string, PathRows::WordId> words_;  // by their text
};

// Binary, everything little-endian. A row is seven times four bytes; two values that no column has say that it is
// something else: a word, which gets the next number, or the end.

static_assert(std::endian::native == std::endian::little, "binary streams are read as they lie in memory");

constexpr std::uint32_t kWordFollows = 0xffffffffu, kEndOfStream = 0xfffffffeu;

class BinaryRows {
 public:
  BinaryRows(std::istream& stream, std::uint64_t offset, const std::string& source, const PathStreamHeader& header,
             PathRows& rows)
      : stream_(stream), offset_(offset), source_(source), header_(header), rows_(rows) {}

  void read() {
    for (;;) {
      const auto first = next<std::uint32_t>();
      if (first == kEndOfStream) return;
      if (first == kWordFollows)
        read_word();
      else
        read_row(first);
    }
  }

 private:
  template <class T>
  T next() {
    T value{};
    next_bytes(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  }

  void next_bytes(char* bytes, std::size_t size) {
    if (!stream_.read(bytes, static_cast<std::streamsize>(size)))
      fail(offset_, "the stream is torn: it stops here without its end mark");
    offset_ += size;
  }

  [[noreturn]] void fail(std::uint64_t offset, const std::string& reason) const {
    throw ReadError(fmt::format("cannot read '{}': byte {}: {}", source_, offset, reason));
  }

  void read_word() {
    constexpr std::uint32_t kLongest = 1 << 20;
    const std::uint64_t at = offset_;
    const auto length = next<std::uint32_t>();
    if (length > kLongest) fail(at, fmt::format("a word of {} bytes; expected at most {}", length, kLongest));
    std::string text(length, '\0');
    next_bytes(text.data(), text.size());
    try {
      words_.push_back(rows_.word(word_of(text, header_)));
    } catch (const InputError& error) {
      const Diagnostic& first = error.diagnostics().front();
      fail(at + sizeof length + first.column - 1, fmt::format("in the word '{}': {}", text, first.message));
    }
  }

  void read_row(std::uint32_t x) {
    const std::uint64_t at = offset_ - sizeof x;
    const auto y = next<std::uint32_t>();
    const auto word = next<std::uint32_t>();
    const auto sum = next<Rgb>();
    const auto count = next<std::uint32_t>();
    const Window& window = header_.info.window;
    check(at, "column", x, window.x0, window.x1 - 1);
    check(at + 4, "row", y, window.y0, window.y1 - 1);
    if (word >= words_.size())
      fail(at + 8,
           fmt::format("the word number {}; expected one of the {} that were told before", word, words_.size()));
    check(at + 24, "number of paths", count, 1, std::numeric_limits<std::int32_t>::max());
    rows_.add(static_cast<int>(x), static_cast<int>(y), words_[word], sum, count);
  }

  void check(std::uint64_t at, std::string_view what, std::uint32_t value, int low, int high) const {
    if (value < static_cast<std::uint32_t>(low) || value > static_cast<std::uint32_t>(high))
      fail(at, fmt::format("the {} {}; expected {} to {}", what, value, low, high));
  }

  std::istream& stream_;
  std::uint64_t offset_;  // of the byte that comes next
  const std::string& source_;
  const PathStreamHeader& header_;
  PathRows& rows_;
  std::vector<PathRows::WordId> words_;
};

}  // namespace

Record read_path_stream(std::istream& stream, const std::string& source) {
  StreamLines lines(stream, source);
  const PathStreamHeader header = read_path_stream_header(lines);
  PathRows rows(header.info.window);
  if (header.encoding == PathStreamEncoding::Text)
    TextRows(lines, header, rows).read();
  else
    BinaryRows(stream, lines.bytes(), source, header, rows).read();
  return rows.record(header.info);
}

}  // namespace heckbert::record
