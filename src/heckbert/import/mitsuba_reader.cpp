#include <heckbert/import/mitsuba_reader.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

constexpr std::size_t kMaxErrors = 100;

/// Elements that are values; all others that carry a type are objects.
constexpr std::string_view kValueTags[] = {"float", "integer", "boolean",  "string",    "vector",    "point",
                                           "rgb",   "srgb",    "spectrum", "blackbody", "transform", "animation"};

bool is_value(const XmlNode& node) {
  return std::find(std::begin(kValueTags), std::end(kValueTags), node.tag) != std::end(kValueTags);
}

void collect_ids(const XmlNode& node, MitsubaReader& in) {
  for (const XmlNode& child : node.children) {
    if (const XmlAttribute* id = child.find("id"); id != nullptr && child.tag != "ref" && child.tag != "hide") {
      if (!in.objects.try_emplace(id->value, &child).second) {
        in.error(id->place, "two objects have the id \"" + id->value + "\"");
      }
    }
    collect_ids(child, in);
  }
}

}  // namespace

MitsubaReader::MitsubaReader(const XmlDocument& of) : document(of) {
  collect_ids(of.root, *this);
}

void MitsubaReader::error(const XmlPlace& place, std::string message, std::string suggestion) {
  if (errors.size() < kMaxErrors) {
    errors.push_back(diagnose(place, std::move(message), std::move(suggestion)));
  }
}

void MitsubaReader::adopt(const std::vector<Diagnostic>& diagnostics) {
  errors.insert(errors.end(), diagnostics.begin(), diagnostics.end());
}

void MitsubaReader::understood(const XmlPlace& place, const std::string& what) {
  imported.account.understood.push_back(to_text(place) + ": " + what);
}
void MitsubaReader::guessed(const XmlPlace& place, const std::string& what) {
  imported.account.guessed.push_back(to_text(place) + ": " + what);
}
void MitsubaReader::ignored(const XmlPlace& place, const std::string& what) {
  imported.account.ignored.push_back(to_text(place) + ": " + what);
}

const XmlNode* MitsubaReader::resolve(const XmlNode& ref) {
  const XmlAttribute* id = ref.find("id");
  if (id == nullptr) {
    error(ref.place, "a reference needs the attribute \"id\"");
    return nullptr;
  }
  if (const auto found = objects.find(id->value); found != objects.end()) {
    if (std::find(open.begin(), open.end(), found->second) != open.end()) {
      error(id->place, "the object with the id \"" + id->value + "\" refers to itself");
      return nullptr;
    }
    return found->second;
  }
  std::vector<std::string> ids;
  for (const auto& [known, node] : objects) {
    ids.push_back(known);
  }
  const std::string near = nearest(id->value, ids);
  error(id->place, "nothing has the id \"" + id->value + "\"", near.empty() ? "" : "did you mean \"" + near + "\"?");
  return nullptr;
}

// ---- objects --------------------------------------------------------------------------------------------------------

MitsubaObject::MitsubaObject(MitsubaReader& in, const XmlNode& node) : in_(in), node_(node), type_(node["type"]) {
  in_.open.push_back(&node);
  if (type_.empty()) {
    in_.error(node.place, "<" + node.tag + "> needs the attribute \"type\"");
  }
}

MitsubaObject::~MitsubaObject() {
  in_.open.pop_back();
  const std::vector<std::string> known(names_.begin(), names_.end());
  for (const XmlNode& child : node_.children) {
    if (asked_.count(&child) != 0) {
      continue;
    }
    const std::string name(child["name"]);
    std::string what = describe() + ": ";
    if (is_value(child)) {
      const std::string near = nearest(name, known);
      what += "\"" + name + "\" is not read" + (near.empty() ? "" : "; did you mean \"" + near + "\"?");
    } else {
      what += "<" + child.tag + "> is not read";
    }
    in_.ignored(child.place, what);
  }
}

std::string MitsubaObject::describe() const {
  return node_.tag + " \"" + type_ + "\"";
}

const XmlNode* MitsubaObject::peek(std::string_view name) const {
  const auto found = std::find_if(node_.children.begin(), node_.children.end(),
                                  [&](const XmlNode& child) { return child["name"] == name; });
  return found == node_.children.end() ? nullptr : &*found;
}

const XmlNode* MitsubaObject::find(std::string_view name) {
  names_.emplace(name);
  const XmlNode* node = peek(name);
  if (node == nullptr) {
    return nullptr;
  }
  asked_.insert(node);
  return node->tag == "ref" ? in_.resolve(*node) : node;
}

const XmlNode* MitsubaObject::take(std::string_view name, std::initializer_list<std::string_view> tags) {
  const XmlNode* node = find(name);
  if (node == nullptr) {
    return nullptr;
  }
  if (std::find(tags.begin(), tags.end(), node->tag) == tags.end()) {
    in_.error(node->place, describe() + ": expected " + std::string(*tags.begin()) + " for \"" + std::string(name) +
                               "\", found " + node->tag);
    return nullptr;
  }
  return node;
}

