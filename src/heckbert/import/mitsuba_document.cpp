#include <heckbert/import/mitsuba_document.h>

#include <algorithm>
#include <cctype>
#include <map>

#include <pugixml.hpp>

#include <heckbert/import/text_file.h>
#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxErrors = 100;
constexpr std::size_t kMaxDepth = 100;
constexpr std::size_t kMaxIncludes = 100;

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

class Builder {
 public:
  explicit Builder(XmlDocument& document) : document_(document) {}

  void read(const fs::path& path) {
    document_.folders.push_back(path.parent_path());
    read_file(path, document_.root);
    if (document_.root.tag.empty() && errors_.empty()) {
      error({&document_.sources.front(), 0, 1}, "expected a Mitsuba scene: <scene version=\"...\">");
    }
  }

  std::vector<Diagnostic> errors() { return std::move(errors_); }

 private:
  void error(const XmlPlace& place, std::string message, std::string suggestion = {}) {
    if (errors_.size() < kMaxErrors) {
      errors_.push_back(diagnose(place, std::move(message), std::move(suggestion)));
    }
  }

  /// The element of the file: into `root` when that is empty, else its children become children of `root`.
  void read_file(const fs::path& path, XmlNode& root) {
    const XmlSource& source = document_.sources.emplace_back(XmlSource{path.string(), read_text_file(path)});
    pugi::xml_document xml;
    const pugi::xml_parse_result result =
        xml.load_buffer(source.text.data(), source.text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
      error({&source, static_cast<std::size_t>(result.offset), 1},
            std::string("this is no XML: ") + result.description());
      return;
    }
    const pugi::xml_node element = xml.document_element();
    if (element.name() != std::string_view("scene")) {
      error(place_of(element, source),
            "expected a Mitsuba scene: <scene version=\"...\">, found <" + std::string(element.name()) + ">");
      return;
    }
    if (root.tag.empty()) {
      root = shallow(element, source);
    }
    add_children(element, source, root, 0);
  }

  static XmlPlace place_of(const pugi::xml_node& node, const XmlSource& source) {
    const std::ptrdiff_t offset = node.offset_debug();
    return {&source, offset < 0 ? 0 : static_cast<std::size_t>(offset), std::string_view(node.name()).size()};
  }

  /// pugixml does not say where attributes stand, so the n-th one is looked for in the text of its tag.
  static XmlPlace place_of_value(const XmlPlace& tag, std::size_t index) {
    const std::string& text = tag.source->text;
    std::size_t at = tag.offset;
    for (std::size_t i = 0;; ++i) {
      const std::size_t open = text.find_first_of("\"'", at);
      const std::size_t close = open == std::string::npos ? open : text.find(text[open], open + 1);
      if (close == std::string::npos) {
        return tag;
      }
      if (i == index) {
        return {tag.source, open + 1, std::max<std::size_t>(1, close - open - 1)};
      }
      at = close + 1;
    }
  }

  XmlNode shallow(const pugi::xml_node& from, const XmlSource& source) {
    XmlNode node{snake_case(from.name()), place_of(from, source), {}, {}};
    for (const pugi::xml_attribute& attribute : from.attributes()) {
      const XmlPlace place = place_of_value(node.place, node.attributes.size());
      node.attributes.push_back({attribute.name(), with_parameters(attribute.value(), place), place});
      if (node.attributes.back().name == "name") {
        node.attributes.back().value = snake_case(node.attributes.back().value);
      }
    }
    return node;
  }

  void add_children(const pugi::xml_node& from, const XmlSource& source, XmlNode& to, std::size_t depth) {
    if (depth == kMaxDepth) {
      error(to.place, "elements are nested more than " + std::to_string(kMaxDepth) + " deep");
      return;
    }
    for (const pugi::xml_node& child : from.children()) {
      if (child.type() != pugi::node_element) {
        continue;
      }
      XmlNode node = shallow(child, source);
      if (node.tag == "default") {
        // A default does not change what is set already, by a file that includes this one.
        if (require(node, "name") && require(node, "value")) {
          parameters_.try_emplace(std::string(child.attribute("name").value()), node["value"]);
        }
      } else if (node.tag == "include") {
        include(node, to);
      } else if (node.tag == "path") {
        if (require(node, "value")) {
          document_.folders.push_back(document_.find_file(node["value"]));
        }
      } else {
        add_children(child, source, node, depth + 1);
        to.children.push_back(std::move(node));
      }
    }
  }

