#include <heckbert/taxonomy/dialect_parser.h>

#include <algorithm>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/dialect_letters.h>
#include <heckbert/taxonomy/label.h>
#include <heckbert/taxonomy/lookalikes.h>
#include <heckbert/taxonomy/utf8.h>

namespace heckbert::taxonomy {

namespace {

bool is_repetition(char c) {
  return c == '*' || c == '+' || c == '?' || c == '{';
}

class DialectParser {
 public:
  DialectParser(ExpressionSource& source, const DialectFacts& dialect)
      : source_(source), dialect_(dialect), at_(source.begin), end_(source.end) {}

  DialectTree parse() {
    trim();
    read_prefixes();
    if (at_end()) {
      report(at_, 1, "an empty expression; expected a path such as " + example());
      return std::move(tree_);
    }
    tree_.root = alternatives();
    report_wholes_inside(tree_.root, true);
    return std::move(tree_);
  }

 private:
  // ---- characters --------------------------------------------------------------------------------------------------

  bool at_end() const { return at_ >= end_; }
  char peek(std::size_t ahead = 0) const { return at_ + ahead < end_ ? source_.document[at_ + ahead] : '\0'; }
  std::string title() const { return std::string(dialect_.title); }
  std::string example() const { return dialect_.orientation == Orientation::Either ? "L D* E" : "CD*L"; }

  void report(std::size_t offset, std::size_t length, std::string message, std::string suggestion = {}) {
    source_.report(offset, length, std::move(message), std::move(suggestion));
    tree_.is_repairable = false;
  }
  void report(std::size_t offset, std::size_t length, std::string message, const Edit& edit,
              std::string suggestion = {}) {
    if (suggestion.empty())
      suggestion = edit.replacement.empty() ? "delete it" : "did you mean " + quoted(edit.replacement) + "?";
    source_.report(offset, length, std::move(message), std::move(suggestion));
    tree_.edits.push_back(edit);
  }
  void warn(std::size_t offset, std::size_t length, std::string message) {
    tree_.warnings.push_back(diagnose(source_.name, source_.document, offset, length, std::move(message)));
  }

  void trim() {
    if (dialect_.blanks == Blanks::Refused) return;
    while (!at_end() && is_blank(peek())) ++at_;
    while (!at_end() && is_blank(source_.document[end_ - 1])) --end_;
  }

  void skip_blanks() {
    while (!at_end() && is_blank(peek())) {
      if (dialect_.blanks != Blanks::Ignored)
        report(at_, 1, title() + " takes no blanks inside an expression", Edit{at_, 1, ""});
      ++at_;
    }
  }

  // ---- words before the expression ---------------------------------------------------------------------------------

  void read_prefixes() {
    for (;;) {
      std::size_t length = 0;
      while (is_lower(peek(length))) ++length;
      if (length < 2) return;
      const std::string word = source_.text(at_, length);
      const std::vector<std::string> known = split_words(dialect_.prefixes);
      if (std::find(known.begin(), known.end(), word) == known.end()) {
        const std::string near = nearest(word, known);
        report(at_, length, title() + " has no prefix " + quoted(word),
               near.empty() ? "" : "did you mean " + quoted(near) + "?");
      }
      tree_.prefixes.push_back(word);
      at_ += length;
      if (peek() == ':' || peek() == ';') ++at_;
      while (!at_end() && is_blank(peek())) ++at_;
    }
  }

  static std::vector<std::string> split_words(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
      const std::size_t blank = std::min(text.find(' '), text.size());
      words.emplace_back(text.substr(0, blank));
      text.remove_prefix(std::min(blank + 1, text.size()));
    }
    return words;
  }

  // ---- operators ---------------------------------------------------------------------------------------------------

  void adopt(Node& parent, Node child) {
    parent.height = std::max(parent.height, child.height + 1);
    parent.length = child.offset + child.length - parent.offset;
    if (parent.height > kMaxDepth) give_up(child.offset);
    parent.children.push_back(std::move(child));
  }

  void give_up(std::size_t offset) {
    if (!gave_up_) report(offset, 1, "nested deeper than " + std::to_string(kMaxDepth) + " levels");
    gave_up_ = true;
    at_ = end_;
  }

  // a | b, where '|' binds loosest.
  Node alternatives() {
    Node first = dialect_.has_whole_operators ? sets() : sequence();
    if (peek() != '|') return first;
    Node node{.kind = NodeKind::Alternation, .offset = first.offset};
    adopt(node, std::move(first));
    while (peek() == '|') {
      ++at_;
      adopt(node, dialect_.has_whole_operators ? sets() : sequence());
    }
    return node;
  }

