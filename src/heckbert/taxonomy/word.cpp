#include <heckbert/taxonomy/word.h>

#include <algorithm>
#include <cassert>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/error_codes.h>
#include <heckbert/taxonomy/label.h>
#include <heckbert/taxonomy/symbol_set.h>
#include <heckbert/taxonomy/utf8.h>

namespace heckbert::taxonomy {

namespace {

constexpr std::string_view kSource = "word";

std::string subscripts_of(char letter) {
  std::string list;
  for (const SymbolFacts& f : kSymbols)
    if (f.letter == letter && f.subscript != 0) list += (list.empty() ? "" : ", ") + name(f.symbol);
  return list;
}

struct PlacedLetter {
  Letter letter;
  std::size_t offset;
  std::size_t length;
};

class WordReader {
 public:
  explicit WordReader(std::string_view text) : text_(text) {}

  Word read() {
    std::vector<PlacedLetter> letters = read_letters();
    if (letters.empty() && errors_.empty()) report(ErrorCode::EmptyText, 0, 1, {"word", "LDE"});
    if (errors_.empty()) check_ends(letters);
    if (!errors_.empty()) throw InputError(errors_);
    if (is_eye(letters.front().letter.symbol)) std::reverse(letters.begin(), letters.end());
    std::vector<Letter> spelled;
    for (PlacedLetter& placed : letters) spelled.push_back(std::move(placed.letter));
    return word_of(std::move(spelled));
  }

 private:
  void report(ErrorCode code, std::size_t offset, std::size_t length,
              std::initializer_list<std::string_view> values = {}, std::string suggestion = {}) {
    errors_.push_back(diagnose(code, kSource, text_, offset, length, values, std::move(suggestion)));
  }

  std::vector<PlacedLetter> read_letters() {
    std::vector<PlacedLetter> letters;
    for (std::size_t at = 0; at < text_.size();) {
      if (is_blank(text_[at])) {
        ++at;
        continue;
      }
      if (text_[at] == '\'' || text_[at] == '"') {
        at += add_label(letters, at);
        continue;
      }
      const bool subscripted = at + 1 < text_.size() && is_lower(text_[at + 1]);
      const char letter = text_[at] == 'C' ? 'E' : text_[at];
      const std::size_t length = subscripted ? 2 : utf8_at(text_, at).length;
      if (const auto symbol = find_symbol(letter, subscripted ? text_[at + 1] : '\0'))
        letters.push_back({{*symbol}, at, length});
      else
        report_letter(at, length);
      at += length;
    }
    return letters;
  }

  // The label at this place belongs to the letter before it. Gives its length.
  std::size_t add_label(std::vector<PlacedLetter>& letters, std::size_t at) {
    const auto read = read_label(text_, at);
    if (!read) {
      report(ErrorCode::NeverClosed, at, 1, {"the label", "another " + std::string(1, text_[at])});
      return text_.size() - at;
    }
    const bool is_behind = !letters.empty() && letters.back().offset + letters.back().length == at;
    if (!is_behind) {
      if (errors_.empty()) report(ErrorCode::LabelAlone, at, read->length);
    } else if (!may_be_labelled(letters.back().letter.symbol)) {
      report(ErrorCode::EyeLabelled, at, read->length);
    } else {
      letters.back().letter.label = read->label;
      letters.back().length += read->length;
    }
    return read->length;
  }

  void report_letter(std::size_t at, std::size_t length) {
    const std::string written = quoted(text_.substr(at, length));
    const char upper = static_cast<char>(text_[at] - 'a' + 'A');
    if (find_symbol(text_[at], 0)) {
      const std::string known = subscripts_of(text_[at]);
      report(ErrorCode::UnknownSubscript, at, length,
             {written, known.empty() ? std::string(1, text_[at]) + " without a subscript" : known});
    } else if (is_lower(text_[at]) && find_symbol(upper, 0)) {
      report(ErrorCode::SmallLetter, at, length, {written}, did_you_mean(std::string_view(&upper, 1)));
    } else if (std::string_view("XN.*+?()[]{}|").find(text_[at]) != std::string_view::npos) {
      report(ErrorCode::SeveralWords, at, length, {written});
    } else {
      report(ErrorCode::UnknownLetter, at, length, {written, "L, D, G, S, V or E"});
    }
  }

