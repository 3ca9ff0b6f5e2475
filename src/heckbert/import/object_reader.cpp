#include <heckbert/import/object_reader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

constexpr std::size_t kMaxErrors = 100;

}  // namespace

void Reader::add(std::size_t begin, std::size_t end, std::string message, std::string suggestion) {
  if (++error_count_ <= kMaxErrors) {
    errors_.push_back(document_.diagnose_at(begin, end, std::move(message), std::move(suggestion)));
  } else if (error_count_ == kMaxErrors + 1) {
    errors_.push_back(document_.diagnose_at(
        begin, end, "more than " + std::to_string(kMaxErrors) + " errors: from here on they are only counted"));
  }
}

void Reader::error(const JsonNode& node, std::string message, std::string suggestion) {
  const bool spans_lines = node.kind == JsonNode::Kind::Object || node.kind == JsonNode::Kind::List;
  add(node.begin, spans_lines ? node.begin + 1 : node.end, std::move(message), std::move(suggestion));
}

void Reader::error(const JsonKey& key, std::string message, std::string suggestion) {
  add(key.begin, key.end, std::move(message), std::move(suggestion));
}

void Reader::error_expected(const JsonNode& node, std::string_view what) {
  error(node, "expected " + std::string(what) + ", found " + std::string(import::describe(node.kind)));
}

void Reader::adopt(const std::vector<Diagnostic>& diagnostics) {
  error_count_ += diagnostics.size();
  adopted_.insert(adopted_.end(), diagnostics.begin(), diagnostics.end());
}

std::string Reader::suggest(std::string_view given, const std::vector<std::string>& choices) {
  if (choices.empty()) {
    return "there are none";
  }
  const std::string near = nearest(given, choices);
  return near.empty() ? "known: " + join(choices) : "did you mean \"" + near + "\"?";
}

std::vector<Diagnostic> Reader::errors() const {
  std::vector<Diagnostic> all = document_.duplicate_keys;
  all.insert(all.end(), errors_.begin(), errors_.end());
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  all.insert(all.end(), adopted_.begin(), adopted_.end());
  return all;
}

std::string Range::describe() const {
  return (above ? "above " : "from ") + to_text(low) + (above ? ", at most " : " to ") + to_text(high);
}

bool read_number(Reader& in, const JsonNode& node, const Range& range, std::string_view what, float& out) {
  if (node.kind != JsonNode::Kind::Number) {
    in.error_expected(node, what);
    return false;
  }
  if (!range.contains(node.number)) {
    in.error(node, "expected " + std::string(what) + ", found " + to_text(node.number));
    return false;
  }
  out = static_cast<float>(node.number);
  return true;
}

std::string Integer::describe() const {
  return "integer from " + std::to_string(low) + " to " + std::to_string(high);
}

std::optional<std::uint64_t> Integer::parse(Reader& in, const JsonNode& node) const {
  if (node.kind != JsonNode::Kind::Number) {
    in.error_expected(node, describe());
    return {};
  }
  if (!node.natural || *node.natural < low || *node.natural > high) {
    in.error(node, "expected " + describe() + ", found " + to_text(node.number));
    return {};
  }
  return node.natural;
}

std::optional<Rgb> Colour::parse(Reader& in, const JsonNode& node) const {
  if (node.kind == JsonNode::Kind::Number) {
    float grey = 0;
    return read_number(in, node, range, describe(), grey) ? std::optional(Rgb(grey)) : std::nullopt;
  }
  if (node.kind != JsonNode::Kind::List || node.items.size() != 3) {
    in.error_expected(node, describe());
    return {};
  }
  std::array<float, 3> c{};
  bool good = true;
  for (std::size_t i = 0; i < 3; ++i) {
    good = read_number(in, node.items[i], range, "number " + range.describe(), c[i]) && good;
  }
  return good ? std::optional(Rgb(c[0], c[1], c[2])) : std::nullopt;
}

void Vector::read(Reader& in, const JsonNode& node, glm::vec3& out) {
  if (node.kind != JsonNode::Kind::List || node.items.size() != 3) {
    in.error_expected(node, describe());
    return;
  }
  for (int i = 0; i < 3; ++i) {
    read_number(in, node.items[static_cast<std::size_t>(i)], kCoordinate, "number " + kCoordinate.describe(), out[i]);
  }
}

void Text::read(Reader& in, const JsonNode& node, std::string& out) {
  if (node.kind != JsonNode::Kind::Text || node.text.empty()) {
    in.error(node, node.kind == JsonNode::Kind::Text
                       ? "this string must not be empty"
                       : "expected " + describe() + ", found " + std::string(import::describe(node.kind)));
    return;
  }
  out = node.text;
}

void Flag::read(Reader& in, const JsonNode& node, bool& out) {
  if (node.kind != JsonNode::Kind::Flag) {
    in.error_expected(node, describe());
    return;
  }
  out = node.flag;
}

std::string Choice::describe() const {
  return "one of " + join(words);
}

std::optional<std::size_t> Choice::parse(Reader& in, const JsonNode& node) const {
  if (node.kind != JsonNode::Kind::Text) {
    in.error_expected(node, describe());
    return {};
  }
  const auto at = std::find(words.begin(), words.end(), node.text);
  if (at == words.end()) {
    in.error(node, "expected " + describe() + ", found \"" + node.text + "\"", Reader::suggest(node.text, words));
    return {};
  }
  return static_cast<std::size_t>(at - words.begin());
}

void read_list(Reader& in, const JsonNode& node, std::string_view what,
               const std::function<void(const JsonNode&)>& read_item) {
  if (node.kind != JsonNode::Kind::List) {
    in.error_expected(node, what);
    return;
  }
  for (const JsonNode& item : node.items) {
    read_item(item);
  }
}

void read_object(Reader& in, const JsonNode& node, std::string_view what, const std::vector<BoundKey>& keys) {
  if (node.kind != JsonNode::Kind::Object) {
    in.error_expected(node, "an object (" + std::string(what) + ")");
    return;
  }
  std::vector<std::string> known;
  for (const BoundKey& key : keys) {
    known.push_back(key.facts->name);
    if (const JsonNode* value = node.find(key.facts->name)) {
      key.read(in, *value);
    } else if (key.facts->otherwise == kRequired) {
      in.error(node, std::string(what) + " needs \"" + key.facts->name + "\": " + key.facts->value);
    }
  }
  for (const JsonKey& key : node.keys) {
    if (std::find(known.begin(), known.end(), key.text) == known.end()) {
      in.error(key, std::string(what) + " has no key \"" + key.text + "\"", Reader::suggest(key.text, known));
    }
  }
}

std::optional<std::size_t> read_type(Reader& in, const JsonNode& node, std::string_view what, const Choice& types) {
  if (node.kind != JsonNode::Kind::Object) {
    in.error_expected(node, "an object (" + std::string(what) + ")");
    return {};
  }
  const JsonNode* type = node.find("type");
  if (type == nullptr) {
    in.error(node, std::string(what) + " needs \"type\": " + types.describe());
    return {};
  }
  return types.parse(in, *type);
}

}  // namespace heckbert::import