  Node sets() {
    Node left = complement();
    while (peek() == '&' || peek() == '-') {
      Node node{.kind = peek() == '&' ? NodeKind::Both : NodeKind::Without, .offset = left.offset};
      ++at_;
      adopt(node, std::move(left));
      adopt(node, complement());
      left = std::move(node);
    }
    return left;
  }

  Node complement() {
    skip_blanks();
    if (peek() != '^') return sequence();
    Node node{.kind = NodeKind::Complement, .offset = at_};
    ++at_;
    if (++depth_ > kMaxDepth) give_up(node.offset);
    adopt(node, complement());
    --depth_;
    return node;
  }

  bool stops_sequence() const {
    const char c = peek();
    return at_end() || (c == ')' && open_ > 0) || (c == '|' && !dialect_.bar_binds_tightest) ||
           (dialect_.has_whole_operators && (c == '&' || c == '-'));
  }

  Node sequence() {
    skip_blanks();
    Node node{.kind = NodeKind::Sequence, .offset = at_};
    while (!stops_sequence()) {
      adopt(node, dialect_.bar_binds_tightest ? choice() : repetition());
      skip_blanks();
    }
    if (node.children.empty() && !gave_up_) {
      const bool in_union = peek() == '|' || (at_ > source_.begin && source_.document[at_ - 1] == '|');
      report(std::min(at_, end_ - 1), 1, in_union ? "an empty alternative" : "expected a letter, '(', '[' or '<' here");
    }
    if (node.children.size() == 1) return std::move(node.children[0]);
    return node;
  }

  // a | b, where '|' binds tightest: to the item before and the item behind, repetitions included.
  Node choice() {
    Node first = repetition();
    skip_blanks();
    if (peek() != '|') return first;
    Node node{.kind = NodeKind::Alternation, .offset = first.offset};
    adopt(node, std::move(first));
    while (peek() == '|') {
      const std::size_t bar = at_++;
      skip_blanks();
      if (stops_sequence() || peek() == '|') {
        report(bar, 1, "an empty alternative");
        break;
      }
      adopt(node, repetition());
      skip_blanks();
    }
    return node;
  }

  Node repetition() {
    Node node = atom();
    for (std::size_t count = 0; skip_blanks(), is_repetition(peek()) && !at_end(); ++count) {
      Node repeat{.kind = NodeKind::Repeat, .offset = node.offset};
      const std::size_t sign = at_;
      read_repetition(repeat);
      if (count > 0 && !dialect_.stacks_repetitions)
        report(sign, at_ - sign, "a second repetition of one item; " + title() + " reads one",
               "put the item into parentheses: (" + source_.text(node.offset, sign - node.offset) + ")" +
                   source_.text(sign, at_ - sign));
      adopt(repeat, std::move(node));
      repeat.length = at_ - repeat.offset;
      node = std::move(repeat);
    }
    return node;
  }

  void read_repetition(Node& repeat) {
    const std::size_t sign = at_;
    const char c = peek();
    ++at_;
    if (c == '*' || c == '+') {
      repeat.at_least = c == '+' ? 1 : 0;
    } else if (c == '?') {
      repeat.at_most = 1;
      if (dialect_.has_optional) return;
      if (dialect_.has_range)
        report(sign, 1, title() + " has no '?'", Edit{sign, 1, "{0,1}"});
      else
        report(sign, 1, title() + " has no '?'", "write both: the expression with the piece, and '|' without it");
    } else {
      read_count(repeat, sign);
    }
  }

  std::optional<unsigned> read_number() {
    skip_blanks();
    if (!is_digit(peek())) return std::nullopt;
    unsigned number = 0;
    for (; is_digit(peek()); ++at_) number = std::min(number * 10 + static_cast<unsigned>(peek() - '0'), kMaxCount + 1);
    return number;
  }

  void read_count(Node& repeat, std::size_t sign) {
    const auto least = read_number();
    skip_blanks();
    const bool has_comma = peek() == ',';
    if (has_comma) ++at_;
    const auto most = has_comma ? read_number() : least;
    skip_blanks();
    if (peek() != '}' || !least) {
      while (!at_end() && peek() != '}' && peek() != ')' && peek() != '|') ++at_;
      if (peek() == '}') ++at_;
      return report(sign, at_ - sign, "a count is written {n}, {n,} or {n,m} with numbers n and m");
    }
    ++at_;
    repeat.at_least = *least;
    repeat.at_most = most;
    const bool exists = !has_comma ? dialect_.has_exact : most ? dialect_.has_range : dialect_.has_open;
    if (!exists)
      report(sign, at_ - sign, title() + " is not documented to have this count", "write the piece as often as needed");
    else if (*least > kMaxCount || most.value_or(0) > kMaxCount)
      report(sign, at_ - sign, "a count above " + std::to_string(kMaxCount) + ", the greatest that is read");
    else if (most && *most < *least)
      report(sign, at_ - sign, "the least number of this count exceeds the greatest",
             Edit{sign, at_ - sign, "{" + std::to_string(*most) + "," + std::to_string(*least) + "}"});
    if (repeat.at_most) repeat.at_most = std::max(*repeat.at_most, repeat.at_least);
  }

