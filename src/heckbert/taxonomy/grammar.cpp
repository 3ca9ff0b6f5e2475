#include <heckbert/taxonomy/grammar.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <tuple>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/error_codes.h>
#include <heckbert/taxonomy/expression_compiler.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

namespace {

constexpr unsigned bit(GrammarKind kind) {
  return 1u << static_cast<unsigned>(kind);
}
constexpr unsigned kAlgorithms = bit(GrammarKind::Algorithm), kClasses = bit(GrammarKind::Class),
                   kTransformers = bit(GrammarKind::Transformer);
constexpr unsigned kEvery = (1u << kGrammarKinds.size()) - 1;

enum class Key : std::uint8_t {
  Kind,
  Name,
  Title,
  Order,
  Number,
  Core,
  Source,
  Expression,
  ExpressionDelta,
  Host,
  Bias,
  Variance,
  Precondition,
  Notes
};

struct KeyFacts {
  Key key;
  std::string_view name;
  unsigned required;  ///< the kinds of grammar that must have it
  unsigned allowed;   ///< those that may
  bool repeats = false;
  std::string_view elsewhere{};  ///< what to do when it stands in another kind
};

// The keys of a grammar file, in the order in which they are listed to people.
constexpr std::array<KeyFacts, 14> kKeys{{
    {Key::Kind, "kind", kEvery, kEvery},
    {Key::Name, "name", kEvery, kEvery},
    {Key::Title, "title", kEvery, kEvery},
    {Key::Order, "order", kEvery, kEvery},
    {Key::Number, "number", 0, kEvery & ~kClasses, false, "the rows of the table are algorithms"},
    {Key::Core, "core", 0, kAlgorithms, false, "the teaching set has algorithms only"},
    {Key::Source, "source", kEvery, kEvery},
    {Key::Expression, "expression", kAlgorithms | kClasses, kAlgorithms | kClasses, false,
     "say in 'notes' what it finds"},
    {Key::ExpressionDelta, "expression-delta", kAlgorithms, kAlgorithms, false,
     "one expression is enough: write La, Lp, Ld or Le in it"},
    {Key::Host, "host", kTransformers, kTransformers, false, "only a transformer works on another algorithm"},
    {Key::Bias, "bias", 0, kEvery, true},
    {Key::Variance, "variance", 0, kEvery, true},
    {Key::Precondition, "precondition", 0, kEvery, true},
    {Key::Notes, "notes", 0, kEvery},
}};

static_assert([] {
  for (std::size_t i = 0; i < kKeys.size(); ++i)
    if (static_cast<std::size_t>(kKeys[i].key) != i) return false;
  return true;
}());

const KeyFacts& key_facts(Key key) {
  return kKeys[static_cast<std::size_t>(key)];
}
std::string_view key_name(Key key) {
  return key_facts(key).name;
}
std::string did_you_mean(std::string_view written, const std::vector<std::string>& known) {
  const std::string near = nearest(written, known);
  return near.empty() ? "" : taxonomy::did_you_mean(near);
}
template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const auto& row : table) names.emplace_back(row.name);
  return names;
}
std::string listed(const std::vector<std::string>& names, std::string_view between, std::string_view mark) {
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : std::string(between)) + std::string(mark) + name + std::string(mark);
  return list;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '\n')) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\n')) text.remove_suffix(1);
  return text;
}

