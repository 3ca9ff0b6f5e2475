// The reference pages are what the readers do: their tables are the readers' own, and their examples load.
// To bring a page up to date, run this program with HECKBERT_UPDATE_DOCS=1.

#include <cstdlib>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/mitsuba_reader.h>
#include <heckbert/import/obj_materials.h>
#include <heckbert/import/scene_format.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

struct Page {
  const char* file;
  std::string (*reference)();
};

const Page kPages[] = {{"docs/scene-format.md", scene_format_reference},
                       {"docs/obj-import.md", obj_rule_reference},
                       {"docs/mitsuba-import.md", mitsuba_plugin_reference}};

constexpr std::string_view kBegin = "<!-- reference -->\n";
constexpr std::string_view kEnd = "<!-- end of reference -->\n";

TEST(ReferenceDocs, ContainTheTablesOfTheReadersWordForWord) {
  for (const Page& page : kPages) {
    SCOPED_TRACE(page.file);
    const std::string text = read_all(kSourceDir / page.file);
    const std::size_t begin = text.find(kBegin);
    const std::size_t end = text.find(kEnd);
    ASSERT_NE(begin, std::string::npos);
    const std::string expected = "\n" + page.reference() + "\n";
    if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr) {
      const std::size_t tail = end == std::string::npos ? begin + kBegin.size() : end + kEnd.size();
      std::ofstream(kSourceDir / page.file, std::ios::binary)
          << text.substr(0, begin) << kBegin << expected << kEnd << text.substr(tail);
      continue;
    }
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(text.substr(begin + kBegin.size(), end - begin - kBegin.size()), expected);
  }
}

std::vector<std::string> json_blocks(const std::string& text) {
  constexpr std::string_view kOpen = "```json\n";
  std::vector<std::string> out;
  for (std::size_t at = text.find(kOpen); at != std::string::npos; at = text.find(kOpen, at + 1)) {
    const std::size_t begin = at + kOpen.size();
    out.push_back(text.substr(begin, text.find("```", begin) - begin));
  }
  return out;
}

void collect_keys(const JsonNode& node, std::set<std::string>& out) {
  for (const JsonKey& key : node.keys) {
    out.insert(key.text);
  }
  for (const JsonNode& item : node.items) {
    collect_keys(item, out);
  }
}

TEST(SceneFormatPage, HasExamplesThatLoad) {
  const std::vector<std::string> blocks = json_blocks(read_all(kSourceDir / "docs/scene-format.md"));
  ASSERT_GE(blocks.size(), 3u);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::string name = "example " + std::to_string(i + 1);
    EXPECT_NO_THROW(read_json_scene(blocks[i], name, kSourceDir / "tests/import/data")) << name;
  }
}

TEST(SceneFormatPage, ShowsEveryKeyInAnExample) {
  std::set<std::string> shown;
  for (const std::string& block : json_blocks(read_all(kSourceDir / "docs/scene-format.md"))) {
    collect_keys(parse_json(block, "example").root, shown);
  }
  for (const ObjectFacts& object : scene_format()) {
    for (const KeyFacts& key : object.keys) {
      EXPECT_EQ(shown.count(key.name), 1u) << object.name << ": " << key.name;
    }
  }
}

}  // namespace
}  // namespace heckbert::import