  // ---- items -------------------------------------------------------------------------------------------------------

  Node atom() {
    if (peek() == '(') return parentheses();
    if (peek() == '[') return brackets();
    if (peek() == '<') return group();
    Node node{.kind = NodeKind::Letters, .offset = at_};
    node.set = at_label() ? labelled_event() : LetterSet(letter());
    node.length = at_ - node.offset;
    return node;
  }

  Node parentheses() {
    const std::size_t open = at_++;
    if (++depth_ > kMaxDepth) {
      give_up(open);
      return {};
    }
    ++open_;
    Node inner = alternatives();
    --open_;
    --depth_;
    if (peek() == ')' && !at_end())
      ++at_;
    else if (!gave_up_)
      report(open, 1, "'(' is never closed", Edit{end_, 0, ")"}, "expected ')'");
    inner.offset = open;
    inner.length = at_ - open;
    return inner;
  }

  // One letter of ours outside <..>; advances, also over what is wrong.
  SymbolSet letter() {
    const std::size_t begin = at_;
    const char c = peek();
    if (c == '.') return ++at_, any_of(dialect_);
    // Two letters of a light end.
    for (const LightLetter& light : dialect_.lights)
      if (light.text.size() == 2 && light.text[0] == c && light.text[1] == peek(1)) return at_ += 2, symbols_of(light);
    if (const auto kind = kind_of(dialect_, c)) {
      ++at_;
      if (*kind == 0) warn(begin, 1, "straight-through events are left out of our words, so this matches nothing");
      refuse_lobe_number();
      return *kind;
    }
    if (const auto type = type_of(dialect_, c)) return ++at_, *type;
    refuse_letter();
    return kAllSymbols;
  }

  // RenderMan's D1..D4, S1..S8.
  void refuse_lobe_number() {
    if (!is_digit(peek())) return;
    report(at_ - 1, 2, "numbered lobes are not told apart by our words", Edit{at_, 1, ""},
           "without the number it is every lobe");
    ++at_;
  }

  bool at_label() const { return !at_end() && (peek() == '\'' || peek() == '"'); }

  // The label that stands here; advances, also over what is wrong.
  std::string label() {
    const std::size_t open = at_;
    const auto read = read_label(source_.document.substr(0, end_), at_);
    if (!read) {
      at_ = end_;
      report(open, 1, "a label that is never closed; expected another " + std::string(1, source_.document[open]));
      return {};
    }
    at_ += read->length;
    return read->label;
  }

  // Outside <..>: any event with this label.
  LetterSet labelled_event() { return LetterSet::labelled(any_of(dialect_), label()); }

  // Whatever stands here and is no letter of the dialect.
  void refuse_letter() {
    const char c = peek();
    const std::size_t begin = at_;
    const Utf8Character character = utf8_at(source_.document.substr(0, end_), at_);
    at_ += character.length;
    if (const Lookalike* l = find_lookalike(character.code))
      return report(begin, character.length, std::string(l->what),
                    Edit{begin, character.length, std::string(l->meant)});
    if (c == '>' || c == ']' || c == ')' || c == '}')
      return report(begin, 1, quoted(std::string(1, c)) + " closes nothing", Edit{begin, 1, ""});
    if (c == '|') return report(begin, 1, "an empty alternative");
    if (is_repetition(c)) return report(begin, 1, "nothing to repeat before " + quoted(std::string(1, c)));
    if (c == 'E') return report(begin, 1, title() + " calls the eye C", Edit{begin, 1, "C"});
    if (c == '^' && dialect_.has_whole_operators)
      return report(begin, 1, "'^' complements a whole expression and cannot stand inside a path");
    if (c == '&' || c == '-' || c == '^' || c == '!')
      return report(begin, 1, quoted(std::string(1, c)) + " is no operator of " + title(),
                    "Heckbert and V-Ray have operators on whole expressions");
    if (c == '@') return report(begin, 1, title() + " has no named classes", "Heckbert's own notation has them");
    if (c == 'A') return report(begin, 1, "albedo is no light path");
    if (c == 'U' || c == 'M' || c == 'W' || c == 'K')
      return report(begin, 1, quoted(std::string(1, c)) + " is an event of one renderer only and not in our words");
    if (const auto here = letter_for_the_same(c))
      return report(begin, 1, title() + " has no " + std::string(1, c), Edit{begin, 1, *here});
    report(begin, character.length,
           "unknown letter " + quoted(source_.text(begin, character.length)) + " in " + title(),
           "expected " + expected());
  }

