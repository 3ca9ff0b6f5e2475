#include <heckbert/taxonomy/dialect_parser.h>

#include <algorithm>
#include <utility>

#include <heckbert/taxonomy/dialect_event.h>
#include <heckbert/taxonomy/dialect_text.h>

namespace heckbert::taxonomy {

namespace {

class DialectParser {
 public:
  DialectParser(ExpressionSource& source, const DialectFacts& dialect) : text_{source, dialect} {}

  DialectTree parse() {
    text_.trim();
    read_prefixes();
    if (text_.at_end()) {
      const bool is_directed = text_.dialect.orientation == Orientation::CameraFirst;
      text_.report(ErrorCode::EmptyText, text_.at, 1, {"expression", is_directed ? "CD*L" : "L D* E"});
      return std::move(text_.tree);
    }
    text_.tree.root = alternatives();
    report_wholes_inside(text_.tree.root, true);
    return std::move(text_.tree);
  }

 private:
  // ---- words before the expression ---------------------------------------------------------------------------------

  void read_prefixes() {
    for (;;) {
      std::size_t length = 0;
      while (is_lower(text_.peek(length))) ++length;
      if (length < 2) return;
      const std::string word = text_.source.text(text_.at, length);
      const std::vector<std::string> known = split_words(text_.dialect.prefixes);
      if (std::find(known.begin(), known.end(), word) == known.end()) {
        const std::string near = nearest(word, known);
        text_.report(ErrorCode::UnknownPrefix, text_.at, length, {text_.title(), quoted(word)},
                     near.empty() ? "" : did_you_mean(near));
      }
      text_.tree.prefixes.push_back(word);
      text_.at += length;
      if (text_.peek() == ':' || text_.peek() == ';') ++text_.at;
      while (!text_.at_end() && is_blank(text_.peek())) ++text_.at;
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
    if (!gave_up_) text_.report(ErrorCode::TooDeep, offset, 1, {std::to_string(kMaxDepth)});
    gave_up_ = true;
    text_.at = text_.end;
  }

  // a | b, where '|' binds loosest.
  Node alternatives() {
    Node first = text_.dialect.has_whole_operators ? sets() : sequence();
    if (text_.peek() != '|') return first;
    Node node{.kind = NodeKind::Alternation, .offset = first.offset};
    adopt(node, std::move(first));
    while (text_.peek() == '|') {
      ++text_.at;
      adopt(node, text_.dialect.has_whole_operators ? sets() : sequence());
    }
    return node;
  }

  Node sets() {
    Node left = complement();
    while (text_.peek() == '&' || text_.peek() == '-') {
      Node node{.kind = text_.peek() == '&' ? NodeKind::Both : NodeKind::Without, .offset = left.offset};
      ++text_.at;
      adopt(node, std::move(left));
      adopt(node, complement());
      left = std::move(node);
    }
    return left;
  }

  Node complement() {
    text_.skip_blanks();
    if (text_.peek() != '^') return sequence();
    Node node{.kind = NodeKind::Complement, .offset = text_.at};
    ++text_.at;
    if (++depth_ > kMaxDepth) give_up(node.offset);
    adopt(node, complement());
    --depth_;
    return node;
  }

  bool stops_sequence() const {
    const char c = text_.peek();
    return text_.at_end() || (c == ')' && open_ > 0) || (c == '|' && !text_.dialect.bar_binds_tightest) ||
           (text_.dialect.has_whole_operators && (c == '&' || c == '-'));
  }

  Node sequence() {
    text_.skip_blanks();
    Node node{.kind = NodeKind::Sequence, .offset = text_.at};
    while (!stops_sequence()) {
      adopt(node, text_.dialect.bar_binds_tightest ? choice() : repetition());
      text_.skip_blanks();
    }
    if (node.children.empty() && !gave_up_) {
      const bool in_union =
          text_.peek() == '|' || (text_.at > text_.source.begin && text_.source.document[text_.at - 1] == '|');
      const std::size_t culprit = std::min(text_.at, text_.end - 1);
      if (in_union)
        text_.report(ErrorCode::EmptyAlternative, culprit, 1);
      else
        text_.report(ErrorCode::PieceMissing, culprit, 1, {"a letter, '(', '[' or '<' here"});
    }
    if (node.children.size() == 1) return std::move(node.children[0]);
    return node;
  }

  // a | b, where '|' binds tightest: to the item before and the item behind, repetitions included.
  Node choice() {
    Node first = repetition();
    text_.skip_blanks();
    if (text_.peek() != '|') return first;
    Node node{.kind = NodeKind::Alternation, .offset = first.offset};
    adopt(node, std::move(first));
    while (text_.peek() == '|') {
      const std::size_t bar = text_.at++;
      text_.skip_blanks();
      if (stops_sequence() || text_.peek() == '|') {
        text_.report(ErrorCode::EmptyAlternative, bar, 1);
        break;
      }
      adopt(node, repetition());
      text_.skip_blanks();
    }
    return node;
  }

  Node repetition() {
    Node node = text_.peek() == '(' ? parentheses() : read_event(text_);
    for (std::size_t count = 0; text_.skip_blanks(), is_repetition(text_.peek()) && !text_.at_end(); ++count) {
      Node repeat{.kind = NodeKind::Repeat, .offset = node.offset};
      const std::size_t sign = text_.at;
      read_repetition(repeat);
      if (count > 0 && !text_.dialect.stacks_repetitions)
        text_.report(ErrorCode::SecondRepetition, sign, text_.at - sign, {text_.title()},
                     "put the item into parentheses: (" + text_.source.text(node.offset, sign - node.offset) + ")" +
                         text_.source.text(sign, text_.at - sign));
      adopt(repeat, std::move(node));
      repeat.length = text_.at - repeat.offset;
      node = std::move(repeat);
    }
    return node;
  }

  void read_repetition(Node& repeat) {
    const std::size_t sign = text_.at;
    const char c = text_.peek();
    ++text_.at;
    if (c == '*' || c == '+') {
      repeat.at_least = c == '+' ? 1 : 0;
    } else if (c == '?') {
      repeat.at_most = 1;
      if (text_.dialect.has_optional) return;
      if (text_.dialect.has_range)
        text_.report(ErrorCode::RepetitionUnavailable, sign, 1, {text_.title(), "'?'"}, Edit{sign, 1, "{0,1}"});
      else
        text_.report(ErrorCode::RepetitionUnavailable, sign, 1, {text_.title(), "'?'"},
                     "write both: the expression with the piece, and '|' without it");
    } else {
      read_count(repeat, sign);
    }
  }

  std::optional<unsigned> read_number() {
    text_.skip_blanks();
    if (!is_digit(text_.peek())) return std::nullopt;
    unsigned number = 0;
    for (; is_digit(text_.peek()); ++text_.at)
      number = std::min(number * 10 + static_cast<unsigned>(text_.peek() - '0'), kMaxCount + 1);
    return number;
  }

  void read_count(Node& repeat, std::size_t sign) {
    const auto least = read_number();
    text_.skip_blanks();
    const bool has_comma = text_.peek() == ',';
    if (has_comma) ++text_.at;
    const auto most = has_comma ? read_number() : least;
    text_.skip_blanks();
    if (text_.peek() != '}' || !least) {
      while (!text_.at_end() && text_.peek() != '}' && text_.peek() != ')' && text_.peek() != '|') ++text_.at;
      if (text_.peek() == '}') ++text_.at;
      return text_.report(ErrorCode::MalformedCount, sign, text_.at - sign);
    }
    ++text_.at;
    repeat.at_least = *least;
    repeat.at_most = most;
    const bool exists = !has_comma ? text_.dialect.has_exact : most ? text_.dialect.has_range : text_.dialect.has_open;
    if (!exists)
      text_.report(ErrorCode::RepetitionUnavailable, sign, text_.at - sign,
                   {text_.title(), "such count in its documents"}, "write the piece as often as needed");
    else if (*least > kMaxCount || most.value_or(0) > kMaxCount)
      text_.report(ErrorCode::CountTooGreat, sign, text_.at - sign, {std::to_string(kMaxCount)});
    else if (most && *most < *least)
      text_.report(ErrorCode::CountReversed, sign, text_.at - sign, {},
                   Edit{sign, text_.at - sign, "{" + std::to_string(*most) + "," + std::to_string(*least) + "}"});
    if (repeat.at_most) repeat.at_most = std::max(*repeat.at_most, repeat.at_least);
  }

  Node parentheses() {
    const std::size_t open = text_.at++;
    if (++depth_ > kMaxDepth) {
      give_up(open);
      return {};
    }
    ++open_;
    Node inner = alternatives();
    --open_;
    --depth_;
    if (text_.peek() == ')' && !text_.at_end())
      ++text_.at;
    else if (!gave_up_)
      text_.report(ErrorCode::NeverClosed, open, 1, {"'('", "')'"}, Edit{text_.end, 0, ")"});
    inner.offset = open;
    inner.length = text_.at - open;
    return inner;
  }

  void report_wholes_inside(const Node& node, bool is_whole) {
    const bool is_operator =
        node.kind == NodeKind::Complement || node.kind == NodeKind::Both || node.kind == NodeKind::Without;
    if (is_operator && !is_whole)
      return text_.report(ErrorCode::WholeInsidePath, node.offset, node.length,
                          {node.kind == NodeKind::Complement ? "'^'"
                           : node.kind == NodeKind::Both     ? "'&'"
                                                             : "'-'"});
    for (const Node& child : node.children)
      report_wholes_inside(child, is_whole && (is_operator || node.kind == NodeKind::Alternation));
  }

  DialectText text_;
  std::size_t depth_ = 0;
  std::size_t open_ = 0;
  bool gave_up_ = false;
};

}  // namespace

DialectTree parse_dialect(ExpressionSource& source, const DialectFacts& dialect) {
  return DialectParser(source, dialect).parse();
}

}  // namespace heckbert::taxonomy
