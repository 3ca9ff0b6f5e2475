#include <heckbert/taxonomy/expression_compiler.h>

#include <algorithm>
#include <utility>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/expression_ends.h>
#include <heckbert/taxonomy/expression_parser.h>

namespace heckbert::taxonomy {

namespace {

bool has_bad_node(const Node& node) {
  return node.kind == NodeKind::Bad || std::any_of(node.children.begin(), node.children.end(), has_bad_node);
}

class Compiler {
 public:
  Compiler(ExpressionSource& source, const Names& names) : source_(source), names_(names) {}

  // Expressions of whole paths. Every operand is compiled even after an error, so that all errors are found.
  Language whole(const Node& node) {
    switch (node.kind) {
      case NodeKind::Name:
        return named(node);
      case NodeKind::Complement: {
        const Language inner = whole(node.children[0]);
        return within_budget(node, [&] { return !inner; });
      }
      case NodeKind::Both: {
        const Language left = whole(node.children[0]), right = whole(node.children[1]);
        return within_budget(node, [&] { return left & right; });
      }
      case NodeKind::Without: {
        const Language left = whole(node.children[0]), right = whole(node.children[1]);
        return within_budget(node, [&] { return left - right; });
      }
      case NodeKind::Alternation: {
        std::vector<Language> languages;
        for (const Node& child : node.children) languages.push_back(whole(child));
        return within_budget(node, [&] { return unite(languages, 0, languages.size()); });
      }
      default:
        return word(node);
    }
  }

 private:
  Language named(const Node& node) {
    if (names_.find)
      if (auto language = names_.find(node.name)) return *language;
    if (const std::string why = names_.why_none ? names_.why_none(node.name) : ""; !why.empty()) {
      source_.report(ErrorCode::NoLanguage, node.offset, node.length, {why});
      return {};
    }
    std::string suggestion;
    // "@a-LDE" reads as one name; the longest known beginning is what was meant.
    for (std::size_t dash = node.name.rfind('-'); dash != std::string::npos && dash > 0 && suggestion.empty();
         dash = node.name.rfind('-', dash - 1)) {
      const std::string left = node.name.substr(0, dash);
      if (std::find(names_.known.begin(), names_.known.end(), left) != names_.known.end())
        suggestion = "a name may contain '-'; " + did_you_mean("@" + left + " - " + node.name.substr(dash + 1));
    }
    const std::string near = nearest(node.name, names_.known);
    if (suggestion.empty() && !near.empty()) suggestion = did_you_mean("@" + near);
    source_.report(ErrorCode::UnknownName, node.offset, node.length, {quoted(node.name)}, suggestion);
    return {};
  }

  // Words that run one way or the other, from letters.
  Language word(const Node& node) {
    const std::size_t errors_before = source_.errors.size();
    report_wholes_within(node);
    if (source_.errors.size() > errors_before || has_bad_node(node)) return {};
    const auto direction = check_ends(node, source_);
    // Automata of an expression with errors would be thrown away.
    if (!direction || !source_.errors.empty()) return {};
    return fragment(node, *direction == Direction::EyeToLight);
  }

  void report_wholes_within(const Node& node) {
    const auto complain = [&](std::string_view what, const std::string& suggestion) {
      source_.report(ErrorCode::WholeInsidePath, node.offset, node.length, {what}, suggestion);
    };
    switch (node.kind) {
      case NodeKind::Name:
        return complain(quoted("@" + node.name), "combine whole paths with | & - !");
      case NodeKind::Complement:
        return complain("'!'", "an event other than S is written [^S]");
      case NodeKind::Both:
        return complain("'&'", "write (L..E) & (L..E)");
      case NodeKind::Without:
        return complain("'-'", "an event other than S is written [^S]");
      default:
        for (const Node& child : node.children) report_wholes_within(child);
    }
  }