  // Letters that other dialects have, as this one says them.
  std::optional<std::string> letter_for_the_same(char c) const {
    for (const KindLetter& kind : dialect_.kinds)
      if (kind.letter != 0 && kind.kinds.find(c) != std::string_view::npos) return std::string(1, kind.letter);
    const std::string_view ends = c == 'O' ? "a" : c == 'B' ? "e" : "";
    const LightLetter* best = nullptr;
    for (const LightLetter& light : dialect_.lights)
      if (!ends.empty() && light.subscripts.find(ends) != std::string_view::npos) best = &light;
    if (best) return std::string(best->text);
    return std::nullopt;
  }

  std::string expected() const {
    std::string letters(1, dialect_.eyes[0]);
    for (const KindLetter& kind : dialect_.kinds)
      if (kind.letter != 0) letters += std::string(" ") + kind.letter;
    letters += " R T V .";
    for (const LightLetter& light : dialect_.lights)
      if (!light.text.empty()) letters += " " + std::string(light.text);
    return letters;
  }

  // [..] and [^..], outside <..>.
  Node brackets() {
    Node node{.kind = NodeKind::Letters, .offset = at_};
    const std::size_t open = at_++;
    const bool negated = peek() == '^';
    if (negated) ++at_;
    std::size_t count = 0;
    SymbolSet types = 0, kinds = 0;
    for (; skip_blanks(), !at_end() && peek() != ']'; ++count) {
      const std::size_t begin = at_;
      if (peek() == '[' || peek() == '(' || peek() == ')') break;
      if (is_repetition(peek()) || peek() == '|') {
        report(at_, 1, quoted(std::string(1, peek())) + " inside brackets; letters stand side by side there",
               Edit{at_, 1, ""});
        ++at_;
      } else if (peek() == '<') {
        const LetterSet set = group().set;
        if (negated) report(begin, at_ - begin, "'<..>' inside [^ ]; it takes single letters away");
        node.set |= set;
      } else if (at_label()) {
        node.set |= labelled_event();
      } else if (negated && peek() == '.') {
        ++at_;
        report(begin, 1, "'.' inside [^ ] leaves nothing");
      } else {
        const bool is_kind = kind_of(dialect_, peek()).has_value();
        const SymbolSet set = letter();
        (is_kind ? kinds : types) |= set;
        node.set |= set;
      }
    }
    if (negated && types != 0 && kinds != 0)
      report(open, at_ - open, "event types and scattering letters together inside [^ ]",
             "write two sets, or name the events that are wanted");
    close(open, ']', "'[' is never closed");
    if (count == 0) report(open, at_ - open, "an empty set; expected " + expected());
    if (negated) node.set = LetterSet(any_of(dialect_)) - node.set;
    node.length = at_ - open;
    return node;
  }

  void close(std::size_t open, char bracket, const std::string& message) {
    if (!at_end() && peek() == bracket)
      ++at_;
    else
      report(open, 1, message, Edit{at_, 0, std::string(1, bracket)}, "expected " + quoted(std::string(1, bracket)));
  }

  // ---- <type scattering label> -------------------------------------------------------------------------------------

  Node group() {
    Node node{.kind = NodeKind::Letters, .offset = at_};
    const std::size_t open = at_++;
    std::string moved;  // repetitions that belong behind the group
    std::size_t first_moved = 0;
    LetterSet set = kAllSymbols;
    std::size_t fields = 0;
    while (skip_blanks(), !at_end() && peek() != '>' && peek() != ')' && peek() != '|' && peek() != '<') {
      if (is_repetition(peek())) {
        if (moved.empty()) first_moved = at_;
        moved += take_repetition();
        continue;
      }
      set &= field(fields++);
    }
    const std::size_t closing = at_;
    if (!at_end() && fields > 0 && peek() == '>') {
      ++at_;
      if (!moved.empty()) {
        const std::size_t length = at_ - open;
        std::string repaired = source_.text(open, length);
        repaired.erase(first_moved - open, moved.size());
        report(first_moved, moved.size(), "a repetition inside '<..>', which stands for one event",
               Edit{open, length, repaired + moved},
               "repeat the whole event: did you mean " + quoted(repaired + moved) + "?");
      }
    } else if (!at_end() && peek() == '>') {
      ++at_;
      report(open, at_ - open, "an empty event; expected its type and its scattering, as in <RD>",
             Edit{open, at_ - open, "."});
    } else {
      report(open, 1, "'<' is never closed", Edit{closing, 0, ">"}, "expected '>'");
    }
    node.set = set;
    node.length = at_ - open;
    if (set.is_empty()) warn(node.offset, node.length, "no event of our words is this, so it matches nothing");
    return node;
  }

