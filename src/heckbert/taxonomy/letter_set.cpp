#include <heckbert/taxonomy/letter_set.h>

#include <algorithm>

#include <heckbert/taxonomy/label.h>

namespace heckbert::taxonomy {

namespace {

std::vector<std::string> labels_of(const LetterSet& a, const LetterSet& b) {
  std::vector<std::string> labels;
  for (const LetterSet* set : {&a, &b})
    for (const LetterSet::OfLabel& one : set->of_labels()) labels.push_back(one.label);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

// Of each label, symbols, all events being ".": "D'a'S'b'.'c'".
template <class Choose>
std::string with_labels(const LetterSet& set, Choose choose) {
  std::string text;
  for (const LetterSet::OfLabel& one : set.of_labels()) {
    const SymbolSet chosen = choose(one.symbols);
    if ((chosen & kEvents) == kEvents) {
      text += "." + write_label(one.label);
      continue;
    }
    for (const std::string& n : names_of(chosen)) text += n + write_label(one.label);
  }
  return text;
}

// Whether with_labels() writes a single letter, which needs no brackets.
template <class Choose>
bool is_one_letter(const LetterSet& set, Choose choose) {
  if (set.of_labels().size() != 1) return false;
  const SymbolSet chosen = choose(set.of_labels()[0].symbols);
  return chosen == kEvents || names_of(chosen).size() == 1;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& n : names) text += n;
  return text;
}

template <class Combine>
LetterSet by_label(const LetterSet& a, const LetterSet& b, Combine combine) {
  LetterSet result(static_cast<SymbolSet>(combine(a.others(), b.others())));
  for (const std::string& label : labels_of(a, b))
    result.set(label, static_cast<SymbolSet>(combine(a.of(label), b.of(label))));
  return result;
}

}  // namespace

LetterSet LetterSet::labelled(SymbolSet symbols, std::string_view label) {
  LetterSet set;
  set.set(label, symbols);
  return set;
}

SymbolSet LetterSet::of(std::string_view label) const {
  const auto at = std::lower_bound(of_labels_.begin(), of_labels_.end(), label,
                                   [](const OfLabel& o, std::string_view l) { return o.label < l; });
  return at != of_labels_.end() && at->label == label ? at->symbols : others_;
}

SymbolSet LetterSet::symbols() const {
  SymbolSet all = others_;
  for (const OfLabel& one : of_labels_) all = static_cast<SymbolSet>(all | one.symbols);
  return all;
}

void LetterSet::set(std::string_view label, SymbolSet symbols) {
  const auto rest = static_cast<SymbolSet>(symbols & ~kEyes);
  const auto at = std::lower_bound(of_labels_.begin(), of_labels_.end(), label,
                                   [](const OfLabel& o, std::string_view l) { return o.label < l; });
  const bool is_there = at != of_labels_.end() && at->label == label;
  if (rest == (others_ & ~kEyes)) {
    if (is_there) of_labels_.erase(at);
  } else if (is_there) {
    at->symbols = rest;
  } else {
    of_labels_.insert(at, {std::string(label), rest});
  }
}

// In place, since sets of many labels are read one label at a time.
LetterSet& LetterSet::operator|=(const LetterSet& other) {
  if (other.others_ != 0) return *this = *this | other;
  for (const OfLabel& one : other.of_labels_) set(one.label, static_cast<SymbolSet>(of(one.label) | one.symbols));
  return *this;
}

LetterSet operator|(const LetterSet& a, const LetterSet& b) {
  return by_label(a, b, [](unsigned x, unsigned y) { return x | y; });
}

LetterSet operator&(const LetterSet& a, const LetterSet& b) {
  return by_label(a, b, [](unsigned x, unsigned y) { return x & y; });
}

LetterSet operator-(const LetterSet& a, const LetterSet& b) {
  return by_label(a, b, [](unsigned x, unsigned y) { return x & ~y; });
}

namespace {

// What an expression lists with '|' between: labels may be added to a set or taken away from one, never both, and only
// letters of one role can be taken away from.
std::vector<std::string> alternatives(const LetterSet& set, SymbolSet role) {
  const SymbolSet others = set.others();
  if (set.of_labels().empty()) return {write(others)};
  const auto added = [others](SymbolSet symbols) {
    // A label that has every event is written so, which says some of the others again.
    const bool is_whole = (symbols & kEvents) == kEvents && (others & kEvents) != kEvents;
    return is_whole ? symbols : static_cast<SymbolSet>(symbols & ~others);
  };
  const auto removed = [others](SymbolSet symbols) { return static_cast<SymbolSet>(others & ~symbols); };
  const std::string more = with_labels(set, added), less = with_labels(set, removed);
  if (less.empty()) {
    const std::string plain = joined(names_of(others));
    return {plain.empty() && is_one_letter(set, added) ? more : "[" + plain + more + "]"};
  }
  std::vector<std::string> result{"[^" + joined(names_of(static_cast<SymbolSet>(role & ~others))) + less + "]"};
  if (!more.empty()) result.push_back("[" + more + "]");
  return result;
}

std::vector<std::string> alternatives(const LetterSet& set) {
  std::vector<std::string> all;
  for (const SymbolSet role : {kLights, kEvents, kEyes})
    if (const LetterSet part = set & LetterSet(role); !part.is_empty())
      for (std::string& one : alternatives(part, role)) all.push_back(std::move(one));
  return all;
}

}  // namespace

std::string write(const LetterSet& set) {
  if (set.of_labels().empty()) return write(set.others());
  std::string text;
  const std::vector<std::string> all = alternatives(set);
  for (const std::string& one : all) text += (text.empty() ? "" : "|") + one;
  return all.size() == 1 ? text : "(" + text + ")";
}

std::string describe(const LetterSet& set) {
  if (set.of_labels().empty()) return describe(set.others());
  const std::vector<std::string> all = alternatives(set);
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) text += (i == 0 ? "" : i + 1 == all.size() ? " or " : ", ") + all[i];
  return text;
}

}  // namespace heckbert::taxonomy
