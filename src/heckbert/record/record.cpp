#include <heckbert/record/record.h>

#include <algorithm>
#include <cassert>

namespace heckbert::record {

namespace {

std::size_t pixel_index(const Window& window, int x, int y) {
  assert(x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1);
  return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
         static_cast<std::size_t>(x - window.x0);
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  for (const TallyFacts& facts : kTallyFields) this->*facts.field += other.*facts.field;
  for (const TallySumFacts& facts : kTallySums) this->*facts.field += other.*facts.field;
  return *this;
}

int batch_count(int samples_per_pixel) {
  return std::min(kBatches, samples_per_pixel);
}

int batch_of(int sample, int samples_per_pixel) {
  assert(sample >= 0 && sample < samples_per_pixel);
  return static_cast<int>(static_cast<std::int64_t>(sample) * batch_count(samples_per_pixel) / samples_per_pixel);
}

int first_of_batch(int batch, int samples_per_pixel) {
  // The first sample s with floor(s * batches / samples) == batch.
  const std::int64_t batches = batch_count(samples_per_pixel);
  return static_cast<int>((static_cast<std::int64_t>(batch) * samples_per_pixel + batches - 1) / batches);
}

std::array<int, kBatches> batch_sizes(int samples_per_pixel) {
  std::array<int, kBatches> sizes{};
  for (int b = 0; b < batch_count(samples_per_pixel); ++b)
    sizes[static_cast<std::size_t>(b)] =
        first_of_batch(b + 1, samples_per_pixel) - first_of_batch(b, samples_per_pixel);
  return sizes;
}

std::span<const Entry> Record::pixel(int x, int y) const {
  const std::size_t i = pixel_index(info.window, x, y);
  return std::span(entries).subspan(offsets[i], offsets[i + 1] - offsets[i]);
}

Rgb Image::at(int x, int y) const {
  return pixels[pixel_index(window, x, y)];
}

std::vector<bool> members(const Record& record, const taxonomy::Language& language, taxonomy::GlossyRule rule) {
  const taxonomy::Language finest = taxonomy::apply(rule, language);
  std::vector<bool> chosen(record.words.size());
  for (std::size_t w = 0; w < chosen.size(); ++w) chosen[w] = finest.contains(record.words[w]);
  return chosen;
}

Image beauty(const Record& record) {
  return image_of(record, std::vector<bool>(record.words.size(), true));
}

Image image_of(const Record& record, const std::vector<bool>& chosen) {
  assert(chosen.size() == record.words.size());
  Image image{record.info.window, std::vector<Rgb>(record.info.window.pixel_count())};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    double r = 0, g = 0, b = 0;
    for (std::size_t e = record.offsets[i]; e < record.offsets[i + 1]; ++e) {
      const Entry& entry = record.entries[e];
      if (!chosen[entry.word]) continue;
      r += static_cast<double>(entry.energy.r);
      g += static_cast<double>(entry.energy.g);
      b += static_cast<double>(entry.energy.b);
    }
    image.pixels[i] = {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
  }
  return image;
}

}  // namespace heckbert::record
