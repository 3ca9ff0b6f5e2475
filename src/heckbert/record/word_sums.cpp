#include <heckbert/record/word_sums.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>
#include <stdexcept>

namespace heckbert::record {

namespace {

void require(bool holds, const char* claim) {
  if (!holds) throw std::logic_error(claim);
}

/// Adds to the sums of one word, sorted by batch.
void add_to(std::vector<BatchSum>& sums, const BatchSum& more) {
  const auto place = std::lower_bound(sums.begin(), sums.end(), more.batch,
                                      [](const BatchSum& sum, std::uint32_t batch) { return sum.batch < batch; });
  if (place == sums.end() || place->batch != more.batch) {
    sums.insert(place, more);
  } else {
    place->count += more.count;
    place->sum += more.sum;
  }
}

bool is_inside(const Window& inner, const Window& outer) {
  return outer.x0 <= inner.x0 && inner.x0 < inner.x1 && inner.x1 <= outer.x1 &&  //
         outer.y0 <= inner.y0 && inner.y0 < inner.y1 && inner.y1 <= outer.y1;
}

}  // namespace

WordSums::WordSums(const std::optional<FoldRule>& rule) {
  if (rule) folded_.emplace(Folded{.rule = *rule, .classifier = taxonomy::Classifier(rule->exact)});
}

WordSums::Number WordSums::new_number() {
  batches_.emplace_back();
  return static_cast<Number>(batches_.size() - 1);
}

WordSums::Number WordSums::number_of(const taxonomy::Word& word) {
  if (folded_ && word.length() > folded_->longest) return class_of(word);
  const auto [place, is_new] = numbers_.try_emplace(word);
  if (is_new) place->second = new_number();
  return place->second;
}

WordSums::Number WordSums::class_of(const taxonomy::Word& word) {
  const auto [place, is_new] = folded_->classes.try_emplace(folded_->classifier.classify(word));
  Class& found = place->second;
  if (is_new) found.number = new_number();
  if (is_new || word < found.first) found.first = word;
  return found.number;
}

/// Until the words are few enough. How many of each length there are does not depend on the order in which they come,
/// and so the length at which this ends does not.
void WordSums::fold_longest() {
  while (numbers_.size() > folded_->rule.most_words && numbers_.rbegin()->first.length() > 0) {
    folded_->longest = numbers_.rbegin()->first.length() - 1;
    while (!numbers_.empty() && numbers_.rbegin()->first.length() > folded_->longest) {
      const auto last = std::prev(numbers_.end());
      const Number to = class_of(last->first), from = last->second;
      for (const BatchSum& sum : std::exchange(batches_[from], {})) add_to(batches_[to], sum);
      folded_->moved.emplace_back(from, to);
      numbers_.erase(last);
    }
  }
}

std::vector<std::uint32_t> WordSums::add(const Tile& tile) {
  tally_ += tile.tally;
  std::vector<std::uint32_t> numbers;
  numbers.reserve(tile.words.size());
  for (const taxonomy::Word& word : tile.words) numbers.push_back(number_of(word));
  for (const BatchSum& sum : tile.batch_sums) add_to(batches_[numbers[sum.word]], sum);
  if (folded_) fold_longest();
  return numbers;
}

std::vector<std::pair<const taxonomy::Word*, WordSums::Number>> WordSums::sorted() const {
  std::vector<std::pair<const taxonomy::Word*, Number>> words;
  for (const auto& [word, number] : numbers_) words.emplace_back(&word, number);
  if (!folded_) return words;
  for (const auto& [languages, found] : folded_->classes) words.emplace_back(&found.first, found.number);
  std::sort(words.begin() + static_cast<std::ptrdiff_t>(numbers_.size()), words.end(),
            [](const auto& a, const auto& b) { return *a.first < *b.first; });
  return words;
}

Tile WordSums::tile() const {
  Tile tile;
  tile.tally = tally_;
  for (const auto& [word, number] : sorted()) {
    for (BatchSum sum : batches_[number]) {
      sum.word = static_cast<std::uint32_t>(tile.words.size());
      tile.batch_sums.push_back(sum);
    }
    tile.words.push_back(*word);
  }
  return tile;
}

std::vector<std::uint32_t> WordSums::ranks() const {
  std::vector<std::uint32_t> ranks(batches_.size());
  std::uint32_t rank = 0;
  for (const Number number : numbers()) ranks[number] = rank++;
  if (folded_)
    for (const auto& [from, to] : folded_->moved) ranks[from] = ranks[to];
  return ranks;
}

std::vector<std::uint32_t> WordSums::numbers() const {
  std::vector<Number> numbers;
  for (const auto& [word, number] : sorted()) numbers.push_back(number);
  return numbers;
}

std::optional<Folding> WordSums::folding() const {
  if (!is_folded()) return {};
  return Folding{static_cast<int>(folded_->longest), numbers_.size(), folded_->rule.exact};
}

Record means_of_words(const RenderInfo& info, const Tile& totals) {
  Record record;
  record.info = info;
  record.tally = totals.tally;
  record.words = totals.words;
  record.counts.resize(totals.words.size());
  record.batch_means.resize(totals.words.size() * kBatches);
  const auto sizes = batch_sizes(info);
  const auto pixels = static_cast<double>(info.window.pixel_count());
  for (const BatchSum& batch : totals.batch_sums) {
    record.counts[batch.word] += batch.count;
    record.batch_means[batch.word * std::size_t{kBatches} + batch.batch] =
        mean_of(batch.sum, sizes[batch.batch] * pixels);
  }
  return record;
}

void check_tile(const Tile& tile, const Window& window) {
  require(is_inside(tile.window, window), "a tile lies inside the picture's window");
  require(tile.offsets.size() == tile.window.pixel_count() + 1 && tile.offsets.back() == tile.entries.size() &&
              tile.samples.size() == tile.window.pixel_count(),
          "a tile's lists fit its window");
  require(std::is_sorted(tile.words.begin(), tile.words.end()), "a tile's words are sorted");
}

std::vector<std::vector<std::size_t>> windows_by_row(const std::vector<Window>& windows, const Window& window) {
  std::vector<std::size_t> order(windows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return windows[a].x0 < windows[b].x0; });
  std::vector<std::vector<std::size_t>> rows(static_cast<std::size_t>(window.height()));
  for (const std::size_t i : order)
    for (int y = windows[i].y0; y < windows[i].y1; ++y) {
      std::vector<std::size_t>& row = rows[static_cast<std::size_t>(y - window.y0)];
      require(row.empty() || windows[row.back()].x1 <= windows[i].x0, "tiles do not overlap");
      row.push_back(i);
    }
  return rows;
}

}  // namespace heckbert::record
