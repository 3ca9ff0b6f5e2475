#pragma once
// What tiles say of the whole picture: its words, their counts and their sums by batch. Tiles come in any order; words
// are numbered as they come, and sorted at the end. Private to the layer.

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <heckbert/record/folding.h>
#include <heckbert/record/recorder.h>
#include <heckbert/taxonomy/classifier.h>

namespace heckbert::record {

class WordSums {
 public:
  WordSums() = default;
  /// Words are folded when there are more than the rule allows. Errors: LimitError, see Classifier.
  explicit WordSums(const std::optional<FoldRule>& rule);

  /// Adds the tile's batches and tally; gives the number of each of its words, or of its class.
  std::vector<std::uint32_t> add(const Tile& tile);
  /// A tile with all but its pixels. Words are sorted, none dropped; behind them come classes, each as its first word.
  Tile tile() const;
  /// By number of a word: its place in tile(), or that of its class.
  std::vector<std::uint32_t> ranks() const;
  /// By place in tile(): the number.
  std::vector<std::uint32_t> numbers() const;
  bool is_folded() const { return folded_ && !folded_->classes.empty(); }
  std::optional<Folding> folding() const;

 private:
  using Number = std::uint32_t;
  struct Class {
    Number number = 0;
    taxonomy::Word first;  ///< of its words
  };
  struct Folded {
    FoldRule rule;
    taxonomy::Classifier classifier;  ///< of the rule's languages
    std::size_t longest = std::numeric_limits<std::size_t>::max();
    std::map<taxonomy::Membership, Class> classes{};
    std::vector<std::pair<Number, Number>> moved{};  ///< words that had a number first, and that of their class
  };

  Number new_number();
  Number number_of(const taxonomy::Word& word);
  Number class_of(const taxonomy::Word& word);
  void fold_longest();
  /// All words and then the first of each class, sorted.
  std::vector<std::pair<const taxonomy::Word*, Number>> sorted() const;

  std::map<taxonomy::Word, Number> numbers_;    ///< shorter words come first
  std::vector<std::vector<BatchSum>> batches_;  ///< by number, sorted by batch
  Tally tally_;
  std::optional<Folded> folded_;
};

/// The means of totals: a record without pixels. Takes: a tile of the whole window; its offsets and entries are not
/// looked at.
Record means_of_words(const RenderInfo& info, const Tile& totals);

/// Throws std::logic_error unless the tile lies inside the window and its lists fit one another.
void check_tile(const Tile& tile, const Window& window);

/// By row of the window: the places in `windows` of those that cross it, from left to right.
/// Errors: std::logic_error when two overlap.
std::vector<std::vector<std::size_t>> windows_by_row(const std::vector<Window>& windows, const Window& window);

}  // namespace heckbert::record
