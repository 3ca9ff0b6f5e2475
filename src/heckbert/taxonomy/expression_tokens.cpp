#include <heckbert/taxonomy/expression_tokens.h>

#include <algorithm>
#include <array>
#include <utility>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/label.h>
#include <heckbert/taxonomy/lookalikes.h>
#include <heckbert/taxonomy/utf8.h>

namespace heckbert::taxonomy {

namespace {

bool is_name(char c) {
  return is_lower(c) || is_upper(c) || is_digit(c) || c == '-' || c == '_';
}

constexpr std::string_view kLettersExpected = "L, D, G, S, V, E, X, N or '.'";

// What a letter without a subscript stands for; nothing for a character that is no letter of ours.
SymbolSet letter_set(char c) {
  switch (c) {
    case '.':
      return kEvents;
    case 'X':
      return with_letter('D') | with_letter('G') | with_letter('S');
    case 'N':
      return with_letter('D') | with_letter('G');
    case 'C':
      return kEyes;
    default:
      return with_letter(c);
  }
}

SymbolSet subscripted_set(char letter, char subscript) {
  return symbols_where([=](const SymbolFacts& f) { return f.letter == letter && f.subscript == subscript; });
}

// Characters of other notations and what is written here instead.
struct Foreign {
  char written;
  ErrorCode code;
  std::string_view why;  ///< of a letter
  std::string_view suggestion;
};
constexpr std::array kForeign{
    Foreign{'R', ErrorCode::ForeignLetter, "reflection is a subscript", "write Dr, Gr or Sr"},
    Foreign{'T', ErrorCode::ForeignLetter, "transmission is a subscript", "write Dt, Gt or St"},
    Foreign{'O', ErrorCode::ForeignLetter, "an object that glows is a light", "write La for area lights, L for any"},
    Foreign{'B', ErrorCode::ForeignLetter, "the background is a light", "write Le for the environment light"},
    Foreign{'A', ErrorCode::ForeignLetter, "the ambient term and albedo are no light paths", ""},
    Foreign{'>', ErrorCode::ClosesNothing, "", "write Dr, Gt, Sr ... for reflection and transmission"},
    Foreign{']', ErrorCode::ClosesNothing, "", ""},
    Foreign{'}', ErrorCode::ClosesNothing, "", ""},
    Foreign{'^', ErrorCode::NoOperator, "", "inside brackets it negates, [^S]; of a whole expression '!' does"},
    Foreign{',', ErrorCode::NoOperator, "", "alternatives are separated by '|'"},
    Foreign{'/', ErrorCode::NoOperator, "", ""},
    Foreign{'~', ErrorCode::NoOperator, "", "the complement of a whole expression is written with '!'"},
};

class TokenReader {
 public:
  explicit TokenReader(ExpressionSource& source) : source_(source), at_(source.begin) {}

  std::vector<Token> read() {
    while (skip_blanks(), !at_end()) read_token();
    const std::size_t end = tokens_.empty() ? source_.begin : tokens_.back().offset + tokens_.back().length;
    tokens_.push_back({.kind = TokenKind::End, .offset = end, .length = 1});
    return std::move(tokens_);
  }

 private:
  bool at_end() const { return at_ >= source_.end; }
  char peek(std::size_t ahead = 0) const { return at_ + ahead < source_.end ? source_.document[at_ + ahead] : '\0'; }
  std::string_view rest() const { return source_.document.substr(at_, source_.end - at_); }

  void skip_blanks() {
    while (!at_end()) {
      if (is_blank(peek()))
        ++at_;
      else if (peek() == '#')
        at_ = std::min(source_.document.find('\n', at_), source_.end);
      else
        return;
    }
  }

  void push(TokenKind kind, std::size_t length) { push({.kind = kind, .length = length}); }
  void push(Token token) {
    token.offset = at_;
    at_ += token.length;
    tokens_.push_back(token);
  }
  void push_bad(ErrorCode code, std::size_t length, std::string suggestion = {}) {
    source_.report(code, at_, length, {}, std::move(suggestion));
    push(TokenKind::Bad, length);
  }

