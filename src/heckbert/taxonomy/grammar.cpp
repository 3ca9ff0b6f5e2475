#include <heckbert/taxonomy/grammar.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <tuple>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression_compiler.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

namespace {

// The keys of a grammar file. Algorithms need all but bias and notes; classes have no expression-delta.
enum class Key : std::uint8_t { Kind, Name, Title, Order, Source, Expression, ExpressionDelta, Bias, Notes };
constexpr std::array<std::string_view, 9> kKeys{
    "kind", "name", "title", "order", "source", "expression", "expression-delta", "bias", "notes"};

constexpr std::string_view kNoPath = "none";

std::string_view key_name(Key key) {
  return kKeys[static_cast<std::size_t>(key)];
}
std::string quoted(std::string_view text) {
  return "'" + std::string(text) + "'";
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '\n')) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\n')) text.remove_suffix(1);
  return text;
}

/// A key and its value as they stand in the file; the value may span lines.
struct Field {
  Key key;
  std::size_t key_offset;
  std::size_t begin;
  std::size_t end;
};

class GrammarReader {
 public:
  GrammarReader(std::string_view text, std::string_view source) : text_(text), source_(source) {
    read_fields();
    read_facts();
  }

  // What decides the place of the grammar among others; known before any expression is compiled.
  const Grammar& facts() const { return grammar_; }
  std::vector<Diagnostic>& errors() { return errors_; }

  Grammar finish(const GrammarLibrary& library) {
    if (const Field* name = find(Key::Name); name != nullptr && library.find(grammar_.name) != nullptr)
      report(name->begin, name->end - name->begin, "the name " + quoted(grammar_.name) + " is taken");
    const Language hit = compile_field(Key::Expression, library);
    if (grammar_.kind == GrammarKind::Class) {
      grammar_.language = hit;
    } else {
      const Language delta = compile_field(Key::ExpressionDelta, library);
      grammar_.language = (hit & lit_by({Symbol::La, Symbol::Le})) | (delta & lit_by({Symbol::Lp, Symbol::Ld}));
    }
    return grammar_;
  }

 private:
  void report(std::size_t offset, std::size_t length, std::string message, std::string suggestion = {}) {
    errors_.push_back(diagnose(source_, text_, offset, length, std::move(message), std::move(suggestion)));
  }

  void read_fields() {
    for (std::size_t begin = 0; begin < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      read_line(begin, end);
      begin = end + 1;
    }
  }

  void read_line(std::size_t begin, std::size_t end) {
    const std::string_view line = text_.substr(begin, end - begin);
    const std::string_view content = trimmed(line);
    if (content.empty() || content.front() == '#') return;
    if (is_blank(line.front())) {
      const std::size_t offset = static_cast<std::size_t>(content.data() - text_.data());
      if (fields_.empty() && !skipping_)
        report(offset, content.size(),
               "a continuation line that continues nothing; expected 'key: value' at the margin");
      else if (!skipping_)
        fields_.back().end = offset + content.size();
      return;
    }
    read_key(begin, line, content);
  }

  void read_key(std::size_t begin, std::string_view line, std::string_view content) {
    const std::size_t colon = line.find(':');
    skipping_ = true;  // until a good key is read, its continuation lines belong to no field
    if (colon == std::string_view::npos) {
      report(begin, content.size(), "expected 'key: value'", "a value goes on in lines that are indented");
      return;
    }
    const std::string_view written = trimmed(line.substr(0, colon));
    const auto key = std::find(kKeys.begin(), kKeys.end(), written);
    if (key == kKeys.end()) {
      const std::string near = nearest(written, {kKeys.begin(), kKeys.end()});
      report(begin, std::max<std::size_t>(1, written.size()), "unknown key " + quoted(written),
             near.empty() ? "keys are " + key_list() : "did you mean '" + near + "'?");
      return;
    }
    const auto which = static_cast<Key>(key - kKeys.begin());
    if (which != Key::Bias && find(which) != nullptr) {
      report(begin, written.size(), "a second " + quoted(written) + "; each key but 'bias' stands once");
      return;
    }
    skipping_ = false;
    const std::string_view value = trimmed(line.substr(colon + 1));
    const std::size_t value_begin =
        value.empty() ? begin + colon + 1 : static_cast<std::size_t>(value.data() - text_.data());
    fields_.push_back({which, begin, value_begin, value_begin + value.size()});
  }

  static std::string key_list() {
    std::string list;
    for (const std::string_view key : kKeys) list += (list.empty() ? "" : ", ") + std::string(key);
    return list;
  }

  const Field* find(Key key) const {
    const auto at = std::find_if(fields_.begin(), fields_.end(), [key](const Field& f) { return f.key == key; });
    return at == fields_.end() ? nullptr : &*at;
  }

  // The value on one line: comments left out, lines joined by one blank. In prose a '#' may follow other text ("#11").
  std::string one_line(const Field& field) const {
    const bool is_expression = field.key == Key::Expression || field.key == Key::ExpressionDelta;
    std::string joined;
    std::string_view rest = text_.substr(field.begin, field.end - field.begin);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view line = trimmed(rest.substr(0, std::min(end, is_expression ? rest.find('#') : end)));
      if (!line.empty() && line.front() != '#') joined += (joined.empty() ? "" : " ") + std::string(line);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return joined;
  }

