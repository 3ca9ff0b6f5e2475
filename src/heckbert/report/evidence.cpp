#include <heckbert/report/evidence.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace heckbert::report {

Series& Series::operator+=(const Series& other) {
  for (std::size_t batch = 0; batch < values.size(); ++batch) values[batch] += other.values[batch];
  count += other.count;
  return *this;
}

std::vector<record::Window> blocks_of(const record::Window& window) {
  std::vector<record::Window> blocks;
  for (int y = window.y0; y < window.y1; y += kBlockSize)
    for (int x = window.x0; x < window.x1; x += kBlockSize)
      blocks.push_back({x, y, std::min(x + kBlockSize, window.x1), std::min(y + kBlockSize, window.y1)});
  return blocks;
}

void Evidence::add(const record::Record& batch, std::span<const taxonomy::Language> languages) {
  if (batches_ > 0 && batch.info.window != window_)
    throw std::invalid_argument("the batches are of different pictures");
  if (!has_blocks_) throw std::invalid_argument("the batches of a record are all there is");
  if (batches_ == record::kBatches) throw std::invalid_argument("there are as many batches as can be");
  window_ = batch.info.window;
  const auto number = static_cast<std::size_t>(batches_);
  const std::vector<record::Window> blocks = blocks_of(window_);
  const auto blocks_across = static_cast<std::size_t>((window_.width() + kBlockSize - 1) / kBlockSize);
  std::vector<WordEvidence*> by_word;
  for (const taxonomy::Word& word : batch.words) by_word.push_back(&words_[word]);

  std::size_t pixel = 0;
  for (int y = window_.y0; y < window_.y1; ++y)
    for (int x = window_.x0; x < window_.x1; ++x, ++pixel) {
      const std::size_t block = static_cast<std::size_t>((y - window_.y0) / kBlockSize) * blocks_across +
                                static_cast<std::size_t>((x - window_.x0) / kBlockSize);
      for (std::size_t e = batch.offsets[pixel]; e < batch.offsets[pixel + 1]; ++e) {
        const record::Entry& entry = batch.entries[e];
        WordEvidence& word = *by_word[entry.word];
        const auto light = static_cast<double>(luminance(entry.energy));
        word.picture.values[number] += light;
        word.picture.count += entry.count;
        Series& of_block = word.blocks[block];
        of_block.values[number] += light;
        of_block.count += entry.count;
        if (light > word.brightest.luminance) word.brightest = {x, y, light};
      }
    }
  for (WordEvidence* word : by_word) {
    word->picture.values[number] /= static_cast<double>(window_.pixel_count());
    for (auto& [block, series] : word->blocks)
      series.values[number] /= static_cast<double>(blocks[block].pixel_count());
  }
  add_images(batch, languages);
  samples_per_pixel_ += batch.info.samples_per_pixel;
  weights_.samples_per_pixel = ++batches_;  // one each
}

void Evidence::take_batches_of(const record::Record& record, std::span<const taxonomy::Language> languages) {
  if (batches_ > 0) throw std::invalid_argument("a record with batches must be the first and only one");
  window_ = record.info.window;
  batches_ = record::batches_in_use(record.info);
  // An adaptive render repeats the samples that its header tells of. What was imported tells nothing else.
  const double taken = static_cast<double>(record.tally.samples) / static_cast<double>(window_.pixel_count());
  samples_per_pixel_ = taken > 0 ? taken : record.info.samples_per_pixel;
  weights_ = record.info;
  has_blocks_ = false;
  for (std::size_t w = 0; w < record.words.size(); ++w) {
    WordEvidence& word = words_[record.words[w]];
    word.picture.count = record.counts[w];
    for (std::size_t b = 0; b < record::kBatches; ++b)
      word.picture.values[b] = static_cast<double>(luminance(record.batch_means[w * record::kBatches + b]));
  }
  std::size_t pixel = 0;
  for (int y = window_.y0; y < window_.y1; ++y)
    for (int x = window_.x0; x < window_.x1; ++x, ++pixel)
      for (std::size_t e = record.offsets[pixel]; e < record.offsets[pixel + 1]; ++e) {
        BrightPixel& brightest = words_[record.words[record.entries[e].word]].brightest;
        const auto light = static_cast<double>(luminance(record.entries[e].energy));
        if (light > brightest.luminance) brightest = {x, y, light};
      }
  add_images(record, languages);
}

void Evidence::add_images(const record::Record& batch, std::span<const taxonomy::Language> languages) {
  if (languages.empty()) return;
  ++image_batches_;
  images_.resize(languages.size());
  const std::vector<record::Image> images = record::images_of(batch, record::members(batch, languages));
  for (std::size_t i = 0; i < images.size(); ++i) {
    Pixels& pixels = images_[i];
    pixels.sum.resize(images[i].pixels.size());
    pixels.luminance.resize(pixels.sum.size());
    pixels.squares.resize(pixels.sum.size());
    for (std::size_t p = 0; p < pixels.sum.size(); ++p) {
      const auto light = static_cast<double>(luminance(images[i].pixels[p]));
      pixels.sum[p] += images[i].pixels[p];
      pixels.luminance[p] += light;
      pixels.squares[p] += light * light;
    }
  }
}

double Evidence::contribution_if_none() const {
  double all = 0, once = 0;
  std::uint64_t count = 0, found_once = 0;
  for (const auto& [word, evidence] : words_) {
    double energy = 0;
    for (const double value : evidence.picture.values) energy += value / batches_;
    all += energy;
    count += evidence.picture.count;
    if (evidence.picture.count != 1) continue;
    once += energy;
    ++found_once;
  }
  const double of_all = count > 0 ? all / static_cast<double>(count) : 0;
  return found_once > 0 ? std::max(once / static_cast<double>(found_once), of_all) : of_all;
}

NoisyImage Evidence::image(std::size_t language) const {
  const Pixels& pixels = images_.at(language);
  NoisyImage image{{window_, pixels.sum}, std::vector<double>(pixels.sum.size())};
  const double n = image_batches_;
  for (Rgb& pixel : image.mean.pixels) pixel *= static_cast<float>(1 / n);
  if (image_batches_ > 1)
    for (std::size_t p = 0; p < pixels.sum.size(); ++p) {
      const double mean = pixels.luminance[p] / n;
      image.standard_error[p] = std::sqrt(std::max(pixels.squares[p] / n - mean * mean, 0.0) / (n - 1));
    }
  return image;
}

}  // namespace heckbert::report
