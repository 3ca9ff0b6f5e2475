#include <heckbert/import/json_document.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

namespace heckbert::import {
namespace {

using nlohmann::json;

/// Steps over everything between two tokens that carry an event. `text` is valid JSON with comments up to there.
std::size_t skip_to_token(std::string_view text, std::size_t at) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (at == 0 && text.starts_with(kByteOrderMark)) {
    at = kByteOrderMark.size();
  }
  while (at < text.size()) {
    if (std::string_view(" \t\r\n,:").find(text[at]) != std::string_view::npos) {
      ++at;
    } else if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.substr(at, 2) == "/*") {
      const std::size_t close = text.find("*/", at + 2);
      at = close == std::string_view::npos ? text.size() : close + 2;
    } else {
      break;
    }
  }
  return at;
}

/// One past the token that begins at `at`: a bracket, a string, a number or a literal.
std::size_t token_end(std::string_view text, std::size_t at) {
  if (at >= text.size()) {
    return text.size();
  }
  if (std::string_view("{}[]").find(text[at]) != std::string_view::npos) {
    return at + 1;
  }
  if (text[at] == '"') {
    for (std::size_t i = at + 1; i < text.size(); ++i) {
      if (text[i] == '\\') {
        ++i;
      } else if (text[i] == '"') {
        return i + 1;
      }
    }
    return text.size();
  }
  return std::min(text.find_first_of(" \t\r\n,:{}[]\"/", at), text.size());
}

/// nlohmann's reason without its own name, number, place and excerpt: we give these ourselves.
std::string reason(std::string message) {
  for (const std::string_view prefix : {"] ", ": ", " - "}) {
    if (const std::size_t at = message.find(prefix); at != std::string::npos && at < message.find('\'')) {
      message.erase(0, at + prefix.size());
    }
  }
  if (const std::size_t last_read = message.find("; last read"); last_read != std::string::npos) {
    const std::size_t expected = message.find("; expected", last_read);
    message.erase(last_read, expected == std::string::npos ? expected : expected - last_read);
  }
  return "this is not JSON: " + message;
}

class TreeBuilder final : public nlohmann::json_sax<json> {
 public:
  explicit TreeBuilder(JsonDocument& document) : document_(document) {}

  bool null() override { return add(JsonNode{}); }
  bool boolean(bool value) override {
    JsonNode node;
    node.kind = JsonNode::Kind::Flag;
    node.flag = value;
    return add(std::move(node));
  }
  bool number_integer(number_integer_t value) override { return add(number(static_cast<double>(value))); }
  bool number_unsigned(number_unsigned_t value) override {
    JsonNode node = number(static_cast<double>(value));
    node.natural = value;
    return add(std::move(node));
  }
  bool number_float(number_float_t value, const string_t&) override { return add(number(value)); }
  bool string(string_t& value) override {
    JsonNode node;
    node.kind = JsonNode::Kind::Text;
    node.text = std::move(value);
    return add(std::move(node));
  }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(JsonNode::Kind::Object); }
  bool start_array(std::size_t) override { return open(JsonNode::Kind::List); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    const auto [begin, end] = next_token();
    std::vector<JsonKey>& keys = open_.back().keys;
    if (std::any_of(keys.begin(), keys.end(), [&](const JsonKey& other) { return other.text == value; })) {
      duplicates.push_back({value, begin, end});
    }
    keys.push_back({std::move(value), begin, end});
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
    // `position` is one past the byte that broke the syntax; the token that it belongs to may begin before.
    const std::size_t broken = std::min(position, document_.text.size() + 1) - std::min<std::size_t>(position, 1);
    const std::size_t token = std::min(skip_to_token(document_.text, cursor_), broken);
    fault = document_.diagnose_at(token, broken + 1, reason(error.what()));
    return false;
  }

  std::optional<Diagnostic> fault;  ///< why reading stopped
  std::vector<JsonKey> duplicates;

 private:
  static JsonNode number(double value) {
    JsonNode node;
    node.kind = JsonNode::Kind::Number;
    node.number = value;
    return node;
  }

  std::pair<std::size_t, std::size_t> next_token() {
    const std::size_t begin = skip_to_token(document_.text, cursor_);
    cursor_ = token_end(document_.text, begin);
    return {begin, cursor_};
  }

  bool add(JsonNode node) {
    std::tie(node.begin, node.end) = next_token();
    place(std::move(node));
    return true;
  }

  bool open(JsonNode::Kind kind) {
    JsonNode node;
    node.kind = kind;
    std::tie(node.begin, node.end) = next_token();
    if (open_.size() >= kMaxDepth) {
      fault = document_.diagnose_at(node.begin, node.end,
                                    "nested deeper than " + std::to_string(kMaxDepth) + " lists and objects");
      return false;
    }
    open_.push_back(std::move(node));
    return true;
  }

  bool close() {
    JsonNode node = std::move(open_.back());
    open_.pop_back();
    node.end = next_token().second;
    place(std::move(node));
    return true;
  }

  void place(JsonNode node) { (open_.empty() ? document_.root : open_.back().items.emplace_back()) = std::move(node); }

  JsonDocument& document_;
  std::vector<JsonNode> open_;
  std::size_t cursor_ = 0;
};

std::string escaped(std::string_view key) {
  std::string out;
  for (const char c : key) {
    out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return out;
}

/// The pointer of the innermost value that covers the byte at `offset`; a key belongs to its value.
std::string pointer_to(const JsonNode& node, std::size_t offset) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const bool named = node.kind == JsonNode::Kind::Object;
    const JsonNode& item = node.items[i];
    if (offset >= (named ? node.keys[i].begin : item.begin) && offset < item.end) {
      return "/" + (named ? escaped(node.keys[i].text) : std::to_string(i)) + pointer_to(item, offset);
    }
  }
  return {};
}

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].text == key) {
      return &items[i];
    }
  }
  return nullptr;
}

std::string_view describe(JsonNode::Kind kind) {
  switch (kind) {
    case JsonNode::Kind::Null:
      return "null";
    case JsonNode::Kind::Flag:
      return "true or false";
    case JsonNode::Kind::Number:
      return "a number";
    case JsonNode::Kind::Text:
      return "a string";
    case JsonNode::Kind::List:
      return "a list";
    case JsonNode::Kind::Object:
      return "an object";
  }
  return {};
}

Diagnostic JsonDocument::diagnose_at(std::size_t begin, std::size_t end, std::string message,
                                     std::string suggestion) const {
  Diagnostic diagnostic = diagnose(source, text, begin, end - begin, std::move(message), std::move(suggestion));
  diagnostic.pointer = pointer_to(root, begin);
  return diagnostic;
}

JsonDocument parse_json(std::string_view text, std::string_view source) {
  JsonDocument document{text, std::string(source), {}, {}};
  TreeBuilder builder(document);
  constexpr bool kStrict = true;
  constexpr bool kIgnoreComments = true;
  json::sax_parse(text.begin(), text.end(), &builder, json::input_format_t::json, kStrict, kIgnoreComments);
  if (builder.fault) {
    throw InputError(*builder.fault);
  }
  for (const JsonKey& key : builder.duplicates) {
    document.duplicate_keys.push_back(
        document.diagnose_at(key.begin, key.end, "the key \"" + key.text + "\" stands twice in this object"));
  }
  return document;
}

}  // namespace heckbert::import
