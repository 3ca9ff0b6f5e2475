#pragma once
// A JSON text with the place of every key and value. nlohmann-json validates and converts; its events carry no places,
// but they come in the order of the text, so walking the text one token per event finds them.
//
// Comments (// and /* */) count as blanks. Duplicate keys and nesting deeper than kMaxDepth are errors.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/error.h>

namespace heckbert::import {

struct JsonNode;

struct JsonKey {
  std::string text;
  std::size_t begin = 0, end = 0;  ///< byte offsets, with the quotes
};

struct JsonNode {
  enum class Kind : std::uint8_t { Null, Flag, Number, Text, List, Object };
  Kind kind = Kind::Null;
  bool flag = false;
  double number = 0;
  std::optional<std::uint64_t> natural;  ///< set when the number is written as an integer that is not negative
  std::string text;
  std::vector<JsonNode> items;     ///< of a list, or the values of an object
  std::vector<JsonKey> keys;       ///< of an object, one per item
  std::size_t begin = 0, end = 0;  ///< byte offsets [begin, end) in the text

  const JsonNode* find(std::string_view key) const;
};

/// "a string", "a list", ...: what stands there, for messages.
std::string_view describe(JsonNode::Kind kind);

inline constexpr std::size_t kMaxDepth = 64;

struct JsonDocument {
  std::string_view text;
  std::string source;
  JsonNode root;
  std::vector<Diagnostic> duplicate_keys;  ///< errors that do not stop the reading of the rest

  /// A diagnostic for the bytes [begin, end) with the JSON pointer (RFC 6901) of the value there.
  Diagnostic diagnose_at(std::size_t begin, std::size_t end, std::string message, std::string suggestion = {}) const;
};

/// Errors: InputError for the first breach of the syntax.
JsonDocument parse_json(std::string_view text, std::string_view source);

}  // namespace heckbert::import
