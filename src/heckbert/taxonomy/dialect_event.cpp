#include <heckbert/taxonomy/dialect_event.h>

#include <algorithm>
#include <utility>

#include <heckbert/taxonomy/dialect_letters.h>
#include <heckbert/taxonomy/label.h>
#include <heckbert/taxonomy/lookalikes.h>
#include <heckbert/taxonomy/utf8.h>

namespace heckbert::taxonomy {

namespace {

class EventReader {
 public:
  explicit EventReader(DialectText& text) : text_(text) {}

  Node read() {
    if (text_.peek() == '[') return brackets();
    if (text_.peek() == '<') return group();
    Node node{.kind = NodeKind::Letters, .offset = text_.at};
    node.set = at_label() ? labelled_event() : LetterSet(letter());
    node.length = text_.at - node.offset;
    return node;
  }

 private:
  // One letter of ours outside <..>; advances, also over what is wrong.
  SymbolSet letter() {
    const std::size_t begin = text_.at;
    const char c = text_.peek();
    if (c == '.') return ++text_.at, any_of(text_.dialect);
    // Two letters of a light end.
    for (const LightLetter& light : text_.dialect.lights)
      if (light.text.size() == 2 && light.text[0] == c && light.text[1] == text_.peek(1))
        return text_.at += 2, symbols_of(light);
    if (const auto kind = kind_of(text_.dialect, c)) {
      ++text_.at;
      if (*kind == 0) text_.warn(ErrorCode::StraightThrough, begin, 1);
      refuse_lobe_number();
      return *kind;
    }
    if (const auto type = type_of(text_.dialect, c)) return ++text_.at, *type;
    refuse_letter();
    return kAllSymbols;
  }

  // RenderMan's D1..D4, S1..S8.
  void refuse_lobe_number() {
    if (!is_digit(text_.peek())) return;
    text_.report(ErrorCode::NumberedLobe, text_.at - 1, 2, {}, Edit{text_.at, 1, ""},
                 "without the number it is every lobe");
    ++text_.at;
  }

  bool at_label() const { return !text_.at_end() && (text_.peek() == '\'' || text_.peek() == '"'); }

  // The label that stands here; advances, also over what is wrong.
  std::string label() {
    const std::size_t open = text_.at;
    const auto read = read_label(text_.source.document.substr(0, text_.end), text_.at);
    if (!read) {
      text_.at = text_.end;
      const std::string quote(1, text_.source.document[open]);
      text_.report(ErrorCode::NeverClosed, open, 1, {"the label", "another " + quote});
      return {};
    }
    text_.at += read->length;
    return read->label;
  }

  // Outside <..>: any event with this label.
  LetterSet labelled_event() { return LetterSet::labelled(any_of(text_.dialect), label()); }

  // Whatever stands here and is no letter of the dialect.
  void refuse_letter() {
    const char c = text_.peek();
    const std::size_t begin = text_.at;
    const Utf8Character character = utf8_at(text_.source.document.substr(0, text_.end), text_.at);
    const std::string written = quoted(text_.source.text(text_.at, character.length));
    text_.at += character.length;
    if (const Lookalike* l = find_lookalike(character.code))
      return text_.report(ErrorCode::Lookalike, begin, character.length, {l->what},
                          Edit{begin, character.length, std::string(l->meant)});
    if (c == '>' || c == ']' || c == ')' || c == '}')
      return text_.report(ErrorCode::ClosesNothing, begin, 1, {written}, Edit{begin, 1, ""});
    if (c == '|') return text_.report(ErrorCode::EmptyAlternative, begin, 1);
    if (is_repetition(c)) return text_.report(ErrorCode::NothingToRepeat, begin, 1, {written});
    if (c == '^' && text_.dialect.has_whole_operators)
      return text_.report(ErrorCode::WholeInsidePath, begin, 1, {written});
    if (c == '&' || c == '-' || c == '^' || c == '!')
      return text_.report(ErrorCode::NoOperator, begin, 1, {written},
                          text_.title() + " has no operators on whole expressions; Heckbert and V-Ray have");
    if (c == '@') {
      while (is_lower(text_.peek()) || is_digit(text_.peek()) || (text_.peek() == '-' && is_lower(text_.peek(1))))
        ++text_.at;
      return text_.report(ErrorCode::NamesUnavailable, begin, text_.at - begin, {text_.title()},
                          "Heckbert's own notation has them");
    }
    const auto foreign = [&](std::string_view why) {
      return text_.report(ErrorCode::ForeignLetter, begin, 1, {written, why});
    };
    const auto replaced = [&](const std::string& here) {
      return text_.report(ErrorCode::ForeignLetter, begin, 1, {written, text_.title() + " writes " + here},
                          Edit{begin, 1, here});
    };
    if (c == 'E') return replaced("C");
    if (c == 'A') return foreign("albedo is no light path");
    if (c == 'U' || c == 'M' || c == 'W' || c == 'K')
      return foreign("an event of one renderer only, which our words do not have");
    if (const auto here = letter_for_the_same(c)) return replaced(*here);
    text_.report(ErrorCode::UnknownLetter, begin, character.length, {written, expected()});
  }

