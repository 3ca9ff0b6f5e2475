#include <heckbert/cli/config_file.h>

#include <algorithm>

namespace heckbert::cli {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// A piece of the text that remembers where it is.
struct Piece {
  std::string_view text;
  std::size_t offset = 0;
};

Piece trimmed(Piece piece) {
  const std::size_t begin = std::min(piece.text.find_first_not_of(kBlanks), piece.text.size());
  const std::size_t end = piece.text.find_last_not_of(kBlanks);
  if (begin == piece.text.size()) return {{}, piece.offset + begin};
  return {piece.text.substr(begin, end + 1 - begin), piece.offset + begin};
}

/// The line up to a # that is not inside quotes.
std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote != 0) {
      if (line[i] == quote) quote = 0;
    } else if (line[i] == '"' || line[i] == '\'') {
      quote = line[i];
    } else if (line[i] == '#') {
      return line.substr(0, i);
    }
  }
  return line;
}

Piece unquoted(Piece piece) {
  const std::string_view t = piece.text;
  if (t.size() >= 2 && (t.front() == '"' || t.front() == '\'') && t.back() == t.front())
    return {t.substr(1, t.size() - 2), piece.offset + 1};
  return piece;
}

}  // namespace

std::vector<ConfigEntry> parse_config(std::string_view text, std::string_view source,
                                      const std::vector<std::string>& known_names) {
  std::vector<ConfigEntry> entries;
  std::vector<Diagnostic> errors;
  const auto refuse = [&](Piece where, std::string message, std::string suggestion = {}) {
    errors.push_back(diagnose(source, text, where.offset, std::max<std::size_t>(where.text.size(), 1),
                              std::move(message), std::move(suggestion)));
  };

  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const Piece line = trimmed({without_comment(text.substr(begin, end - begin)), begin});
    begin = end + 1;
    if (line.text.empty()) continue;

    const std::size_t equals = line.text.find('=');
    if (equals == std::string_view::npos) {
      refuse(line, "this is no setting: expected name = value");
      continue;
    }
    const Piece name = trimmed({line.text.substr(0, equals), line.offset});
    const Piece value = unquoted(trimmed({line.text.substr(equals + 1), line.offset + equals + 1}));
    const std::string key(name.text);
    if (std::find(known_names.begin(), known_names.end(), key) == known_names.end()) {
      const std::string near = nearest(key, known_names);
      refuse(name, "there is no setting '" + key + "'", near.empty() ? "" : "did you mean '" + near + "'?");
    } else if (std::any_of(entries.begin(), entries.end(), [&](const ConfigEntry& e) { return e.name == key; })) {
      refuse(name, "'" + key + "' is set twice");
    } else {
      entries.push_back({key, std::string(value.text), name.offset, value.offset});
    }
  }
  if (!errors.empty()) throw InputError(std::move(errors));
  return entries;
}

}  // namespace heckbert::cli