  void read_token() {
    switch (peek()) {
      case '(':
        return push(TokenKind::Open, 1);
      case ')':
        return push(TokenKind::Close, 1);
      case '|':
        return read_operator(TokenKind::Bar);
      case '&':
        return read_operator(TokenKind::And);
      case '-':
        return push(TokenKind::Minus, 1);
      case '!':
        return push(TokenKind::Not, 1);
      case '*':
        return push({.kind = TokenKind::Repeat, .length = 1, .at_least = 0});
      case '+':
        return push({.kind = TokenKind::Repeat, .length = 1, .at_least = 1});
      case '?':
        return push({.kind = TokenKind::Repeat, .length = 1, .at_least = 0, .at_most = 1});
      case '{':
        return read_count();
      case '[':
        return read_set();
      case '@':
        return read_name();
      case '<':
        return read_group();
      case '\'':
      case '"':
        return read_bare_label();
      default: {
        const PlainLetter letter = read_letter();
        push_letters(letter.set, letter.length, letter.set != 0);
      }
    }
  }

  // A letter or a set of them `length` characters long, and the label behind it if there is one.
  void push_letters(const LetterSet& set, std::size_t length, bool is_good) {
    const std::size_t begin = at_;
    at_ += length;
    const LabelledSet labelled = with_label_behind(set);
    const std::size_t end = at_;
    at_ = begin;
    push({.kind = is_good && labelled.is_good ? TokenKind::Letters : TokenKind::Bad,
          .length = end - begin,
          .set = labelled.set});
  }

  struct LabelledSet {
    LetterSet set;
    bool is_good = true;
    bool has_label = false;
  };

  bool at_label() const { return !at_end() && (peek() == '\'' || peek() == '"'); }

  // The letters before this place, only those with the label that stands here; goes on behind it.
  LabelledSet with_label_behind(const LetterSet& set) {
    if (!at_label()) return {set};
    const std::size_t open = at_;
    const auto read = read_label(source_.document.substr(0, source_.end), at_);
    if (!read) {
      const std::size_t line_end = rest().find('\n');
      source_.report(ErrorCode::NeverClosed, open, 1, {"the label", "another " + std::string(1, peek())});
      at_ = line_end == std::string_view::npos ? source_.end : open + line_end;
      return {set, false, true};
    }
    at_ += read->length;
    LabelledSet result{LetterSet::labelled(set.of(read->label), read->label), true, true};
    if ((set.symbols() & kEyes) != 0) {
      source_.report(ErrorCode::EyeLabelled, open, read->length);
      result.is_good = false;
    } else if (result.set.is_empty() && !set.is_empty()) {
      source_.report(ErrorCode::LabelOfNothing, open, read->length);
      result.is_good = false;
    }
    return result;
  }

  // A label without a letter is any event that has it.
  void read_bare_label() {
    const std::size_t begin = at_;
    const LabelledSet labelled = with_label_behind(kEvents);
    const std::size_t end = at_;
    at_ = begin;
    push({.kind = labelled.is_good ? TokenKind::Letters : TokenKind::Bad, .length = end - begin, .set = labelled.set});
  }

  // Programmers double these.
  void read_operator(TokenKind kind) {
    const char c = peek();
    if (peek(1) == c)
      source_.report(ErrorCode::NoOperator, at_, 2, {quoted(rest().substr(0, 2))}, did_you_mean(rest().substr(0, 1)));
    push(kind, peek(1) == c ? 2 : 1);
  }

  struct PlainLetter {
    SymbolSet set = 0;  ///< empty: reported
    std::size_t length = 1;
  };

  // One letter with its subscript, here, inside and outside brackets; does not advance.
  PlainLetter read_letter() {
    const char c = peek(), subscript = is_lower(peek(1)) ? peek(1) : '\0';
    const SymbolSet plain = letter_set(c);
    if (plain == 0) return {0, report_unknown()};
    if (subscript == '\0') return {plain, 1};
    if (const SymbolSet fine = subscripted_set(c, subscript)) return {fine, 2};

    // A small letter that begins no subscript may be an event in lower case.
    const std::string written{c, subscript};
    const char upper = static_cast<char>(subscript - 'a' + 'A');
    if (c == '.' || c == 'X' || c == 'N' || c == 'C' || c == 'V') {
      std::string spelled;
      for (const Symbol s : members(plain))
        if (facts(s).subscript == subscript) spelled += name(s);
      source_.report(ErrorCode::UnknownSubscript, at_, 2, {quoted(written), std::string(1, c) + " without a subscript"},
                     spelled.empty() ? "" : did_you_mean(c == 'C' ? spelled : "[" + spelled + "]"));
    } else {
      std::string known;
      for (const Symbol s : members(plain)) known += (known.empty() ? "" : ", ") + name(s);
      source_.report(ErrorCode::UnknownSubscript, at_, 2, {quoted(written), std::string(1, c) + " alone, or " + known},
                     letter_set(upper) != 0 ? did_you_mean(std::string{c, upper}) : "");
    }
    return {0, 2};
  }