  void include(const XmlNode& node, XmlNode& to) {
    if (!require(node, "filename")) {
      return;
    }
    const XmlPlace place = node.find("filename")->place;
    const fs::path path = document_.find_file(node["filename"]);
    if (std::find(open_.begin(), open_.end(), path) != open_.end() || path == document_.sources.front().name) {
      error(place, "this file includes itself");
      return;
    }
    if (document_.sources.size() > kMaxIncludes) {
      error(place, "more than " + std::to_string(kMaxIncludes) + " files are included");
      return;
    }
    open_.push_back(path);
    try {
      read_file(path, to);
    } catch (const ReadError& problem) {
      error(place, problem.what());
    }
    open_.pop_back();
  }

  bool require(const XmlNode& node, std::string_view attribute) {
    if (node.find(attribute) == nullptr) {
      error(node.place, "<" + node.tag + "> needs the attribute \"" + std::string(attribute) + "\"");
      return false;
    }
    return true;
  }

  std::string with_parameters(std::string_view text, const XmlPlace& place) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
      const auto end = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at) + 1, text.end(), is_letter);
      const std::string name(text.begin() + static_cast<std::ptrdiff_t>(at) + 1, end);
      if (text[at] != '$' || name.empty()) {
        out += text[at++];
        continue;
      }
      at += 1 + name.size();
      if (const auto found = parameters_.find(name); found != parameters_.end()) {
        out += found->second;
      } else {
        error_unset(name, place);
      }
    }
    return out;
  }

  void error_unset(const std::string& name, const XmlPlace& place) {
    std::vector<std::string> known;
    for (const auto& [parameter, value] : parameters_) {
      known.push_back(parameter);
    }
    const std::string near = nearest(name, known);
    error(place, "the parameter $" + name + " has no value",
          near.empty() ? "give it one: <default name=\"" + name + "\" value=\"...\"/>" : "did you mean $" + near + "?");
  }

  XmlDocument& document_;
  std::map<std::string, std::string> parameters_;
  std::vector<fs::path> open_;  ///< files being included
  std::vector<Diagnostic> errors_;
};

}  // namespace

Diagnostic diagnose(const XmlPlace& place, std::string message, std::string suggestion) {
  return heckbert::diagnose(place.source->name, place.source->text, place.offset, place.length, std::move(message),
                            std::move(suggestion));
}

std::string to_text(const XmlPlace& place) {
  const std::string& text = place.source->text;
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(place.offset, text.size()));
  return fs::path(place.source->name).filename().string() + ":" +
         std::to_string(1 + std::count(text.begin(), end, '\n'));
}

const XmlAttribute* XmlNode::find(std::string_view attribute) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const XmlAttribute& a) { return a.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string_view XmlNode::operator[](std::string_view attribute) const {
  const XmlAttribute* found = find(attribute);
  return found == nullptr ? std::string_view() : found->value;
}

fs::path XmlDocument::find_file(std::string_view name) const {
  for (const fs::path& folder : folders) {
    if (std::error_code ignored; fs::exists(folder / name, ignored)) {
      return folder / name;
    }
  }
  return folders.front() / name;
}

XmlDocument read_mitsuba_document(const fs::path& path) {
  XmlDocument document;
  Builder builder(document);
  builder.read(path);
  if (std::vector<Diagnostic> errors = builder.errors(); !errors.empty()) {
    throw InputError(std::move(errors));
  }
  return document;
}

std::string snake_case(std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool upper = std::isupper(static_cast<unsigned char>(name[i])) != 0;
    if (upper && i > 0 && std::isupper(static_cast<unsigned char>(name[i - 1])) == 0 && name[i - 1] != '_') {
      out += '_';
    }
    out += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return out;
}

}  // namespace heckbert::import
