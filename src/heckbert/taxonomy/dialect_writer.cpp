#include <algorithm>
#include <utility>

#include <heckbert/taxonomy/dialect_letters.h>
#include <heckbert/taxonomy/dialect_printer.h>
#include <heckbert/taxonomy/dialect_reader.h>
#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/regular_expression.h>
#include <heckbert/taxonomy/simplest.h>
#include <heckbert/taxonomy/tree_language.h>

namespace heckbert::taxonomy {

namespace {

// ---- what a dialect cannot say --------------------------------------------------------------------------------------

/// The finest things a dialect can say, each a set of symbols; whatever it says is a union of them.
std::vector<SymbolSet> items_of(const DialectFacts& dialect) {
  std::vector<SymbolSet> items{with_letter('V')};
  if (!dialect.has_groups) {
    for (const SymbolFacts& f : kSymbols) items.push_back(single(f.symbol));
    return items;
  }
  items.push_back(kEyes);
  for (const LightLetter& light : dialect.lights) items.push_back(symbols_of(light));
  for (const KindLetter& kind : dialect.kinds)
    for (const char mode : {'r', 't'}) items.push_back(symbols_of(kind) & with_mode(mode));
  return items;
}

/// Every item that has a has b too.
bool implies(const std::vector<SymbolSet>& items, Symbol a, Symbol b) {
  return std::all_of(items.begin(), items.end(), [&](SymbolSet item) { return !has(item, a) || has(item, b); });
}

std::array<Symbol, kSymbolCount> mapping(Symbol from, Symbol to) {
  std::array<Symbol, kSymbolCount> h;
  for (const SymbolFacts& f : kSymbols) h[index(f.symbol)] = f.symbol;
  h[index(from)] = to;
  return h;
}

Word mapped(Word word, Symbol from, Symbol to) {
  if (word.light == from) word.light = to;
  if (word.eye == from) word.eye = to;
  std::replace(word.events.begin(), word.events.end(), from, to);
  return word;
}

/// For a sentence: a long word without its middle.
std::string shown(const Word& word) {
  constexpr std::size_t kLongest = 60, kKept = 20;
  std::string text = fine(word);
  if (text.size() <= kLongest) return text;
  return text.substr(0, kKept) + "..." + text.substr(text.size() - kKept);
}

std::string why_not(const Language& language, const DialectFacts& dialect) {
  const std::vector<SymbolSet> items = items_of(dialect);
  const std::string title(dialect.title);
  for (const SymbolFacts& a : kSymbols)
    for (const SymbolFacts& b : kSymbols) {
      if (a.symbol == b.symbol || a.role != b.role || !implies(items, a.symbol, b.symbol)) continue;
      const Language with_b = inverse_image(language, mapping(a.symbol, b.symbol));
      const bool alike = implies(items, b.symbol, a.symbol);
      std::optional<Word> word = witness_outside(language, with_b);
      const bool is_in = word.has_value();
      if (!word && alike) word = witness_outside(with_b, language);
      if (!word) continue;
      const std::string one = shown(*word), other = shown(mapped(*word, a.symbol, b.symbol));
      return (is_in ? one : other) + " is in it and " + (is_in ? other : one) + " is not, and " + title +
             (alike ? " cannot tell " : " cannot say ") + name(a.symbol) + (alike ? " from " : " without ") +
             name(b.symbol);
    }
  return "";
}

// ---- writing --------------------------------------------------------------------------------------------------------

std::string empty_text(const DialectFacts& dialect) {
  const std::string path = dialect.orientation == Orientation::Either ? "LE" : "CL";
  return path + "-" + path;
}

/// `tree` from light to eye in the dialect, when it is read there as exactly the language.
std::optional<std::string> checked(const Node& tree, const Language& language, Dialect dialect) {
  const bool from_eye = facts(dialect).orientation == Orientation::CameraFirst;
  auto text = print(from_eye ? reversed(tree) : tree, facts(dialect));
  if (!text) return std::nullopt;
  try {
    if (read_expression(*text, dialect).language == language) return text;
  } catch (const InputError&) {
    // '.' of a dialect that counts the ends among its events, say; the automaton knows better.
  }
  return std::nullopt;
}

/// The text, when it is read in the dialect as exactly the language.
std::optional<std::string> checked(std::optional<std::string> text, const Language& language, Dialect dialect) {
  return text && read_expression(*text, dialect).language == language ? std::move(text) : std::nullopt;
}

/// The shortest that is known without operators on whole paths.
std::optional<std::string> path_text(const Language& language, Dialect dialect) {
  std::optional<std::string> best;
  const auto offer = [&](const std::optional<Node>& made) {
    auto text = made ? checked(*made, language, dialect) : std::nullopt;
    if (text && (!best || text->size() < best->size())) best = std::move(text);
  };
  if (const auto text = simplest_expression(language)) offer(read_with_tree(*text, Dialect::Heckbert, {}, "").tree);
  // From the eye, lights differ at the end only, where letters such as L and O that share symbols can be joined.
  if (!best)
    if (auto made = regular_expression(reverse(language))) offer(reversed(std::move(*made)));
  return best;
}

/// One path without operators at its top, or else in parentheses.
std::string operand(const std::string& text) {
  int depth = 0;
  bool is_path = text.front() != '!' && text.front() != '^';
  for (const char c : text) {
    depth += c == '(' || c == '[';
    depth -= c == ')' || c == ']';
    is_path = is_path && (depth > 0 || (c != '|' && c != '&' && c != '-'));
  }
  return is_path ? text : "(" + text + ")";
}

class Writer {
 public:
  Writer(Dialect dialect, const Names& names) : dialect_(dialect), target_(facts(dialect)), names_(names) {}

