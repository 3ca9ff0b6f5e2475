#include <heckbert/taxonomy/alphabet.h>

#include <algorithm>
#include <iterator>

#include <heckbert/taxonomy/label.h>

namespace heckbert::taxonomy {

std::size_t Alphabet::class_of(std::string_view label) const {
  const auto at = std::lower_bound(labels.begin(), labels.end(), label);
  return at != labels.end() && *at == label ? static_cast<std::size_t>(at - labels.begin()) + 1 : 0;
}

Letter Alphabet::letter(std::size_t column) const {
  const std::size_t label_class = class_of_column(column);
  if (label_class > 0) return {symbol(column), labels[label_class - 1]};
  if (!may_be_labelled(symbol(column)) || class_of(kUnlabelled) == 0) return {symbol(column), {}};
  std::string made_up = "other";
  for (int i = 2; class_of(made_up) != 0; ++i) made_up = "other " + std::to_string(i);
  return {symbol(column), made_up};
}

LetterSet Alphabet::letters(const std::vector<std::size_t>& columns) const {
  std::vector<SymbolSet> of_class(class_count(), 0);
  for (const std::size_t c : columns) of_class[class_of_column(c)] |= single(symbol(c));
  LetterSet set(of_class[0]);
  for (std::size_t i = 0; i < labels.size(); ++i) set.set(labels[i], of_class[i + 1]);
  return set;
}

Alphabet joined(const Alphabet& a, const Alphabet& b) {
  Alphabet all;
  std::set_union(a.labels.begin(), a.labels.end(), b.labels.begin(), b.labels.end(), std::back_inserter(all.labels));
  return all;
}

std::vector<std::size_t> columns_within(const Alphabet& smaller, const Alphabet& larger) {
  std::vector<std::size_t> columns;
  columns.reserve(larger.size());
  for (std::size_t c = 0; c < larger.size(); ++c) {
    const std::size_t label_class = Alphabet::class_of_column(c);
    const std::size_t within = label_class == 0 ? 0 : smaller.class_of(larger.labels[label_class - 1]);
    columns.push_back(Alphabet::column(Alphabet::symbol(c), within));
  }
  return columns;
}

}  // namespace heckbert::taxonomy