/// Every word that begins with one of these lights.
Language lit_by(SymbolSet lights) {
  return concat(concat(Language::of(lights), repeat(Language::of(kEvents), 0, std::nullopt)), Language::of(kEyes));
}
const Language& lit_by_hit() {
  static const Language language = lit_by(single(Symbol::La) | single(Symbol::Le));
  return language;
}
const Language& lit_by_delta() {
  static const Language language = lit_by(single(Symbol::Lp) | single(Symbol::Ld));
  return language;
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
      report(ErrorCode::NameTaken, name->begin, name->end - name->begin, {quoted(grammar_.name)});
    check_host(library);
    const Language hit = compile_field(Key::Expression, library);
    const Language delta = compile_field(Key::ExpressionDelta, library);
    if (grammar_.kind == GrammarKind::Algorithm)
      grammar_.language = (hit & lit_by_hit()) | (delta & lit_by_delta());
    else
      grammar_.language = hit;
    return grammar_;
  }

 private:
  void report(ErrorCode code, std::size_t offset, std::size_t length,
              std::initializer_list<std::string_view> values = {}, std::string suggestion = {}) {
    errors_.push_back(diagnose(code, source_, text_, offset, length, values, std::move(suggestion)));
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
        report(ErrorCode::ContinuesNothing, offset, content.size());
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
      report(ErrorCode::NoKey, begin, content.size(), {}, "a value goes on in lines that are indented");
      return;
    }
    const std::string_view written = trimmed(line.substr(0, colon));
    const auto key =
        std::find_if(kKeys.begin(), kKeys.end(), [&](const KeyFacts& facts) { return facts.name == written; });
    if (key == kKeys.end()) {
      const std::vector<std::string> names = names_in(kKeys);
      const std::string near = did_you_mean(written, names);
      report(ErrorCode::UnknownKey, begin, std::max<std::size_t>(1, written.size()), {quoted(written)},
             near.empty() ? "keys are " + listed(names, ", ", "") : near);
      return;
    }
    const Key which = key->key;
    if (!key->repeats && find(which) != nullptr) {
      report(ErrorCode::KeyTwice, begin, written.size(), {quoted(written)});
      return;
    }
    skipping_ = false;
    const std::string_view value = trimmed(line.substr(colon + 1));
    const std::size_t value_begin =
        value.empty() ? begin + colon + 1 : static_cast<std::size_t>(value.data() - text_.data());
    fields_.push_back({which, begin, value_begin, value_begin + value.size()});
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

  // The value of a key, empty when it is not there. Keys that this kind must have, or may not, are reported.
  std::string value(Key key) {
    const Field* field = find(key);
    const unsigned kind = bit(grammar_.kind);
    if (field == nullptr) {
      if ((key_facts(key).required & kind) == 0) return {};
      Diagnostic missing;
      missing.source = source_;
      missing.code = label(ErrorCode::KeyMissing);
      missing.message = message_of(ErrorCode::KeyMissing, {quoted(key_name(key))});
      errors_.push_back(std::move(missing));
      return {};
    }
    if (is_kind_known_ && (key_facts(key).allowed & kind) == 0) {
      report(ErrorCode::KeyElsewhere, field->key_offset, key_name(key).size(),
             {quoted(key_name(key)), taxonomy::facts(grammar_.kind).name}, std::string(key_facts(key).elsewhere));
      return {};
    }
    return text_of(*field);
  }

  std::string text_of(const Field& field) {
    std::string text = one_line(field);
    if (text.empty())
      report(ErrorCode::NoValue, field.key_offset, key_name(field.key).size(), {quoted(key_name(field.key))});
    return text;
  }

  void read_facts() {
    grammar_.kind = GrammarKind::Class;  // until it is known, no more is asked than of a class
    read_kind(value(Key::Kind));
    grammar_.name = value(Key::Name);
    check_name();
    grammar_.title = value(Key::Title);
    grammar_.source = value(Key::Source);
    grammar_.order = whole_number(Key::Order, std::numeric_limits<int>::min(), "the place in listings").value_or(0);
    grammar_.number = whole_number(Key::Number, 1, "from 1: the row in the table of algorithms");
    read_core(value(Key::Core));
    grammar_.expression = value(Key::Expression);
    grammar_.expression_delta = value(Key::ExpressionDelta);
    if (grammar_.expression == kNoPath && grammar_.expression_delta == kNoPath)
      report_value(ErrorCode::CapturesNothing, Key::ExpressionDelta, {},
                   "what has no language is a " + listed(kinds_without_language(), " or a ", "'"));
    grammar_.host = value(Key::Host);
    grammar_.notes = value(Key::Notes);
    for (const Field& field : fields_) {
      if (field.key == Key::Bias) grammar_.biases.push_back(text_of(field));
      if (field.key == Key::Variance) grammar_.variances.push_back(text_of(field));
      if (field.key == Key::Precondition) grammar_.preconditions.push_back(text_of(field));
    }
  }

  void read_kind(const std::string& text) {
    const auto kind = std::find_if(kGrammarKinds.begin(), kGrammarKinds.end(),
                                   [&](const GrammarKindFacts& facts) { return facts.name == text; });
    is_kind_known_ = kind != kGrammarKinds.end();
    if (is_kind_known_) {
      grammar_.kind = kind->kind;
    } else if (!text.empty()) {
      const std::vector<std::string> names = names_in(kGrammarKinds);
      report_value(ErrorCode::WrongValue, Key::Kind, {listed(names, " or ", "'")}, did_you_mean(text, names));
    }
  }

  void read_core(const std::string& text) {
    grammar_.is_core = text == "yes";
    if (!text.empty() && text != "yes" && text != "no")
      report_value(ErrorCode::WrongValue, Key::Core, {"'yes' or 'no'"});
  }

  static std::vector<std::string> kinds_without_language() {
    std::vector<std::string> names;
    for (const GrammarKindFacts& facts : kGrammarKinds)
      if (!facts.no_language.empty()) names.emplace_back(facts.name);
    return names;
  }

  void check_host(const GrammarLibrary& library) {
    if (grammar_.host.empty()) return;
    std::vector<std::string> algorithms;
    for (const Grammar& grammar : library.grammars)
      if (grammar.kind == GrammarKind::Algorithm) algorithms.push_back(grammar.name);
    if (std::find(algorithms.begin(), algorithms.end(), grammar_.host) == algorithms.end())
      report_value(ErrorCode::UnknownHost, Key::Host, {quoted(grammar_.host)}, did_you_mean(grammar_.host, algorithms));
  }

  void report_value(ErrorCode code, Key key, std::initializer_list<std::string_view> values,
                    std::string suggestion = {}) {
    const Field& field = *find(key);
    report(code, field.begin, field.end - field.begin, values, std::move(suggestion));
  }

  void check_name() {
    const std::string& name = grammar_.name;
    const auto is_good = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    const bool good = std::all_of(name.begin(), name.end(), is_good) && !name.empty() && name.front() != '-' &&
                      name.back() != '-' && name != kNoPath;
    if (!good && !name.empty()) report_value(ErrorCode::WrongName, Key::Name, {});
  }

  std::optional<int> whole_number(Key key, int at_least, std::string_view what) {
    const std::string text = value(key);
    if (text.empty()) return std::nullopt;
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size() && number >= at_least) return number;
    report_value(ErrorCode::WrongValue, key, {"a whole number, " + std::string(what)});
    return std::nullopt;
  }

  Language compile_field(Key key, const GrammarLibrary& library) {
    const std::string& written = key == Key::Expression ? grammar_.expression : grammar_.expression_delta;
    if (written.empty()) return {};  // reported, or not asked for
    if (grammar_.kind == GrammarKind::Algorithm && written == kNoPath) return {};
    const Field& field = *find(key);
    ExpressionSource expression{source_, text_, field.begin, field.end, {}};
    const auto language = compile(expression, library.names());
    errors_.insert(errors_.end(), expression.errors.begin(), expression.errors.end());
    return language.value_or(Language::none());
  }

  std::string_view text_;
  std::string_view source_;
  std::vector<Field> fields_;
  bool skipping_ = false;
  bool is_kind_known_ = false;
  Grammar grammar_;
  std::vector<Diagnostic> errors_;
};

