#include <heckbert/taxonomy/expression_ends.h>

#include <algorithm>

#include <heckbert/taxonomy/characters.h>

namespace heckbert::taxonomy {

namespace {

// Symbols that may stand at a place, and whether nothing may: the border of the word.
constexpr SymbolSet kBorder = 1u << kSymbolCount;

struct Shape {
  SymbolSet first = 0;
  SymbolSet last = 0;
  bool may_be_empty = false;
};

Shape shape(const Node& node) {
  Shape result;
  switch (node.kind) {
    case NodeKind::Letters:
      return {node.set.symbols(), node.set.symbols(), false};
    case NodeKind::Repeat:
      if (node.at_most == 0u) return {0, 0, true};
      result = shape(node.children[0]);
      result.may_be_empty = result.may_be_empty || node.at_least == 0;
      return result;
    case NodeKind::Alternation:
      for (const Node& child : node.children) {
        const Shape s = shape(child);
        result.first |= s.first;
        result.last |= s.last;
        result.may_be_empty = result.may_be_empty || s.may_be_empty;
      }
      return result;
    default:  // a sequence
      result.may_be_empty = true;
      for (const Node& child : node.children) {
        const Shape s = shape(child);
        if (result.may_be_empty) result.first |= s.first;
        result.last = static_cast<SymbolSet>(s.last | (s.may_be_empty ? result.last : 0));
        result.may_be_empty = result.may_be_empty && s.may_be_empty;
      }
      return result;
  }
}

class EndsCheck {
 public:
  EndsCheck(const Node& word, ExpressionSource& source) : word_(word), source_(source) {}

  std::optional<Direction> run() {
    const Shape s = shape(word_);
    const bool light_first = s.first & kLights, light_last = s.last & kLights;
    const bool eye_first = s.first & kEyes, eye_last = s.last & kEyes;
    const int forward = light_first + eye_last, backward = eye_first + light_last;
    if (word_.kind != NodeKind::Letters && forward == 1 && backward == 1 && light_first == light_last) {
      report_equal_ends(light_first ? "light ends (L)" : "eye ends (E)", light_first ? "E" : "L");
      return std::nullopt;
    }
    if (s.may_be_empty) {
      source_.report(ErrorCode::EmptyPath, word_.offset, word_.length, {},
                     forward + backward == 0 ? did_you_mean("L " + text(word_) + " E") : "");
      return std::nullopt;
    }
    const Direction direction = forward >= backward ? Direction::LightToEye : Direction::EyeToLight;
    const bool from_light = direction == Direction::LightToEye;
    begin_ = from_light ? kLights : kEyes;
    end_ = from_light ? kEyes : kLights;
    const std::string begin_letter = from_light ? "L" : "E", end_letter = from_light ? "E" : "L";

    const std::size_t errors_before = source_.errors.size();
    has_begin_ = (s.first & begin_) != 0;
    has_end_ = (s.last & end_) != 0;
    if (!has_begin_ || !has_end_) {
      const std::string missing = !has_begin_ && !has_end_   ? "no light end L and no eye end E"
                                  : has_begin_ == from_light ? "no eye end E"
                                                             : "no light end L";
      source_.report(
          ErrorCode::EndMissing, word_.offset, word_.length, {missing},
          did_you_mean((has_begin_ ? "" : begin_letter + " ") + text(word_) + (has_end_ ? "" : " " + end_letter)));
    }
    visit(word_, kBorder, kBorder);
    if (source_.errors.size() > errors_before) return std::nullopt;
    return direction;
  }

 private:
  std::string text(const Node& node) const { return source_.text(node.offset, node.length); }

  void report_equal_ends(const std::string& what, const std::string& other) {
    const Node* last = &word_;
    while (last->kind == NodeKind::Sequence) last = &last->children.back();
    source_.report(ErrorCode::EqualEnds, last->offset, last->length, {what}, "one of the two must be " + other);
  }

  // `before` and `after`: what may stand next to the words of this node in the words of the whole.
  void visit(const Node& node, SymbolSet before, SymbolSet after) {
    if (node.kind == NodeKind::Letters) return visit_letters(node, before, after);
    if (node.kind == NodeKind::Alternation) {
      for (const Node& child : node.children) visit(child, before, after);
    } else if (node.kind == NodeKind::Repeat) {
      if (node.at_most == 0u) return;
      const Shape s = shape(node.children[0]);
      const bool once = node.at_most == 1u;
      visit(node.children[0], static_cast<SymbolSet>(once ? before : before | s.last),
            static_cast<SymbolSet>(once ? after : after | s.first));
    } else if (node.kind == NodeKind::Sequence) {
      visit_sequence(node.children, before, after);
    }
  }

  void visit_sequence(const std::vector<Node>& children, SymbolSet before, SymbolSet after) {
    std::vector<SymbolSet> after_child(children.size());
    for (std::size_t i = children.size(); i-- > 0;) {
      after_child[i] = after;
      const Shape s = shape(children[i]);
      after = static_cast<SymbolSet>(s.first | (s.may_be_empty ? after : 0));
    }
    for (std::size_t i = 0; i < children.size(); ++i) {
      visit(children[i], before, after_child[i]);
      const Shape s = shape(children[i]);
      before = static_cast<SymbolSet>(s.last | (s.may_be_empty ? before : 0));
    }
  }

  void visit_letters(const Node& node, SymbolSet before, SymbolSet after) {
    const std::string letter = quoted(text(node));
    const auto complain = [&](std::string_view where, SymbolSet expected) {
      source_.report(ErrorCode::EventAtEnd, node.offset, node.length, {letter, where, describe(expected)});
    };
    const bool begins = before & kBorder, ends = after & kBorder;
    const bool follows = before & ~kBorder, is_followed = after & ~kBorder;
    const SymbolSet set = node.set.symbols();
    if ((set & begin_ && follows) || (set & end_ && is_followed))
      return source_.report(ErrorCode::EndInside, node.offset, node.length, {letter});
    // A path that lacks an end everywhere has been reported as a whole.
    if (has_begin_ && begins && set & ~begin_) complain("beginning", begin_);
    if (has_end_ && ends && set & ~end_) complain("end", end_);
  }

  const Node& word_;
  ExpressionSource& source_;
  SymbolSet begin_ = 0, end_ = 0;
  bool has_begin_ = false, has_end_ = false;
};

}  // namespace

std::optional<Direction> check_ends(const Node& word, ExpressionSource& source) {
  return EndsCheck(word, source).run();
}

}  // namespace heckbert::taxonomy
