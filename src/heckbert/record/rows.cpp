#include <heckbert/record/rows.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace heckbert::record {

PixelRow pixel_row(const Window& window, std::span<const std::size_t> offsets, std::size_t row) {
  const auto width = static_cast<std::size_t>(window.width());
  return {.y = window.y0 + static_cast<int>(row),
          .first_pixel = row * width,
          .offsets = offsets.subspan(row * width, width + 1),
          .entries = {}};
}

Rows rows_of(const Record& record) {
  return [&record](const RowVisitor& visit) {
    for (std::size_t row = 0; row < static_cast<std::size_t>(record.info.window.height()); ++row) {
      PixelRow pixels = pixel_row(record.info.window, record.offsets, row);
      const std::size_t first = pixels.offsets.front(), last = pixels.offsets.back();
      pixels.entries = std::span(record.entries).subspan(first, last - first);
      visit(pixels);
    }
  };
}

std::vector<Image> images_of(const Record& totals, const Rows& rows, const std::vector<std::vector<bool>>& sets) {
  std::vector<std::vector<std::uint32_t>> sets_of(totals.words.size());
  for (std::uint32_t set = 0; set < sets.size(); ++set)
    for (std::size_t w = 0; w < totals.words.size(); ++w)
      if (sets[set][w]) sets_of[w].push_back(set);
  const Window& window = totals.info.window;
  std::vector<Image> images(sets.size(), {window, std::vector<Rgb>(window.pixel_count())});
  rows([&](const PixelRow& row) {
    std::vector<std::array<double, 3>> sums(sets.size());
    for (std::size_t i = 0; i < row.pixel_count(); ++i) {
      std::fill(sums.begin(), sums.end(), std::array<double, 3>{});
      for (const Entry& entry : row.pixel(i)) {
        const double r = static_cast<double>(entry.energy.r), g = static_cast<double>(entry.energy.g),
                     b = static_cast<double>(entry.energy.b);
        for (const std::uint32_t set : sets_of[entry.word]) {
          sums[set][0] += r;
          sums[set][1] += g;
          sums[set][2] += b;
        }
      }
      for (std::size_t set = 0; set < sets.size(); ++set)
        images[set].pixels[row.first_pixel + i] = {static_cast<float>(sums[set][0]), static_cast<float>(sums[set][1]),
                                                   static_cast<float>(sums[set][2])};
    }
  });
  return images;
}

}  // namespace heckbert::record
