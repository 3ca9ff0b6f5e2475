#include <heckbert/record/record.h>

#include <algorithm>
#include <cassert>
#include <unordered_map>
#include <utility>

#include <heckbert/record/rows.h>
#include <heckbert/taxonomy/classifier.h>

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

std::vector<SampleRange> samples_of(const RenderInfo& info) {
  if (!info.parts.empty()) return info.parts;
  return {{info.seed, info.samples_per_pixel, 0, info.samples_per_pixel}};
}

void set_samples(RenderInfo& info, const std::vector<SampleRange>& ranges) {
  assert(!ranges.empty());
  info.seed = ranges.front().seed;
  info.samples_per_pixel = 0;
  for (const SampleRange& range : ranges) info.samples_per_pixel += range.count();
  const bool is_whole = ranges.size() == 1 && ranges.front().count() == ranges.front().of;
  info.parts = is_whole ? std::vector<SampleRange>{} : ranges;
}

std::array<int, kBatches> batch_sizes(const RenderInfo& info) {
  if (!info.has_batches) return {info.samples_per_pixel};
  std::array<int, kBatches> sizes{};
  for (const SampleRange& range : samples_of(info))
    for (int b = 0; b < batch_count(range.of); ++b)
      sizes[static_cast<std::size_t>(b)] += std::max(0, std::min(range.last, first_of_batch(b + 1, range.of)) -
                                                            std::max(range.first, first_of_batch(b, range.of)));
  return sizes;
}

int batches_in_use(const RenderInfo& info) {
  return static_cast<int>(std::ranges::count_if(batch_sizes(info), [](int size) { return size > 0; }));
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

Outcomes outcomes(const Record& record, std::span<const taxonomy::Language> languages, taxonomy::GlossyRule rule) {
  std::vector<taxonomy::Language> finest;
  for (const taxonomy::Language& language : languages) finest.push_back(taxonomy::apply(rule, language));
  const taxonomy::Classifier classifier(finest);
  Outcomes result;
  result.of_word.reserve(record.words.size());
  std::unordered_map<taxonomy::Membership, std::uint32_t> known;
  for (const taxonomy::Word& word : record.words) {
    const auto [outcome, is_new] =
        known.try_emplace(classifier.classify(word), static_cast<std::uint32_t>(result.members.size()));
    if (is_new) result.members.push_back(outcome->first);
    result.of_word.push_back(outcome->second);
  }
  return result;
}

std::vector<std::vector<bool>> sets_of(const Outcomes& outcomes, std::size_t languages) {
  std::vector<std::vector<std::size_t>> languages_of;  // by outcome
  for (const std::vector<bool>& members : outcomes.members) {
    std::vector<std::size_t>& these = languages_of.emplace_back();
    for (std::size_t i = 0; i < languages; ++i)
      if (members[i]) these.push_back(i);
  }
  std::vector<std::vector<bool>> sets(languages, std::vector<bool>(outcomes.of_word.size()));
  for (std::size_t w = 0; w < outcomes.of_word.size(); ++w)
    for (const std::size_t i : languages_of[outcomes.of_word[w]]) sets[i][w] = true;
  return sets;
}

std::vector<std::vector<bool>> members(const Record& record, std::span<const taxonomy::Language> languages,
                                       taxonomy::GlossyRule rule) {
  return sets_of(outcomes(record, languages, rule), languages.size());
}

Image beauty(const Record& record) {
  return image_of(record, std::vector<bool>(record.words.size(), true));
}

std::vector<Image> images_of(const Record& record, const std::vector<std::vector<bool>>& sets) {
  return images_of(record, rows_of(record), sets);
}

Image image_of(const Record& record, const std::vector<bool>& chosen) {
  return std::move(images_of(record, {chosen}).front());
}

}  // namespace heckbert::record
