#include <heckbert/taxonomy/dialect_reader.h>

#include <algorithm>
#include <deque>
#include <utility>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/dialect_parser.h>
#include <heckbert/taxonomy/expression_ends.h>
#include <heckbert/taxonomy/expression_parser.h>
#include <heckbert/taxonomy/joins.h>
#include <heckbert/taxonomy/tree_language.h>

namespace heckbert::taxonomy {

namespace {

ExpressionSource source_of(std::string_view name, std::string_view text) {
  return {name, text, 0, text.size(), {}};
}

// The tree with its words from light to eye; nothing when the dialect leaves the direction open and the words of one
// of its word trees do not all run the same way.
std::optional<Node> from_light(const Node& tree, Orientation orientation, const ExpressionSource& source) {
  if (!is_word_tree(tree)) {
    Node turned = tree;
    for (Node& child : turned.children) {
      auto one = from_light(child, orientation, source);
      if (!one) return std::nullopt;
      child = std::move(*one);
    }
    return turned;
  }
  if (orientation == Orientation::CameraFirst) return reversed(tree);
  ExpressionSource unreported = source_of(source.name, source.document);
  const auto direction = check_ends(tree, unreported);
  if (!direction) return std::nullopt;
  return *direction == Direction::EyeToLight ? reversed(tree) : tree;
}

Language paths(const Node& tree, Orientation orientation, const ExpressionSource& source);

Language paths_unplaced(const Node& tree, Orientation orientation, const ExpressionSource& source) {
  switch (tree.kind) {
    case NodeKind::Complement:
      return !paths(tree.children[0], orientation, source);
    case NodeKind::Both:
      return paths(tree.children[0], orientation, source) & paths(tree.children[1], orientation, source);
    case NodeKind::Without:
      return paths(tree.children[0], orientation, source) - paths(tree.children[1], orientation, source);
    case NodeKind::Alternation:
      if (!is_word_tree(tree)) {
        std::deque<Language> languages;
        std::vector<const Language*> parts;
        for (const Node& child : tree.children)
          parts.push_back(&languages.emplace_back(paths(child, orientation, source)));
        return unite(parts);
      }
      break;
    default:
      break;
  }
  const auto within_universe = [](const Node& node) { return language_of(node) & Language::universe(); };
  if (const auto word = from_light(tree, orientation, source)) return within_universe(*word);
  return within_universe(tree) | within_universe(reversed(tree));
}

// The language of a tree as written, cut down to whole paths.
Language paths(const Node& tree, Orientation orientation, const ExpressionSource& source) {
  return place_limits(tree, [&] { return paths_unplaced(tree, orientation, source); });
}

// The text with all edits made; nothing when two of them touch.
std::optional<std::string> edited(std::string_view text, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.offset < b.offset; });
  std::string result;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    if (edit.offset < at) return std::nullopt;
    result += text.substr(at, edit.offset - at);
    result += edit.replacement;
    at = edit.offset + edit.length;
  }
  result += text.substr(at);
  return result;
}

void propose_repair(ExpressionSource& source, const DialectTree& parsed, const DialectFacts& dialect) {
  if (!parsed.is_repairable) return;
  const auto repaired = edited(source.document, parsed.edits);
  if (!repaired) return;
  ExpressionSource again = source_of(source.name, *repaired);
  parse_dialect(again, dialect);
  if (again.errors.empty()) source.errors.back().suggestion = did_you_mean(*repaired);
}

ReadingWithTree read_heckbert(std::string_view text, const Names& names, std::string_view name) {
  ReadingWithTree result{{compile(text, names, name), {}, {}}, {}};
  ExpressionSource source = source_of(name, text);
  result.tree = from_light(parse_expression(source), Orientation::Either, source);
  return result;
}

}  // namespace

ReadingWithTree read_with_tree(std::string_view text, Dialect dialect, const Names& names, std::string_view name) {
  if (dialect == Dialect::Heckbert) return read_heckbert(text, names, name);
  const DialectFacts& facts_of_dialect = facts(dialect);
  ExpressionSource source = source_of(name, text);
  DialectTree parsed = parse_dialect(source, facts_of_dialect);
  if (!source.errors.empty()) {
    propose_repair(source, parsed, facts_of_dialect);
    sort_by_place(source.errors);
    throw InputError(std::move(source.errors));
  }
  ReadingWithTree result;
  result.reading.prefixes = std::move(parsed.prefixes);
  result.reading.warnings = std::move(parsed.warnings);
  const Orientation orientation = facts_of_dialect.orientation;
  const WorkLimit limit(kCompileSteps);
  try {
    result.reading.language = paths(parsed.root, orientation, source);
    result.tree = from_light(parsed.root, orientation, source);
  } catch (const PlacedLimitError& error) {
    throw_too_large(source, error);
  }
  if (result.reading.language.is_empty())
    result.reading.warnings.push_back(
        diagnose(ErrorCode::NoPath, name, text, 0, text.size(), {facts_of_dialect.title},
                 "a path has both its ends, the eye " + std::string(1, facts_of_dialect.eyes[0]) + " and a light"));
  return result;
}

Reading read_expression(std::string_view text, Dialect dialect, const Names& names, std::string_view source) {
  return read_with_tree(text, dialect, names, source).reading;
}

}  // namespace heckbert::taxonomy