  // Reports whatever stands here and is no token; gives its length.
  std::size_t report_unknown() {
    const char c = peek();
    if (is_lower(c)) return report_lower_case();
    const auto foreign =
        std::find_if(kForeign.begin(), kForeign.end(), [c](const Foreign& f) { return f.written == c; });
    if (foreign != kForeign.end()) {
      const std::string written = quoted(std::string_view(&c, 1)), suggestion(foreign->suggestion);
      if (foreign->why.empty())
        source_.report(foreign->code, at_, 1, {written}, suggestion);
      else
        source_.report(foreign->code, at_, 1, {written, foreign->why}, suggestion);
      return 1;
    }
    const Utf8Character character = utf8_at(source_.document.substr(0, source_.end), at_);
    if (!character.valid) {
      source_.report(ErrorCode::NotUtf8, at_, 1, {kLettersExpected});
      return 1;
    }
    if (character.code < 0x20 || (character.code >= 0x7F && character.code < 0xA0)) {
      source_.report(ErrorCode::ControlCharacter, at_, character.length, {kLettersExpected});
      return character.length;
    }
    // Full-width forms are the ASCII characters at a fixed distance.
    if (character.code >= 0xFF01 && character.code <= 0xFF5E) {
      source_.report(ErrorCode::Lookalike, at_, character.length, {"a full-width character"},
                     did_you_mean(std::string(1, static_cast<char>(character.code - 0xFF01 + '!'))));
      return character.length;
    }
    if (const Lookalike* l = find_lookalike(character.code)) {
      source_.report(ErrorCode::Lookalike, at_, character.length, {l->what},
                     l->meant.empty() ? "delete it" : did_you_mean(l->meant));
      return character.length;
    }
    source_.report(ErrorCode::UnknownLetter, at_, character.length,
                   {quoted(rest().substr(0, character.length)), kLettersExpected});
    return character.length;
  }

  // A whole run of small letters is one mistake: "ldse".
  std::size_t report_lower_case() {
    std::size_t length = 0;
    std::string upper;
    bool all_known = true;
    for (; is_lower(peek(length)); ++length) {
      upper += static_cast<char>(peek(length) - 'a' + 'A');
      all_known = all_known && letter_set(upper.back()) != 0;
    }
    source_.report(ErrorCode::SmallLetter, at_, length, {quoted(rest().substr(0, length))},
                   all_known ? did_you_mean(upper) : "a named class is written with '@'");
    return length;
  }

  void read_set() {
    const std::size_t open = at_;
    ++at_;
    const bool negated = peek() == '^' || peek() == '!';
    if (peek() == '!') source_.report(ErrorCode::OperatorInSet, at_, 1, {"'!'"}, did_you_mean("^"));
    if (negated) ++at_;
    LetterSet set;
    std::vector<std::pair<std::size_t, std::size_t>> ends;  // items that are ends: offset and length
    bool only_lights = true, has_label = false;
    bool is_good = true;
    std::size_t count = 0;
    while (skip_blanks(), !at_end() && peek() != ']') {
      if (std::string_view("|,()*+?{}&-@[!^").find(peek()) != std::string_view::npos) {
        if (peek() == '[' || peek() == '(' || peek() == ')' || peek() == '@') break;
        source_.report(ErrorCode::OperatorInSet, at_, 1, {quoted(rest().substr(0, 1))}, "write [DG] for D or G");
        is_good = false;
        ++at_;
        continue;
      }
      const std::size_t begin = at_;
      const PlainLetter letter = at_label() ? PlainLetter{kEvents, 0} : read_letter();
      at_ += letter.length;
      const LabelledSet labelled = with_label_behind(letter.set);
      if ((letter.set & ~kEvents) != 0) ends.emplace_back(begin, at_ - begin);
      only_lights = only_lights && (letter.set & ~kLights) == 0;
      has_label = has_label || labelled.has_label;
      is_good = is_good && letter.set != 0 && labelled.is_good;
      set |= labelled.set;
      ++count;
    }
    // [^L'key'] takes lights away from lights; without a label that would be said by naming the others.
    const SymbolSet role = only_lights && has_label ? kLights : kEvents;
    if (negated && role == kEvents)
      for (const auto& [begin, length] : ends) {
        source_.report(ErrorCode::NotTakenAway, begin, length, {"an end", "it takes events away from D, G, S, V"},
                       "name the ends that you want, as in [LaLe]");
        is_good = false;
      }
    const bool closed = peek() == ']' && !at_end();
    const std::size_t end = closed ? at_ + 1 : at_;
    at_ = open;
    if (!closed) {
      source_.report(ErrorCode::NeverClosed, open, 1, {"'['", "']'"});
      is_good = false;
    } else if (is_good && count == 0) {
      source_.report(ErrorCode::EmptySet, open, end - open, {"at least one of D, G, S, V, L, E"},
                     negated ? "any event is written '.'" : "");
      is_good = false;
    }
    if (negated) set = LetterSet(role) - set;
    if (is_good && set.is_empty()) {
      source_.report(ErrorCode::EmptySet, open, end - open, {"[^ ] to leave some of D, G, S, V"});
      is_good = false;
    }
    push_letters(set, end - open, is_good);
  }