  // Repetitions side by side are one text.
  std::string take_repetition() {
    const std::size_t begin = at_;
    if (peek() == '{') {
      while (!at_end() && peek() != '}' && peek() != '>') ++at_;
      if (peek() == '}') ++at_;
    } else {
      ++at_;
    }
    return source_.text(begin, at_ - begin);
  }

  // A field is a letter, '.', [..] or [^..]; the third one has labels for letters.
  LetterSet field(std::size_t place) {
    if (peek() == '.') return ++at_, kAllSymbols;
    const std::size_t begin = at_;
    if (at_label()) {
      const std::string name = label();
      check_label_place(place, begin);
      return LetterSet::labelled(kAllSymbols, name);
    }
    if (peek() != '[') {
      if (place < 2) return field_letter(place);
      report(at_, 1, "the third place in '<..>' is for a label; expected '.', a label in quotes or '>'");
      return ++at_, kAllSymbols;
    }
    const std::size_t open = at_++;
    const bool negated = peek() == '^';
    if (negated) ++at_;
    LetterSet set;
    std::size_t count = 0;
    bool has_label = false;
    for (; skip_blanks(), !at_end() && peek() != ']' && peek() != '>'; ++count) {
      if (at_label()) {
        has_label = true;
        set |= LetterSet::labelled(kAllSymbols, label());
      } else if (place < 2) {
        set |= field_letter(place);
      } else {
        report(at_, 1, "the third place in '<..>' is for labels; expected one in quotes");
        ++at_;
      }
    }
    if (has_label) check_label_place(place, open);
    close(open, ']', "'[' is never closed");
    if (count == 0) report(open, at_ - open, "an empty set");
    return negated ? LetterSet(kAllSymbols) - set : set;
  }

  // Labels stand third; a type or a scattering that was left out is '.'.
  void check_label_place(std::size_t place, std::size_t begin) {
    if (place < 2)
      report(begin, at_ - begin, "a label stands third in '<..>', behind the type and the scattering",
             Edit{begin, 0, place == 0 ? ".." : "."});
    else if (place > 2)
      report(begin, at_ - begin, "a second label in '<..>'; a letter of our words has one",
             "name the one that is asked for");
  }

  SymbolSet field_letter(std::size_t place) {
    const std::size_t begin = at_;
    const char c = peek();
    const auto set = place == 0 ? type_of(dialect_, c) : kind_of(dialect_, c);
    if (set) {
      ++at_;
      if (place == 1) refuse_lobe_number();
      return *set;
    }
    if (place == 0 && kind_of(dialect_, c)) {
      report(begin, 1, std::string(1, c) + " is a scattering; the first place in '<..>' is the type of event",
             Edit{begin, 0, "."}, "any type is '.', as in <.D>");
      return ++at_, kAllSymbols;
    }
    if (place == 1 && type_of(dialect_, c)) {
      report(begin, 1, std::string(1, c) + " is a type of event; the second place in '<..>' is its scattering");
      return ++at_, kAllSymbols;
    }
    refuse_letter();
    return kAllSymbols;
  }

  void report_wholes_inside(const Node& node, bool is_whole) {
    const bool is_operator =
        node.kind == NodeKind::Complement || node.kind == NodeKind::Both || node.kind == NodeKind::Without;
    if (is_operator && !is_whole)
      return report(node.offset, node.length, "an operator on whole expressions inside a path");
    for (const Node& child : node.children)
      report_wholes_inside(child, is_whole && (is_operator || node.kind == NodeKind::Alternation));
  }

  ExpressionSource& source_;
  const DialectFacts& dialect_;
  std::size_t at_;
  std::size_t end_;
  std::size_t depth_ = 0;
  std::size_t open_ = 0;
  bool gave_up_ = false;
  DialectTree tree_;
};

}  // namespace

DialectTree parse_dialect(ExpressionSource& source, const DialectFacts& dialect) {
  return DialectParser(source, dialect).parse();
}

}  // namespace heckbert::taxonomy
