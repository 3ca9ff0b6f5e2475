#include <heckbert/record/tile_pictures.h>

#include <algorithm>
#include <utility>

namespace heckbert::record {

namespace {

std::vector<taxonomy::Language> applied(taxonomy::GlossyRule rule, std::span<const taxonomy::Language> languages) {
  std::vector<taxonomy::Language> finest;
  finest.reserve(languages.size());
  for (const taxonomy::Language& language : languages) finest.push_back(taxonomy::apply(rule, language));
  return finest;
}

void paste(const Image& part, Image& whole) {
  const auto width = static_cast<std::size_t>(part.window.width());
  for (int y = part.window.y0; y < part.window.y1; ++y) {
    const auto from = static_cast<std::size_t>(y - part.window.y0) * width;
    const auto to = static_cast<std::size_t>(y - whole.window.y0) * static_cast<std::size_t>(whole.window.width()) +
                    static_cast<std::size_t>(part.window.x0 - whole.window.x0);
    std::copy_n(&part.pixels[from], width, &whole.pixels[to]);
  }
}

}  // namespace

TilePictures::TilePictures(RenderInfo info, std::span<const taxonomy::Language> classes, taxonomy::GlossyRule rule)
    : info_(std::move(info)),
      classifier_(applied(rule, classes)),
      images_(classes.size() + 1, {info_.window, std::vector<Rgb>(info_.window.pixel_count())}) {}

void TilePictures::add(const Tile& tile) {
  RenderInfo info = info_;
  info.window = tile.window;
  Assembler assembler(info);
  assembler.submit(tile);
  const Record record = assembler.finish(false);

  std::vector<std::vector<bool>> sets(images_.size(), std::vector<bool>(record.words.size()));
  sets[0].flip();
  for (std::size_t w = 0; w < record.words.size(); ++w) {
    const taxonomy::Membership membership = classifier_.classify(record.words[w]);
    for (std::size_t i = 0; i < membership.size(); ++i)
      if (membership[i]) sets[i + 1][w] = true;
  }
  const std::vector<Image> parts = images_of(record, sets);
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < parts.size(); ++i) paste(parts[i], images_[i]);
}

}  // namespace heckbert::record