bool is_before(const Grammar& a, const Grammar& b) {
  return std::tie(a.kind, a.order, a.name) < std::tie(b.kind, b.order, b.name);
}

}  // namespace

bool has_language(const Grammar& grammar) {
  return facts(grammar.kind).no_language.empty();
}

std::string why_no_language(const Grammar& grammar) {
  if (has_language(grammar)) return {};
  const GrammarKindFacts& kind = facts(grammar.kind);
  return quoted(grammar.name) + " is a " + std::string(kind.name) +
         " and has no language: " + std::string(kind.no_language) +
         (grammar.host.empty() ? "" : "; its host is '@" + grammar.host + "'");
}

std::vector<Grammar> core_algorithms(const GrammarLibrary& library) {
  std::vector<Grammar> core;
  for (const Grammar& grammar : library.grammars)
    if (grammar.is_core) core.push_back(grammar);
  return core;
}

const Grammar* GrammarLibrary::find(std::string_view name) const {
  const auto at = std::find_if(grammars.begin(), grammars.end(), [name](const Grammar& g) { return g.name == name; });
  return at == grammars.end() ? nullptr : &*at;
}

Names GrammarLibrary::names() const {
  Names names;
  names.find = [this](std::string_view name) -> std::optional<Language> {
    const Grammar* grammar = find(name);
    if (grammar == nullptr || !has_language(*grammar)) return std::nullopt;
    return grammar->language;
  };
  names.why_none = [this](std::string_view name) {
    const Grammar* grammar = find(name);
    return grammar == nullptr ? std::string() : why_no_language(*grammar);
  };
  for (const Grammar& g : grammars)
    if (has_language(g)) names.known.push_back(g.name);
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