void MitsubaObject::wrong(const XmlNode& node, std::string_view expected) {
  const XmlAttribute* value = node.find("value");
  if (value == nullptr) {
    in_.error(node.place, "<" + node.tag + "> needs the attribute \"value\"");
  } else {
    in_.error(value->place, "expected " + std::string(expected) + ", found \"" + value->value + "\"");
  }
}

float MitsubaObject::number(std::string_view name, float otherwise, const Range& range) {
  const XmlNode* node = take(name, {"float", "integer"});
  if (node == nullptr) {
    return otherwise;
  }
  const std::optional<float> value = parse_number((*node)["value"]);
  if (!value || !range.contains(static_cast<double>(*value))) {
    wrong(*node, "a number " + range.describe());
    return otherwise;
  }
  return *value;
}

int MitsubaObject::integer(std::string_view name, int otherwise) {
  const XmlNode* node = take(name, {"integer", "float"});
  if (node == nullptr) {
    return otherwise;
  }
  const std::optional<float> value = parse_number((*node)["value"]);
  constexpr float kLargest = 1e9f;
  if (!value || std::abs(*value) > kLargest || *value != std::floor(*value)) {
    wrong(*node, "a whole number");
    return otherwise;
  }
  return static_cast<int>(*value);
}

bool MitsubaObject::flag(std::string_view name, bool otherwise) {
  const XmlNode* node = take(name, {"boolean"});
  if (node == nullptr) {
    return otherwise;
  }
  const std::string_view value = (*node)["value"];
  if (value != "true" && value != "false") {
    wrong(*node, "true or false");
    return otherwise;
  }
  return value == "true";
}

std::string MitsubaObject::text(std::string_view name, std::string_view otherwise) {
  const XmlNode* node = take(name, {"string"});
  if (node != nullptr && node->find("value") == nullptr) {
    wrong(*node, "a text");
  }
  return std::string(node == nullptr ? otherwise : (*node)["value"]);
}

glm::vec3 MitsubaObject::vector(std::string_view name, glm::vec3 otherwise) {
  const XmlNode* node = take(name, {"vector", "point"});
  if (node == nullptr) {
    return otherwise;
  }
  if (node->find("value") != nullptr) {
    const auto values = parse_numbers((*node)["value"]);
    if (!values || values->size() != 3) {
      wrong(*node, "three numbers");
      return otherwise;
    }
    return {(*values)[0], (*values)[1], (*values)[2]};
  }
  glm::vec3 out(0);
  constexpr std::string_view kAxes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const XmlAttribute* axis = node->find(kAxes[i]);
    const std::optional<float> value = axis == nullptr ? std::optional(0.0f) : parse_number(axis->value);
    if (!value) {
      in_.error(axis->place, "expected a number, found \"" + axis->value + "\"");
    }
    out[i] = value.value_or(0);
  }
  return out;
}

glm::mat4 MitsubaObject::transform(std::string_view name) {
  const XmlNode* node = take(name, {"transform"});
  return node == nullptr ? glm::mat4(1) : read_transform(in_, *node);
}

Rgb MitsubaObject::colour(std::string_view name, Rgb otherwise, const Range& range) {
  const XmlNode* node = take(name, {"rgb", "srgb", "spectrum", "blackbody", "float", "color"});
  return node == nullptr ? otherwise : read_colour(in_, *node, range);
}

std::filesystem::path MitsubaObject::file(std::string_view name) {
  const XmlNode* node = take(name, {"string"});
  if (node == nullptr) {
    if (!has(name)) {
      in_.error(place(), describe() + " needs \"" + std::string(name) + "\"");
    }
    return {};
  }
  const std::string_view value = (*node)["value"];
  const std::filesystem::path path = in_.document.find_file(value);
  if (std::error_code ignored; value.empty() || !std::filesystem::is_regular_file(path, ignored)) {
    wrong(*node, "a file that can be read");
    return {};
  }
  return path;
}

std::vector<const XmlNode*> MitsubaObject::nested(std::string_view tag) {
  std::vector<const XmlNode*> out;
  for (const XmlNode& child : node_.children) {
    if (child.tag == tag) {
      asked_.insert(&child);
      out.push_back(&child);
    } else if (child.tag == "ref" && asked_.count(&child) == 0) {
      const auto found = in_.objects.find(child["id"]);
      const bool is_wanted = found != in_.objects.end() && found->second->tag == tag;
      // A reference to nothing is told once, by whoever asks first.
      if (is_wanted || found == in_.objects.end()) {
        asked_.insert(&child);
        if (const XmlNode* object = in_.resolve(child)) {
          out.push_back(object);
        }
      }
    }
  }
  return out;
}

void MitsubaObject::skip(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    find(name);
  }
}

void MitsubaObject::skip_all() {
  for (const XmlNode& child : node_.children) {
    asked_.insert(&child);
  }
}

void tell_unknown(MitsubaObject& object, const std::vector<std::string>& known, const std::string& instead) {
  const std::string near = nearest(object.type(), known);
  object.in().ignored(object.place(), object.describe() + " is not known" +
                                          (near.empty() ? "" : " (did you mean \"" + near + "\"?)") + ": " + instead);
  object.skip_all();
}

}  // namespace heckbert::import