  /// `tree`, when there is one, is how the language was written, and is kept where the dialect can say it.
  Writing write(const Language& language, const Node* tree) const {
    const std::string title(target_.title);
    if (language.is_empty()) {
      if (target_.has_whole_operators) return {empty_text(target_), ""};
      return {"", "no path is in it, and " + title + " has no expression for that"};
    }
    if (tree != nullptr)
      if (auto text = as_written(*tree, language)) return {std::move(*text), ""};
    if (std::string reason = why_not(language, target_); !reason.empty()) return {"", std::move(reason)};
    std::optional<std::string> best = path_text(language, dialect_);
    if (target_.has_whole_operators)
      if (const auto rest = path_text(!language, dialect_); rest && (!best || rest->size() + 3 < best->size()))
        best = complement_sign() + operand(*rest);
    if (best) return {std::move(*best), ""};
    return {"", "an expression of " + title + " for it would be longer than anybody reads"};
  }

 private:
  std::string complement_sign() const { return dialect_ == Dialect::Heckbert ? "!" : "^"; }

  std::optional<std::string> as_written(const Node& tree, const Language& language) const {
    if (is_word_tree(tree)) return checked(tree, language, dialect_);
    if (!target_.has_whole_operators) return std::nullopt;
    return checked(with_operators(tree), language, dialect_);
  }

  /// Nothing when some part of it cannot be said.
  std::optional<std::string> with_operators(const Node& tree) const {
    const auto known = [](Writing written) {
      return written.text.empty() ? std::nullopt : std::optional(std::move(written.text));
    };
    if (is_word_tree(tree)) return known(write(language_of(tree) & Language::universe(), &tree));
    if (tree.kind == NodeKind::Name) return known(write(names_.find(tree.name).value(), nullptr));
    std::string text;
    for (const Node& child : tree.children) {
      const auto part = with_operators(child);
      if (!part) return std::nullopt;
      if (!text.empty()) text += sign(tree.kind);
      text += operand(*part);
    }
    return tree.kind == NodeKind::Complement ? complement_sign() + text : text;
  }

  static std::string_view sign(NodeKind kind) {
    return kind == NodeKind::Both ? " & " : kind == NodeKind::Without ? " - " : " | ";
  }

  Dialect dialect_;
  const DialectFacts& target_;
  const Names& names_;
};

}  // namespace

Writing write_expression(const Language& language, Dialect dialect) {
  return Writer(dialect, {}).write(language, nullptr);
}

Translation translate(std::string_view text, Dialect from, Dialect to, const Names& names, std::string_view source) {
  ReadingWithTree read = read_with_tree(text, from, names, source);
  Translation result;
  result.writing = Writer(to, names).write(read.reading.language, read.tree ? &*read.tree : nullptr);
  result.reading = std::move(read.reading);
  try {
    const Language there = read_expression(text, to, names, source).language;
    const auto here_only = witness_outside(result.reading.language, there);
    const auto there_only = witness_outside(there, result.reading.language);
    result.only_in_from = here_only && (!there_only || *here_only < *there_only);
    result.differs_on = result.only_in_from ? here_only : there_only;
  } catch (const InputError&) {
    // The text is no expression of the other dialect, so nobody mistakes it for one.
  }

  std::string prefixes;
  const std::string_view known = facts(to).prefixes;
  for (const std::string& prefix : result.reading.prefixes) {
    const bool exists = (" " + std::string(known) + " ").find(" " + prefix + " ") != std::string::npos;
    // "lpe:" only says that an expression follows.
    if (exists)
      prefixes += prefix + (prefix == "lpe" ? ":" : ";");
    else if (prefix != "lpe")
      result.writing = {"", std::string(facts(to).title) + " has no prefix '" + prefix + "'"};
  }
  if (!result.writing.text.empty()) result.writing.text.insert(0, prefixes);
  return result;
}

}  // namespace heckbert::taxonomy
