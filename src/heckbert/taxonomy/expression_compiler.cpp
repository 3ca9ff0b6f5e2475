#include <heckbert/taxonomy/expression_compiler.h>

#include <algorithm>
#include <deque>
#include <utility>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/expression_ends.h>
#include <heckbert/taxonomy/expression_parser.h>
#include <heckbert/taxonomy/joins.h>
#include <heckbert/taxonomy/tree_language.h>

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
    return place_limits(node, [&] { return unplaced(node); });
  }

 private:
  Language unplaced(const Node& node) {
    switch (node.kind) {
      case NodeKind::Name:
        return named(node);
      case NodeKind::Complement:
        return !whole(node.children[0]);
      case NodeKind::Both: {
        const Language left = whole(node.children[0]), right = whole(node.children[1]);
        return left & right;
      }
      case NodeKind::Without: {
        const Language left = whole(node.children[0]), right = whole(node.children[1]);
        return left - right;
      }
      case NodeKind::Alternation: {
        std::deque<Language> languages;
        std::vector<const Language*> parts;
        for (const Node& child : node.children) parts.push_back(&languages.emplace_back(whole(child)));
        return unite(parts);
      }
      default:
        return word(node);
    }
  }

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
    return language_of(*direction == Direction::EyeToLight ? reversed(node) : node);
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

  ExpressionSource& source_;
  const Names& names_;
};

}  // namespace

std::optional<Language> compile(ExpressionSource& source, const Names& names) {
  const Node tree = parse_expression(source);
  const WorkLimit limit(kCompileSteps);
  try {
    Language language = Compiler(source, names).whole(tree);
    if (!source.errors.empty()) return std::nullopt;
    return language;
  } catch (const PlacedLimitError& error) {
    throw_too_large(source, error);
  }
}

Language compile(std::string_view text, const Names& names, std::string_view source) {
  ExpressionSource s{source, text, 0, text.size(), {}};
  auto language = compile(s, names);
  if (!language) {
    sort_by_place(s.errors);
    throw InputError(std::move(s.errors));
  }
  return std::move(*language);
}

}  // namespace heckbert::taxonomy