  // The words of a piece of a path; `reversed` turns them round, which costs nothing on the tree.
  Language fragment(const Node& node, bool reversed) {
    if (node.kind == NodeKind::Letters) return Language::of(node.set);
    if (node.kind == NodeKind::Repeat) {
      const Language inner = fragment(node.children[0], reversed);
      return within_budget(node, [&] { return repeat(inner, node.at_least, node.at_most); });
    }
    std::vector<Language> pieces;
    for (const Node& child : node.children) pieces.push_back(fragment(child, reversed));
    if (node.kind == NodeKind::Alternation) return within_budget(node, [&] { return unite(pieces, 0, pieces.size()); });
    return chain(node.children, pieces, 0, pieces.size(), reversed);
  }

  // Halves first: a word of n letters costs O(n log n), not O(n^2).
  static Language unite(const std::vector<Language>& pieces, std::size_t begin, std::size_t end) {
    if (end - begin == 1) return pieces[begin];
    const std::size_t middle = begin + (end - begin) / 2;
    return unite(pieces, begin, middle) | unite(pieces, middle, end);
  }

  static Language concat_in_order(const Language& left, const Language& right, bool reversed) {
    return reversed ? concat(right, left) : concat(left, right);
  }

  Language chain(const std::vector<Node>& nodes, const std::vector<Language>& pieces, std::size_t begin,
                 std::size_t end, bool reversed) {
    if (end - begin == 1) return pieces[begin];
    const std::size_t middle = begin + (end - begin) / 2;
    const Language left = chain(nodes, pieces, begin, middle, reversed);
    const Language right = chain(nodes, pieces, middle, end, reversed);
    try {
      return concat_in_order(left, right, reversed);
    } catch (const LimitError& e) {
      report_chain(nodes, pieces, begin, middle, end, reversed, e);
    }
  }

  // Both halves fit and the whole does not: the culprit is the shortest run of pieces across the middle that does not
  // fit either, looked for only where looking is quick.
  [[noreturn]] void report_chain(const std::vector<Node>& nodes, const std::vector<Language>& pieces, std::size_t begin,
                                 std::size_t middle, std::size_t end, bool reversed, const LimitError& error) {
    const auto fits = [&](std::size_t from, std::size_t to) {
      try {
        Language run = pieces[from];
        for (std::size_t i = from + 1; i < to; ++i) run = concat_in_order(run, pieces[i], reversed);
        return true;
      } catch (const LimitError&) {
        return false;
      }
    };
    constexpr std::size_t kQuick = 8;
    if (end - begin <= kQuick) {
      std::size_t from = middle - 1;
      while (from > begin && fits(from, end)) --from;
      std::size_t to = middle + 1;
      while (to < end && fits(from, to)) ++to;
      begin = from;
      end = to;
    }
    const std::size_t last = nodes[end - 1].offset + nodes[end - 1].length;
    throw_placed(nodes[begin].offset, last - nodes[begin].offset, error);
  }

  template <class Build>
  Language within_budget(const Node& node, Build build) {
    try {
      return build();
    } catch (const LimitError& e) {
      throw_placed(node.offset, node.length, e);
    }
  }

  [[noreturn]] void throw_placed(std::size_t offset, std::size_t length, const LimitError& error) {
    constexpr std::size_t kShown = 60;
    std::string text = source_.text(offset, std::min(length, kShown));
    if (length > kShown) text += "...";
    const bool is_counting = text.find('{') != std::string::npos;
    std::string message = format(diagnose(ErrorCode::TooLarge, source_.name, source_.document, offset, length,
                                          {quoted(text), error.what()},
                                          is_counting ? "lower a count, or take away a '*' or '+' beside one"
                                                      : "split the expression into smaller ones"));
    message.pop_back();  // the newline
    throw LimitError(message);
  }

  ExpressionSource& source_;
  const Names& names_;
};

}  // namespace

std::optional<Language> compile(ExpressionSource& source, const Names& names) {
  const Node tree = parse_expression(source);
  Language language = Compiler(source, names).whole(tree);
  if (!source.errors.empty()) return std::nullopt;
  return language;
}

Language compile(std::string_view text, const Names& names, std::string_view source) {
  ExpressionSource s{source, text, 0, text.size(), {}};
  auto language = compile(s, names);
  if (!language) {
    std::stable_sort(s.errors.begin(), s.errors.end(), [](const Diagnostic& a, const Diagnostic& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    throw InputError(std::move(s.errors));
  }
  return std::move(*language);
}

}  // namespace heckbert::taxonomy
