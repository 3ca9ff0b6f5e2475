#pragma once
// How an object of the scene format is read: from one table of keys. The table gives the reading, the error messages,
// the suggestions for misspelt keys and the reference in docs/scene-format.md, so these cannot contradict each other.
//
// A rule says what value a key takes: describe() is what documentation and messages call it, read() converts.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <heckbert/import/json_document.h>
#include <heckbert/record/rgb.h>

namespace heckbert::import {

/// The document being read and what is wrong with it so far.
class Reader {
 public:
  explicit Reader(const JsonDocument& document) : document_(document) {}

  void error(const JsonNode& node, std::string message, std::string suggestion = {});
  void error(const JsonKey& key, std::string message, std::string suggestion = {});
  /// "expected <what>, found <node>"
  void error_expected(const JsonNode& node, std::string_view what);
  /// Errors of a file that the scene refers to; they follow after its own.
  void adopt(const std::vector<Diagnostic>& diagnostics);
  /// The choice nearest to what was given, as "did you mean ..."; else all choices.
  static std::string suggest(std::string_view given, const std::vector<std::string>& choices);

  std::size_t error_count() const { return error_count_; }
  /// All errors, in the order of the text, then the adopted ones.
  std::vector<Diagnostic> errors() const;

 private:
  void add(std::size_t begin, std::size_t end, std::string message, std::string suggestion);

  const JsonDocument& document_;
  std::vector<Diagnostic> errors_;  ///< the first of them
  std::vector<Diagnostic> adopted_;
  std::size_t error_count_ = 0;  ///< all
};

// ---- rules --------------------------------------------------------------------------------------------------------

/// Numbers from `low` to `high`; both included unless `above` excludes `low`.
struct Range {
  double low = 0, high = 0;
  bool above = false;

  bool contains(double value) const { return (above ? value > low : value >= low) && value <= high; }
  std::string describe() const;
};

inline constexpr double kHuge = 1e9;  ///< beyond this, float arithmetic on coordinates or radiance loses its meaning
inline constexpr Range kUnit{0, 1};
inline constexpr Range kPositive{0, kHuge, true};
inline constexpr Range kNotNegative{0, kHuge};
inline constexpr Range kCoordinate{-kHuge, kHuge};

bool read_number(Reader& in, const JsonNode& node, const Range& range, std::string_view what, float& out);

struct Number {
  Range range;
  std::string describe() const { return "number " + range.describe(); }
  template <class Out>
  void read(Reader& in, const JsonNode& node, Out& out) const {
    if (float value = 0; read_number(in, node, range, describe(), value)) {
      out = value;
    }
  }
};

struct Integer {
  std::uint64_t low = 0, high = 0;
  std::string describe() const;
  std::optional<std::uint64_t> parse(Reader& in, const JsonNode& node) const;
  template <class Out>
  void read(Reader& in, const JsonNode& node, std::optional<Out>& out) const {
    if (const auto value = parse(in, node)) {
      out = static_cast<Out>(*value);
    }
  }
};

struct Colour {
  Range range;
  std::string describe() const { return "grey number or [r, g, b], each " + range.describe(); }
  std::optional<Rgb> parse(Reader& in, const JsonNode& node) const;
  template <class Out>
  void read(Reader& in, const JsonNode& node, Out& out) const {
    if (const auto value = parse(in, node)) {
      out = *value;
    }
  }
};

struct Vector {
  static std::string describe() { return "[x, y, z], each " + kCoordinate.describe(); }
  static void read(Reader& in, const JsonNode& node, glm::vec3& out);
};

struct Text {
  static std::string describe() { return "string"; }
  static void read(Reader& in, const JsonNode& node, std::string& out);
};

struct Flag {
  static std::string describe() { return "true or false"; }
  static void read(Reader& in, const JsonNode& node, bool& out);
};

/// One of several words. Reads nothing when the word is not among them.
struct Choice {
  std::vector<std::string> words;
  std::string describe() const;
  std::optional<std::size_t> parse(Reader& in, const JsonNode& node) const;
  template <class Out>
  void read(Reader& in, const JsonNode& node, Out& out) const {
    if (const auto index = parse(in, node)) {
      out = static_cast<Out>(*index);
    }
  }
};

/// Any value that has a function of its own.
template <class Out>
struct Custom {
  std::string what;
  void (*function)(Reader&, const JsonNode&, Out&);
  std::string describe() const { return what; }
  void read(Reader& in, const JsonNode& node, Out& out) const { function(in, node, out); }
};

/// A value to be read after the rest of its object, when all that it may refer to is known.
struct Later {
  std::string what;
  std::string describe() const { return what; }
  void read(Reader&, const JsonNode& node, const JsonNode*& out) const { out = &node; }
};

/// Calls `read_item` for each item; an error when the node is no list.
void read_list(Reader& in, const JsonNode& node, std::string_view what,
               const std::function<void(const JsonNode&)>& read_item);

// ---- objects ------------------------------------------------------------------------------------------------------

/// What the reference says about a key.
struct KeyFacts {
  std::string name;
  std::string value;      ///< what it takes
  std::string otherwise;  ///< what holds when the key is absent; kRequired when it must be there
  std::string meaning;
};

inline constexpr std::string_view kRequired = "required";

/// A key of the objects that become a T.
template <class T>
struct Key {
  KeyFacts facts;
  std::function<void(Reader&, const JsonNode&, T&)> read;
};

template <class T, class Rule, class Member>
Key<T> key(std::string_view name, Rule rule, Member T::*member, std::string_view otherwise, std::string_view meaning) {
  KeyFacts facts{std::string(name), rule.describe(), std::string(otherwise), std::string(meaning)};
  return {std::move(facts), [rule = std::move(rule), member](Reader& in, const JsonNode& node, T& out) {
            rule.read(in, node, out.*member);
          }};
}

/// The key that tells objects of one list apart; read before the others, see read_type.
template <class T>
Key<T> type_key(const Choice& types, std::string_view meaning) {
  return {{"type", types.describe(), std::string(kRequired), std::string(meaning)},
          [](Reader&, const JsonNode&, T&) {}};
}

/// A key with its target.
struct BoundKey {
  const KeyFacts* facts;
  std::function<void(Reader&, const JsonNode&)> read;
};

template <class T>
void bind(const std::vector<Key<T>>& keys, T& target, std::vector<BoundKey>& out) {
  for (const Key<T>& k : keys) {
    out.push_back({&k.facts, [&k, &target](Reader& in, const JsonNode& node) { k.read(in, node, target); }});
  }
}

/// Reads an object in the order of the table, so that what comes first there may be referred to by what comes later.
/// Unknown and missing keys are errors. `what` names the object in messages.
void read_object(Reader& in, const JsonNode& node, std::string_view what, const std::vector<BoundKey>& keys);

template <class T>
void read_object(Reader& in, const JsonNode& node, std::string_view what, const std::vector<Key<T>>& keys, T& out) {
  std::vector<BoundKey> bound;
  bind(keys, out, bound);
  read_object(in, node, what, bound);
}

/// The index of the object's "type" among the choices.
std::optional<std::size_t> read_type(Reader& in, const JsonNode& node, std::string_view what, const Choice& types);

}  // namespace heckbert::import