  // Letters that other dialects have, as this one says them.
  std::optional<std::string> letter_for_the_same(char c) const {
    for (const KindLetter& kind : text_.dialect.kinds)
      if (kind.letter != 0 && kind.kinds.find(c) != std::string_view::npos) return std::string(1, kind.letter);
    const std::string_view ends = c == 'O' ? "a" : c == 'B' ? "e" : "";
    const LightLetter* best = nullptr;
    for (const LightLetter& light : text_.dialect.lights)
      if (!ends.empty() && light.subscripts.find(ends) != std::string_view::npos) best = &light;
    if (best) return std::string(best->text);
    return std::nullopt;
  }

  std::string expected() const {
    std::string letters = text_.title() + "'s " + text_.dialect.eyes[0];
    for (const KindLetter& kind : text_.dialect.kinds)
      if (kind.letter != 0) letters += std::string(" ") + kind.letter;
    letters += " R T V .";
    for (const LightLetter& light : text_.dialect.lights)
      if (!light.text.empty()) letters += " " + std::string(light.text);
    return letters;
  }

  // [..] and [^..], outside <..>.
  Node brackets() {
    Node node{.kind = NodeKind::Letters, .offset = text_.at};
    const std::size_t open = text_.at++;
    const bool negated = text_.peek() == '^';
    if (negated) ++text_.at;
    std::size_t count = 0;
    SymbolSet types = 0, kinds = 0;
    for (; text_.skip_blanks(), !text_.at_end() && text_.peek() != ']'; ++count) {
      const std::size_t begin = text_.at;
      if (text_.peek() == '[' || text_.peek() == '(' || text_.peek() == ')') break;
      if (is_repetition(text_.peek()) || text_.peek() == '|') {
        text_.report(ErrorCode::OperatorInSet, text_.at, 1, {quoted(std::string(1, text_.peek()))},
                     Edit{text_.at, 1, ""});
        ++text_.at;
      } else if (text_.peek() == '<') {
        const LetterSet set = group().set;
        if (negated)
          text_.report(ErrorCode::NotTakenAway, begin, text_.at - begin, {"'<..>'", "it takes single letters away"});
        node.set |= set;
      } else if (at_label()) {
        node.set |= labelled_event();
      } else if (negated && text_.peek() == '.') {
        ++text_.at;
        text_.report(ErrorCode::NotTakenAway, begin, 1, {"'.'", "nothing is left"});
      } else {
        const bool is_kind = kind_of(text_.dialect, text_.peek()).has_value();
        const SymbolSet set = letter();
        (is_kind ? kinds : types) |= set;
        node.set |= set;
      }
    }
    if (negated && types != 0 && kinds != 0)
      text_.report(ErrorCode::NotTakenAway, open, text_.at - open,
                   {"event types and scattering letters together", "it takes letters of one kind away"},
                   "write two sets, or name the events that are wanted");
    close(open);
    if (count == 0) text_.report(ErrorCode::EmptySet, open, text_.at - open, {expected()});
    if (negated) node.set = LetterSet(any_of(text_.dialect)) - node.set;
    node.length = text_.at - open;
    return node;
  }

  void close(std::size_t open) {
    if (!text_.at_end() && text_.peek() == ']')
      ++text_.at;
    else
      text_.report(ErrorCode::NeverClosed, open, 1, {"'['", "']'"}, Edit{text_.at, 0, "]"});
  }

  // ---- <type scattering label> -------------------------------------------------------------------------------------