  std::string required(Key key) {
    const Field* field = find(key);
    if (field == nullptr) {
      Diagnostic missing;
      missing.source = source_;
      missing.message = "the key " + quoted(key_name(key)) + " is missing";
      errors_.push_back(std::move(missing));
      return {};
    }
    std::string value = one_line(*field);
    if (value.empty())
      report(field->key_offset, key_name(key).size(), "the key " + quoted(key_name(key)) + " has no value");
    return value;
  }

  void read_facts() {
    const std::string kind = required(Key::Kind);
    if (kind == "class") grammar_.kind = GrammarKind::Class;
    if (!kind.empty() && kind != "class" && kind != "algorithm") {
      const std::string near = nearest(kind, {"algorithm", "class"});
      report_value(Key::Kind, "expected 'algorithm' or 'class'", near.empty() ? "" : "did you mean '" + near + "'?");
    }
    grammar_.name = required(Key::Name);
    check_name();
    grammar_.title = required(Key::Title);
    grammar_.source = required(Key::Source);
    grammar_.order = parse_order(required(Key::Order));
    grammar_.expression = required(Key::Expression);
    // Nothing is asked of a kind that is neither.
    if (kind == "algorithm") {
      grammar_.expression_delta = required(Key::ExpressionDelta);
    } else if (const Field* delta = find(Key::ExpressionDelta); kind == "class" && delta != nullptr) {
      report(delta->key_offset, key_name(Key::ExpressionDelta).size(),
             "a class has one expression for every kind of light", "write La, Lp, Ld or Le in 'expression'");
    }
    for (const Field& field : fields_) {
      if (field.key == Key::Bias) grammar_.biases.push_back(one_line(field));
      if (field.key == Key::Notes) grammar_.notes = one_line(field);
    }
  }

  void report_value(Key key, std::string message, std::string suggestion = {}) {
    const Field& field = *find(key);
    report(field.begin, field.end - field.begin, std::move(message), std::move(suggestion));
  }

  void check_name() {
    const std::string& name = grammar_.name;
    const auto is_good = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    const bool good = std::all_of(name.begin(), name.end(), is_good) && !name.empty() && name.front() != '-' &&
                      name.back() != '-' && name != kNoPath;
    if (!good && !name.empty())
      report_value(Key::Name, "a name has small letters, digits and '-' between them, and is not 'none'");
  }

  int parse_order(const std::string& text) {
    int order = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), order);
    if (!text.empty() && (error != std::errc() || end != text.data() + text.size()))
      report_value(Key::Order, "expected a whole number, the place in listings");
    return order;
  }

  Language compile_field(Key key, const GrammarLibrary& library) {
    const Field* field = find(key);
    const std::string& written = key == Key::Expression ? grammar_.expression : grammar_.expression_delta;
    if (field == nullptr || written.empty()) return {};  // reported
    if (key == Key::ExpressionDelta && written == kNoPath) return {};
    ExpressionSource expression{source_, text_, field->begin, field->end, {}};
    const auto language = compile(expression, library.names());
    errors_.insert(errors_.end(), expression.errors.begin(), expression.errors.end());
    return language.value_or(Language::none());
  }

  static Language lit_by(const std::vector<Symbol>& lights) {
    return concat(concat(Language::of(lights), repeat(Language::of(members(kEvents)), 0, std::nullopt)),
                  Language::of(members(kEyes)));
  }

  std::string_view text_;
  std::string_view source_;
  std::vector<Field> fields_;
  bool skipping_ = false;
  Grammar grammar_;
  std::vector<Diagnostic> errors_;
};

bool is_before(const Grammar& a, const Grammar& b) {
  return std::tie(a.kind, a.order, a.name) < std::tie(b.kind, b.order, b.name);
}

void sort_by_place(std::vector<Diagnostic>& errors) {
  std::stable_sort(errors.begin(), errors.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.source, a.line, a.column) < std::tie(b.source, b.line, b.column);
  });
}

}  // namespace

const Grammar* GrammarLibrary::find(std::string_view name) const {
  const auto at = std::find_if(grammars.begin(), grammars.end(), [name](const Grammar& g) { return g.name == name; });
  return at == grammars.end() ? nullptr : &*at;
}

Names GrammarLibrary::names() const {
  Names names;
  names.find = [this](std::string_view name) -> std::optional<Language> {
    if (const Grammar* grammar = find(name)) return grammar->language;
    return std::nullopt;
  };
  for (const Grammar& g : grammars) names.known.push_back(g.name);
  return names;
}

GrammarLibrary read_grammars(std::span<const GrammarText> files, const GrammarLibrary& library) {
  std::vector<GrammarReader> readers;
  for (const GrammarText& file : files) readers.emplace_back(file.text, file.source);
  std::stable_sort(readers.begin(), readers.end(),
                   [](const GrammarReader& a, const GrammarReader& b) { return is_before(a.facts(), b.facts()); });
  GrammarLibrary result = library;
  std::vector<Diagnostic> errors;
  for (GrammarReader& reader : readers) {
    result.grammars.push_back(reader.finish(result));
    errors.insert(errors.end(), reader.errors().begin(), reader.errors().end());
  }
  sort_by_place(errors);
  if (!errors.empty()) throw InputError(std::move(errors));
  std::stable_sort(result.grammars.begin(), result.grammars.end(), is_before);
  return result;
}

Grammar parse_grammar(std::string_view text, std::string_view source, const GrammarLibrary& library) {
  GrammarReader reader(text, source);
  Grammar grammar = reader.finish(library);
  sort_by_place(reader.errors());
  if (!reader.errors().empty()) throw InputError(std::move(reader.errors()));
  return grammar;
}

}  // namespace heckbert::taxonomy
