#include <heckbert/report/contact_sheet.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include <heckbert/report/caption.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/text_table.h>

namespace heckbert::report {
namespace {

constexpr Colour kPaper{24, 25, 27}, kInk{236, 236, 232}, kFaintInk{160, 162, 166};
constexpr int kMargin = 24, kGutter = 16;

Picture enlarged(const Picture& picture, int factor) {
  Picture large{picture.width * factor, picture.height * factor, {}};
  large.rgb.reserve(picture.rgb.size() * static_cast<std::size_t>(factor) * static_cast<std::size_t>(factor));
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x) {
      const auto from = picture.rgb.begin() + 3 * (std::ptrdiff_t{y / factor} * picture.width + x / factor);
      large.rgb.insert(large.rgb.end(), from, from + 3);
    }
  return large;
}

void paste(Picture& sheet, const Picture& picture, int x, int y) {
  for (int row = 0; row < picture.height; ++row)
    std::copy_n(picture.rgb.begin() + std::ptrdiff_t{3} * row * picture.width, 3 * picture.width,
                sheet.rgb.begin() + 3 * (std::ptrdiff_t{y + row} * sheet.width + x));
}

std::string interval_of(const record::Estimate& share) {
  return share.known ? " " + bracketed_percent(share) : std::string();
}

}  // namespace

Picture contact_sheet(const record::Record& record, const Coverage& coverage, const ContactSheetOptions& options) {
  const record::Image beauty = record::beauty(record);
  const float exposure = options.exposure.value_or(auto_exposure(beauty));
  const auto cell = [&](const record::Image& image) {
    const Picture small = to_srgb(shrunk(image, options.picture_width), exposure);
    return enlarged(small, std::max(1, options.picture_width / std::max(1, small.width)));
  };
  const Picture picture = cell(beauty);

  const std::size_t columns = caption_columns(picture.width);
  std::vector<std::string> lines;
  const auto add_lines = [&](const std::string& text) {
    std::istringstream wrapped(wrap(text, columns));
    for (std::string line; std::getline(wrapped, line);) lines.push_back(cut(line, columns));
  };
  for (const Fact& fact : facts(coverage.info, coverage.tally)) add_lines(fact.label + ": " + fact.value);
  add_lines("Glossy rule " + describe(coverage.glossy_rule));
  add_lines(fmt::format("Exposure: {:+.2f} stops, for every picture", std::log2(exposure)));

  const int column = picture.width + kGutter;
  const int first_height = std::max(picture.height, static_cast<int>(lines.size()) * kCaptionHeight);
  const int row_height = 2 * kCaptionHeight + picture.height + kMargin;
  Picture sheet{2 * kMargin + column + picture.width,
                2 * kMargin + first_height + kMargin + row_height * static_cast<int>(coverage.grammars.size()),
                {}};
  sheet.rgb.reserve(3 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  for (int i = 0; i < sheet.width * sheet.height; ++i) sheet.rgb.insert(sheet.rgb.end(), kPaper.begin(), kPaper.end());

  const int left = kMargin, right = kMargin + column;
  const auto write = [&](int x, int y, const std::string& text, int width, Colour ink) {
    draw_caption(sheet, x, y, cut(text, caption_columns(width)), ink);
  };

  int y = kMargin;
  paste(sheet, picture, left, y);
  for (std::size_t i = 0; i < lines.size(); ++i)
    write(right, y + static_cast<int>(i) * kCaptionHeight, lines[i], picture.width, i == 0 ? kInk : kFaintInk);
  y += first_height + kMargin;

  for (const GrammarCoverage& grammar : coverage.grammars) {
    std::vector<bool> missed = grammar.captured;
    missed.flip();
    write(left, y, grammar.title + "   " + grammar.expression, column + picture.width, kInk);
    y += kCaptionHeight;
    write(left, y, "captured " + percent(grammar.share.mean) + interval_of(grammar.share), picture.width, kFaintInk);
    write(right, y, "missed " + percent(missed_share(coverage, grammar)), picture.width, kFaintInk);
    y += kCaptionHeight;
    paste(sheet, cell(image_of(record, grammar.captured)), left, y);
    paste(sheet, cell(image_of(record, missed)), right, y);
    y += picture.height + kMargin;
  }
  return sheet;
}

}  // namespace heckbert::report
