#pragma once
// Pages of documentation as tests read and write them: tables, and places that are generated.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace heckbert::taxonomy::markdown {

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

/// `a\|b`: a text as code in a cell.
inline std::string code(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return "`" + escaped + "`";
}

/// The text of a cell that is code.
inline std::string text_of_code(const std::string& cell) {
  EXPECT_TRUE(cell.size() > 2 && cell.front() == '`' && cell.back() == '`') << cell;
  return cell.substr(1, cell.size() - 2);
}

inline std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The cells of a table row, escaped bars as they are meant.
inline std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> list;
  std::string cell;
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i] == '\\' && i + 1 < row.size() && row[i + 1] == '|') continue;
    if (row[i] == '|' && row[i - 1] != '\\') {
      list.push_back(trimmed(cell));
      cell.clear();
    } else {
      cell += row[i];
    }
  }
  return list;
}

/// The rows of the table of a page whose header is this.
inline std::vector<std::vector<std::string>> table(const std::filesystem::path& page, const std::string& header) {
  std::istringstream text(file_text(page));
  std::vector<std::vector<std::string>> rows;
  std::string line;
  while (std::getline(text, line) && line != header) continue;
  std::getline(text, line);  // the rule under the header
  while (std::getline(text, line) && line.starts_with("|")) rows.push_back(cells(line));
  EXPECT_FALSE(rows.empty()) << header;
  return rows;
}

/// The page with the text between "<!-- name, generated -->" and "<!-- end -->" replaced.
inline std::string with_generated(const std::string& page, const std::string& name, const std::string& text) {
  const std::string begin = "<!-- " + name + ", generated -->\n", end = "<!-- end -->";
  const std::size_t from = page.find(begin);
  const std::size_t to = from == std::string::npos ? from : page.find(end, from);
  if (to == std::string::npos) return "no place for '" + name + "'";
  return page.substr(0, from + begin.size()) + text + page.substr(to);
}

/// The page is as expected; HECKBERT_UPDATE_DOCS=1 in the environment writes it so.
inline void expect_page(const std::filesystem::path& page, const std::string& expected, const std::string& program) {
  if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr) std::ofstream(page) << expected;
  const std::string written = file_text(page);
  const auto [a, b] = std::mismatch(written.begin(), written.end(), expected.begin(), expected.end());
  EXPECT_TRUE(written == expected) << page << " is not what it should be from byte " << a - written.begin() << ", '"
                                   << std::string(b, expected.end()).substr(0, 60)
                                   << "'; write it anew: HECKBERT_UPDATE_DOCS=1 " << program;
}

}  // namespace heckbert::taxonomy::markdown