  void check_ends(const std::vector<PlacedLetter>& letters) {
    for (std::size_t i = 1; i + 1 < letters.size(); ++i)
      if (!is_event(letters[i].letter.symbol))
        report(ErrorCode::EndInside, letters[i].offset, letters[i].length, {written(letters[i])});
    const PlacedLetter &first = letters.front(), &last = letters.back();
    const bool events_at_ends = is_event(first.letter.symbol) || is_event(last.letter.symbol);
    const auto report_event = [&](const PlacedLetter& letter, std::string_view place) {
      report(ErrorCode::EventAtEnd, letter.offset, letter.length, {written(letter), place, "L or E"});
    };
    if (is_event(first.letter.symbol)) report_event(first, "beginning");
    if (is_event(last.letter.symbol)) report_event(last, "end");
    if (!events_at_ends && facts(first.letter.symbol).role == facts(last.letter.symbol).role)
      report(ErrorCode::EqualEnds, last.offset, last.length,
             {is_light(last.letter.symbol) ? "light ends (L)" : "eye ends (E)"});
  }

  std::string written(const PlacedLetter& letter) const { return quoted(text_.substr(letter.offset, letter.length)); }

  std::string_view text_;
  std::vector<Diagnostic> errors_;
};

}  // namespace

Word Word::from_eye_path(Symbol eye, const std::vector<Symbol>& events_from_eye, Symbol light) {
  assert(is_eye(eye) && is_light(light));
  return {light, {events_from_eye.rbegin(), events_from_eye.rend()}, eye};
}

std::strong_ordering Word::operator<=>(const Word& other) const {
  if (const auto by_length = events.size() <=> other.events.size(); std::is_neq(by_length)) return by_length;
  if (const auto by_light = light <=> other.light; std::is_neq(by_light)) return by_light;
  if (const auto by_events = events <=> other.events; std::is_neq(by_events)) return by_events;
  if (const auto by_eye = eye <=> other.eye; std::is_neq(by_eye)) return by_eye;
  return labels <=> other.labels;
}

void Word::set_labels(std::vector<std::string> all) {
  assert(all.size() == events.size() + 1);
  const bool is_any = std::any_of(all.begin(), all.end(), [](const std::string& l) { return !l.empty(); });
  labels = is_any ? std::move(all) : std::vector<std::string>{};
}

std::vector<Letter> letters_of(const Word& word) {
  std::vector<Letter> letters{{word.light, std::string(word.label(0))}};
  for (std::size_t i = 0; i < word.events.size(); ++i)
    letters.push_back({word.events[i], std::string(word.label(i + 1))});
  letters.push_back({word.eye});
  return letters;
}

Word word_of(std::vector<Letter> letters) {
  Word word{letters.front().symbol, {}, letters.back().symbol};
  letters.pop_back();
  for (std::size_t i = 1; i < letters.size(); ++i) word.events.push_back(letters[i].symbol);
  std::vector<std::string> labels;
  for (Letter& letter : letters) labels.push_back(std::move(letter.label));
  word.set_labels(std::move(labels));
  return word;
}

namespace {

std::string spelled(const Word& word, bool with_subscripts) {
  std::string text;
  const auto add = [&](Symbol symbol) {
    text += facts(symbol).letter;
    if (with_subscripts && facts(symbol).subscript != 0) text += facts(symbol).subscript;
  };
  const auto add_label = [&](std::string_view label) {
    if (!label.empty()) text += write_label(label);
  };
  add(word.light);
  add_label(word.label(0));
  for (std::size_t i = 0; i < word.events.size(); ++i) {
    add(word.events[i]);
    add_label(word.label(i + 1));
  }
  add(word.eye);
  return text;
}

}  // namespace

std::string plain(const Word& word) {
  return spelled(word, false);
}

std::string fine(const Word& word) {
  return spelled(word, true);
}

Word parse_word(std::string_view text) {
  return WordReader(text).read();
}

}  // namespace heckbert::taxonomy
