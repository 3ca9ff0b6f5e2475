#pragma once
// The letters that an automaton tells apart. There are infinitely many labelled letters and an automaton treats nearly
// all of them alike: it singles out a few labels, and what it does with one of the others it does with every one of
// them, unlabelled letters among them unless '' is singled out. So its alphabet is finite: the thirteen symbols once
// for the others, and the light and event symbols again for each label that is singled out. Its members are numbered;
// a number is a column of the automaton's table.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/letter.h>
#include <heckbert/taxonomy/letter_set.h>
#include <heckbert/taxonomy/symbol.h>

namespace heckbert::taxonomy {

/// Symbols that may be labelled come first in the table of symbols: lights and events.
inline constexpr std::size_t kLabelledSymbols = kSymbolCount - 2;
static_assert([] {
  for (const SymbolFacts& f : kSymbols)
    if (is_eye(f.symbol) != (index(f.symbol) >= kLabelledSymbols)) return false;
  return true;
}());

struct Alphabet {
  std::vector<std::string> labels{};  ///< those singled out, sorted, distinct

  bool operator==(const Alphabet&) const = default;

  std::size_t size() const { return kSymbolCount + kLabelledSymbols * labels.size(); }  ///< number of columns
  std::size_t class_count() const { return labels.size() + 1; }
  /// 0 for the others, i + 1 for labels[i]. O(log labels).
  std::size_t class_of(std::string_view label) const;
  /// The column of a symbol with a label of this class.
  static std::size_t column(Symbol s, std::size_t label_class) {
    const bool is_other = label_class == 0 || is_eye(s);
    return is_other ? index(s) : kSymbolCount + (label_class - 1) * kLabelledSymbols + index(s);
  }
  std::size_t column(const Letter& letter) const { return column(letter.symbol, class_of(letter.label)); }
  static Symbol symbol(std::size_t column) {
    return static_cast<Symbol>(column < kSymbolCount ? column : (column - kSymbolCount) % kLabelledSymbols);
  }
  static std::size_t class_of_column(std::size_t column) {
    return column < kSymbolCount ? 0 : 1 + (column - kSymbolCount) / kLabelledSymbols;
  }
  /// A letter of this column. For the others it has no label if that is one of them, and else a label made up for it.
  Letter letter(std::size_t column) const;
  /// All letters of these columns.
  LetterSet letters(const std::vector<std::size_t>& columns) const;
};

/// The labels that either singles out.
Alphabet joined(const Alphabet& a, const Alphabet& b);

/// For each column of the larger alphabet, the column of the smaller one that its letters belong to.
std::vector<std::size_t> columns_within(const Alphabet& smaller, const Alphabet& larger);

}  // namespace heckbert::taxonomy