  Node group() {
    Node node{.kind = NodeKind::Letters, .offset = text_.at};
    const std::size_t open = text_.at++;
    std::string moved;  // repetitions that belong behind the group
    std::size_t first_moved = 0;
    LetterSet set = kAllSymbols;
    std::size_t fields = 0;
    while (text_.skip_blanks(), !text_.at_end() && text_.peek() != '>' && text_.peek() != ')' && text_.peek() != '|' &&
                                    text_.peek() != '<') {
      if (is_repetition(text_.peek())) {
        if (moved.empty()) first_moved = text_.at;
        moved += take_repetition();
        continue;
      }
      set &= field(fields++);
    }
    const std::size_t closing = text_.at;
    if (!text_.at_end() && fields > 0 && text_.peek() == '>') {
      ++text_.at;
      if (!moved.empty()) {
        const std::size_t length = text_.at - open;
        std::string repaired = text_.source.text(open, length);
        repaired.erase(first_moved - open, moved.size());
        text_.report(ErrorCode::RepetitionInGroup, first_moved, moved.size(), {}, Edit{open, length, repaired + moved},
                     "repeat the whole event: " + did_you_mean(repaired + moved));
      }
    } else if (!text_.at_end() && text_.peek() == '>') {
      ++text_.at;
      text_.report(ErrorCode::EmptyGroup, open, text_.at - open, {}, Edit{open, text_.at - open, "."});
    } else {
      text_.report(ErrorCode::NeverClosed, open, 1, {"'<'", "'>'"}, Edit{closing, 0, ">"});
    }
    node.set = set;
    node.length = text_.at - open;
    if (set.is_empty()) text_.warn(ErrorCode::NoSuchEvent, node.offset, node.length);
    return node;
  }

  // Repetitions side by side are one text.
  std::string take_repetition() {
    const std::size_t begin = text_.at;
    if (text_.peek() == '{') {
      while (!text_.at_end() && text_.peek() != '}' && text_.peek() != '>') ++text_.at;
      if (text_.peek() == '}') ++text_.at;
    } else {
      ++text_.at;
    }
    return text_.source.text(begin, text_.at - begin);
  }

  // A field is a letter, '.', [..] or [^..]; the third one has labels for letters.
  LetterSet field(std::size_t place) {
    if (text_.peek() == '.') return ++text_.at, kAllSymbols;
    const std::size_t begin = text_.at;
    if (at_label()) {
      const std::string name = label();
      check_label_place(place, begin);
      return LetterSet::labelled(kAllSymbols, name);
    }
    if (text_.peek() != '[') {
      if (place < 2) return field_letter(place);
      text_.report(ErrorCode::WrongPlace, text_.at, 1,
                   {quoted(std::string(1, text_.peek())), "no label", "third", "a label in quotes"});
      return ++text_.at, kAllSymbols;
    }
    const std::size_t open = text_.at++;
    const bool negated = text_.peek() == '^';
    if (negated) ++text_.at;
    LetterSet set;
    std::size_t count = 0;
    bool has_label = false;
    for (; text_.skip_blanks(), !text_.at_end() && text_.peek() != ']' && text_.peek() != '>'; ++count) {
      if (at_label()) {
        has_label = true;
        set |= LetterSet::labelled(kAllSymbols, label());
      } else if (place < 2) {
        set |= field_letter(place);
      } else {
        text_.report(ErrorCode::WrongPlace, text_.at, 1,
                     {quoted(std::string(1, text_.peek())), "no label", "third", "labels in quotes"});
        ++text_.at;
      }
    }
    if (has_label) check_label_place(place, open);
    close(open);
    if (count == 0) text_.report(ErrorCode::EmptySet, open, text_.at - open, {expected_at(place)});
    return negated ? LetterSet(kAllSymbols) - set : set;
  }

  static std::string_view expected_at(std::size_t place) {
    return place == 0 ? "types of events" : place == 1 ? "scatterings" : "labels in quotes";
  }

  // Labels stand third; a type or a scattering that was left out is '.'.
  void check_label_place(std::size_t place, std::size_t begin) {
    if (place < 2)
      text_.report(ErrorCode::LabelMisplaced, begin, text_.at - begin, {}, Edit{begin, 0, place == 0 ? ".." : "."});
    else if (place > 2)
      text_.report(ErrorCode::SecondLabel, begin, text_.at - begin, {}, "name the one that is asked for");
  }

  SymbolSet field_letter(std::size_t place) {
    const std::size_t begin = text_.at;
    const char c = text_.peek();
    const auto set = place == 0 ? type_of(text_.dialect, c) : kind_of(text_.dialect, c);
    if (set) {
      ++text_.at;
      if (place == 1) refuse_lobe_number();
      return *set;
    }
    if (place == 0 && kind_of(text_.dialect, c)) {
      text_.report(ErrorCode::WrongPlace, begin, 1,
                   {quoted(std::string(1, c)), "a scattering", "first", "the type of event"}, Edit{begin, 0, "."},
                   "any type is '.', as in <.D>");
      return ++text_.at, kAllSymbols;
    }
    if (place == 1 && type_of(text_.dialect, c)) {
      text_.report(ErrorCode::WrongPlace, begin, 1,
                   {quoted(std::string(1, c)), "a type of event", "second", "its scattering"});
      return ++text_.at, kAllSymbols;
    }
    refuse_letter();
    return kAllSymbols;
  }

  DialectText& text_;
};

}  // namespace

Node read_event(DialectText& text) {
  return EventReader(text).read();
}

}  // namespace heckbert::taxonomy
