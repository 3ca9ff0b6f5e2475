#pragma once
// What one letter of an expression stands for: symbols, each with any label, or with or without certain ones. There are
// infinitely many labels and an expression names a few, so a set says what it holds of each label that it singles out
// and, once, what it holds of all others; having no label at all is one of those others unless '' is singled out.

#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

class LetterSet {
 public:
  /// What the set holds of one label.
  struct OfLabel {
    std::string label;
    SymbolSet symbols = 0;
    bool operator==(const OfLabel&) const = default;
  };

  LetterSet() = default;
  LetterSet(SymbolSet symbols) : others_(symbols) {}  // implicit: a set of symbols with any label or none

  /// These symbols with exactly this label; eyes, which have none, are left out.
  static LetterSet labelled(SymbolSet symbols, std::string_view label);

  SymbolSet of(std::string_view label) const;                           ///< the symbols that are in with this label
  SymbolSet others() const { return others_; }                          ///< with any label that is not singled out
  const std::vector<OfLabel>& of_labels() const { return of_labels_; }  ///< sorted, only what differs from others()

  void set(std::string_view label, SymbolSet symbols);  ///< holds just these of the label; eyes are left out

  SymbolSet symbols() const;  ///< those that are in with some label
  bool is_empty() const { return others_ == 0 && of_labels_.empty(); }
  bool operator==(const LetterSet&) const = default;

  LetterSet& operator|=(const LetterSet& other);
  LetterSet& operator&=(const LetterSet& other) { return *this = *this & other; }
  friend LetterSet operator|(const LetterSet& a, const LetterSet& b);
  friend LetterSet operator&(const LetterSet& a, const LetterSet& b);
  friend LetterSet operator-(const LetterSet& a, const LetterSet& b);

 private:
  SymbolSet others_ = 0;
  std::vector<OfLabel> of_labels_;
};

/// The set as an expression writes it: "S", "[DV]", "D'lamp'", "[^'lamp']", "([^S'lamp']|[S'key'])". Not empty.
std::string write(const LetterSet& set);

/// For people: "D, Sr or E"; a set with labels as an expression writes it.
std::string describe(const LetterSet& set);

}  // namespace heckbert::taxonomy