  // {n} {n,} {n,m}
  void read_count() {
    const std::size_t open = at_;
    ++at_;
    const auto least = read_number();
    skip_blanks();
    const bool has_comma = peek() == ',';
    if (has_comma) ++at_;
    const auto most = has_comma ? read_number() : least;
    skip_blanks();
    Token token{.kind = TokenKind::Repeat};
    const bool closed = peek() == '}' && !at_end();
    if (!closed) {
      report_open_count(open);
    } else {
      ++at_;
      check_count(open, least, most, has_comma);
    }
    token.length = at_ - open;
    token.at_least = std::min(least.value_or(0), kMaxCount);
    if (most) token.at_most = std::clamp(*most, token.at_least, kMaxCount);
    at_ = open;
    push(token);
  }

  // The number here, or nothing; saturates above kMaxCount.
  std::optional<unsigned> read_number() {
    skip_blanks();
    if (!is_digit(peek())) return std::nullopt;
    unsigned number = 0;
    for (; is_digit(peek()); ++at_) number = std::min(number * 10 + static_cast<unsigned>(peek() - '0'), kMaxCount + 1);
    return number;
  }

  void report_open_count(std::size_t open) {
    const std::size_t close = rest().find_first_of("{}|()*+?");
    if (close != std::string_view::npos && rest()[close] == '}') {
      at_ += close + 1;
      source_.report(ErrorCode::MalformedCount, open, at_ - open);
    } else {
      source_.report(ErrorCode::NeverClosed, open, 1, {"'{'", "{n}, {n,} or {n,m}"});
    }
  }

  void check_count(std::size_t open, std::optional<unsigned> least, std::optional<unsigned> most, bool has_comma) {
    const std::size_t length = at_ - open;
    if (!least)
      source_.report(ErrorCode::MalformedCount, open, length, {},
                     most        ? did_you_mean("{0," + std::to_string(*most) + "}")
                     : has_comma ? did_you_mean("*")
                                 : "");
    else if (*least > kMaxCount || most.value_or(0) > kMaxCount)
      source_.report(ErrorCode::CountTooGreat, open, length, {std::to_string(kMaxCount)});
    else if (most && *most < *least)
      source_.report(ErrorCode::CountReversed, open, length, {},
                     did_you_mean("{" + std::to_string(*most) + "," + std::to_string(*least) + "}"));
  }

  // @name; a '-' that ends it is the operator.
  void read_name() {
    std::size_t length = 1;
    while (is_name(peek(length))) ++length;
    while (length > 1 && peek(length - 1) == '-') --length;
    if (length == 1) return push_bad(ErrorCode::NameMissing, 1);
    push(TokenKind::Name, length);
  }

  // <RD> of light path expressions.
  void read_group() {
    const std::size_t close = rest().find('>');
    if (close == std::string_view::npos || close > 40) return push_bad(ErrorCode::GroupUnavailable, 1);
    const std::string_view inside = rest().substr(1, close - 1);
    const char mode = inside.empty() ? '\0' : inside[0], kind = inside.size() < 2 ? '\0' : inside[1];
    std::string spelled;
    for (const Symbol s : members(kEvents)) {
      const SymbolFacts& f = facts(s);
      const bool mode_fits = mode == '.' || (mode == 'R' && f.subscript == 'r') || (mode == 'T' && f.subscript == 't');
      if (mode_fits && f.subscript != 0 && (kind == '.' || kind == f.letter)) spelled += name(s);
    }
    const bool one_kind = mode == '.' && spelled.size() == 4;
    if (one_kind) spelled.resize(1);
    if (spelled.size() > 2) spelled = "[" + spelled + "]";
    push_bad(ErrorCode::GroupUnavailable, close + 1,
             spelled.empty() ? "write Dr, Gt, Sr ... for reflection and transmission" : did_you_mean(spelled));
  }

  ExpressionSource& source_;
  std::size_t at_;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> read_tokens(ExpressionSource& source) {
  return TokenReader(source).read();
}

}  // namespace heckbert::taxonomy
