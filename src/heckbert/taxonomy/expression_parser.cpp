#include <heckbert/taxonomy/expression_parser.h>

#include <algorithm>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/expression_tokens.h>

namespace heckbert::taxonomy {

namespace {

class Parser {
 public:
  explicit Parser(ExpressionSource& source) : source_(source), tokens_(read_tokens(source)) {}

  Node parse() {
    if (peek().kind == TokenKind::End) {
      source_.report(ErrorCode::EmptyText, source_.begin, 1, {"expression", "L D* E"});
      return {};
    }
    Node node = parse_union();
    if (gave_up_) return {};
    return node;
  }

 private:
  const Token& peek() const { return tokens_[at_]; }
  const Token& next() { return tokens_[at_++]; }
  bool accept(TokenKind kind) {
    if (peek().kind != kind) return false;
    ++at_;
    return true;
  }
  void report(ErrorCode code, const Token& token, std::initializer_list<std::string_view> values = {},
              std::string suggestion = {}) {
    source_.report(code, token.offset, token.length, values, std::move(suggestion));
  }
  std::string text(const Token& token) const { return source_.text(token.offset, token.length); }

  static bool starts_atom(const Token& t) {
    return t.kind == TokenKind::Letters || t.kind == TokenKind::Open || t.kind == TokenKind::Name ||
           t.kind == TokenKind::Bad;
  }

  void adopt(Node& parent, Node child) {
    parent.height = std::max(parent.height, child.height + 1);
    if (parent.height > kMaxDepth) give_up(tokens_[at_ - 1]);
    parent.children.push_back(std::move(child));
  }

  Node join(NodeKind kind, Node a, Node b) {
    Node node{.kind = kind, .offset = a.offset, .length = b.offset + b.length - a.offset};
    adopt(node, std::move(a));
    adopt(node, std::move(b));
    return node;
  }

  Node parse_union() {
    Node first = parse_sets();
    if (peek().kind != TokenKind::Bar) return first;
    Node node{.kind = NodeKind::Alternation, .offset = first.offset};
    adopt(node, std::move(first));
    while (accept(TokenKind::Bar)) adopt(node, parse_sets());
    node.length = node.children.back().offset + node.children.back().length - node.offset;
    return node;
  }

  Node parse_sets() {
    Node left = parse_complement();
    for (;;) {
      if (accept(TokenKind::And))
        left = join(NodeKind::Both, std::move(left), parse_complement());
      else if (accept(TokenKind::Minus))
        left = join(NodeKind::Without, std::move(left), parse_complement());
      else
        return left;
    }
  }

  Node parse_complement() {
    if (peek().kind != TokenKind::Not) return parse_sequence();
    const Token& sign = next();
    if (++depth_ > kMaxDepth) return give_up(sign);
    Node inner = parse_complement();
    --depth_;
    Node node{.kind = NodeKind::Complement, .offset = sign.offset, .length = inner.offset + inner.length - sign.offset};
    adopt(node, std::move(inner));
    return node;
  }

  Node parse_sequence() {
    Node node{.kind = NodeKind::Sequence, .offset = peek().offset};
    for (;;) {
      if (starts_atom(peek())) {
        adopt(node, parse_repetition());
      } else if (peek().kind == TokenKind::Repeat) {
        report(ErrorCode::NothingToRepeat, peek(), {quoted(text(peek()))});
        next();
        adopt(node, {});
      } else if (peek().kind == TokenKind::Not && !node.children.empty()) {
        report(ErrorCode::WholeInsidePath, peek(), {"'!'"}, "an event other than S is written [^S]");
        next();
      } else if (peek().kind == TokenKind::Close && open_groups_ == 0) {
        report(ErrorCode::ClosesNothing, peek(), {"')'"});
        next();
      } else {
        break;
      }
    }
    if (node.children.empty()) return report_missing();
    if (node.children.size() == 1 && node.children[0].kind != NodeKind::Bad) return std::move(node.children[0]);
    const Token& last = tokens_[at_ - 1];
    node.length = last.offset + last.length - node.offset;
    return node;
  }

  Node parse_repetition() {
    Node node = parse_atom();
    while (peek().kind == TokenKind::Repeat) {
      const Token& sign = next();
      Node repeat{.kind = NodeKind::Repeat,
                  .offset = node.offset,
                  .length = sign.offset + sign.length - node.offset,
                  .at_least = sign.at_least,
                  .at_most = sign.at_most};
      adopt(repeat, std::move(node));
      node = std::move(repeat);
    }
    return node;
  }

  Node parse_atom() {
    const Token& token = next();
    Node node{.offset = token.offset, .length = token.length};
    if (token.kind == TokenKind::Letters) {
      node.kind = NodeKind::Letters;
      node.set = token.set;
    } else if (token.kind == TokenKind::Name) {
      node.kind = NodeKind::Name;
      node.name = source_.text(token.offset + 1, token.length - 1);
    } else if (token.kind == TokenKind::Open) {
      return parse_group(token);
    }
    return node;
  }

  Node parse_group(const Token& open) {
    if (accept(TokenKind::Close)) {
      source_.report(ErrorCode::EmptyParentheses, open.offset, tokens_[at_ - 1].offset + 1 - open.offset, {},
                     "a piece that may be missing is written (...)?");
      return {};
    }
    if (++depth_ > kMaxDepth) return give_up(open);
    ++open_groups_;
    Node inner = parse_union();
    --open_groups_;
    --depth_;
    if (peek().kind == TokenKind::Close) {
      const Token& close = next();
      inner.offset = open.offset;
      inner.length = close.offset + close.length - open.offset;
      return inner;
    }
    if (!gave_up_) report(ErrorCode::NeverClosed, open, {"'('", "')'"});
    return {};
  }

  // The rest is skipped; what follows would only repeat the same error.
  Node give_up(const Token& culprit) {
    if (!gave_up_) report(ErrorCode::TooDeep, culprit, {std::to_string(kMaxDepth)});
    gave_up_ = true;
    at_ = tokens_.size() - 1;
    return {};
  }

  Node report_missing() {
    if (gave_up_) return {};
    const TokenKind before = at_ == 0 ? TokenKind::End : tokens_[at_ - 1].kind;
    const bool in_union = before == TokenKind::Bar || peek().kind == TokenKind::Bar;
    const Token& culprit = before == TokenKind::Bar ? tokens_[at_ - 1] : peek();
    if (in_union)
      report(ErrorCode::EmptyAlternative, culprit, {}, "a piece that may be missing is written with '?'");
    else if (before == TokenKind::And || before == TokenKind::Minus || before == TokenKind::Not)
      report(ErrorCode::PieceMissing, tokens_[at_ - 1], {"a whole expression after " + quoted(text(tokens_[at_ - 1]))});
    else if (peek().kind == TokenKind::And || peek().kind == TokenKind::Minus)
      report(ErrorCode::PieceMissing, peek(), {"a whole expression before " + quoted(text(peek()))});
    else
      report(ErrorCode::PieceMissing, peek(), {"a letter, '(' or '@name' here"});
    return {};
  }

  ExpressionSource& source_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::size_t open_groups_ = 0;
  bool gave_up_ = false;
};

}  // namespace

Node parse_expression(ExpressionSource& source) {
  return Parser(source).parse();
}

}  // namespace heckbert::taxonomy
