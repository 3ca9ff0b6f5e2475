// What is written as JSON against docs/json.md, key by key and in both directions.

#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <heckbert/report/classify.h>
#include <heckbert/report/coverage_json.h>
#include <heckbert/report/grammar_text.h>
#include <heckbert/report/words_text.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

using Json = nlohmann::json;
using Keys = std::map<std::string, std::string>;  ///< path -> type, as in the document

/// "| `key` | type | meaning |" -> {"key", "type"}; nothing for other lines.
std::optional<std::pair<std::string, std::string>> table_row(const std::string& line) {
  const std::string start = "| `", middle = "` | ", end = " | ";
  const std::size_t type = line.find(middle);
  if (!line.starts_with(start) || type == std::string::npos) return std::nullopt;
  const std::size_t type_begin = type + middle.size();
  return std::pair{line.substr(start.size(), type - start.size()),
                   line.substr(type_begin, line.find(end, type_begin) - type_begin)};
}

/// The tables of docs/json.md by heading.
std::map<std::string, Keys> documented() {
  std::ifstream file(HECKBERT_SOURCE_DIR "/docs/json.md");
  std::map<std::string, Keys> sections;
  std::string section;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("##")) section = line.substr(line.rfind(' ') + 1);
    if (const auto row = table_row(line)) sections[section].insert(*row);
  }
  return sections;
}

/// The keys of a section with those of the sections that its types link to, as in "[estimate](#estimate)".
Keys expanded(const std::map<std::string, Keys>& sections, const std::string& name) {
  Keys keys;
  for (const auto& [path, type] : sections.at(name)) {
    if (!type.starts_with('[')) {
      keys[path] = type;
      continue;
    }
    for (const auto& [inner, inner_type] : expanded(sections, type.substr(1, type.find(']') - 1))) {
      std::string whole = path;
      whole += '.';
      whole += inner;
      keys[whole] = inner_type;
    }
  }
  return keys;
}

std::string type_of(const Json& value) {
  if (value.is_string()) return "string";
  if (value.is_boolean()) return "boolean";
  if (value.is_number_integer()) return "integer";
  if (value.is_number()) return "number";
  return value.type_name();
}

void collect(const Json& value, const std::string& path, Keys& keys) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      std::string whole = path;
      if (!path.empty()) whole += '.';
      whole += key;
      collect(inner, whole, keys);
    }
  } else if (value.is_array()) {
    for (const Json& inner : value) collect(inner, path + "[]", keys);
  } else {
    keys[path] = type_of(value);
  }
}

Keys written(const std::string& text) {
  Keys keys;
  collect(Json::parse(text), "", keys);
  return keys;
}

taxonomy::GrammarLibrary library() {
  taxonomy::GrammarLibrary result;
  result.grammars = test::four_grammars();
  return result;
}

std::vector<taxonomy::Grammar> grammars_and_a_proxy() {
  std::vector<taxonomy::Grammar> grammars = test::four_grammars();
  grammars.insert(grammars.begin() + 1, test::proxy());
  return grammars;
}

std::map<std::string, std::string> documents() {
  const record::Record record = test::lecture_like_record(4, 4);
  const ClassifyOptions options;
  const Coverage data = coverage(record, grammars_and_a_proxy());
  return {{"heckbert.coverage", coverage_json(data, judge(data, {{"lecture>=1", "lecture", 1}}))},
          {"heckbert.classify", classification_json(classify(record, GroupBy::Length, library(), options))},
          {"heckbert.grammars", grammar_list_json(library())}};
}

TEST(Json, KeysAndTypesAreThoseOfTheDocumentation) {
  const auto sections = documented();
  const auto all = documents();
  ASSERT_EQ(all.size(), 3u);
  for (const auto& [schema, text] : all) {
    ASSERT_TRUE(sections.count(schema)) << schema << " has no section in docs/json.md";
    EXPECT_EQ(written(text), expanded(sections, schema)) << schema;
    EXPECT_EQ(Json::parse(text)["schema"], schema);
    EXPECT_EQ(Json::parse(text)["schema_version"], 1);
  }
}

TEST(Json, CoverageHoldsTheNumbersOfTheData) {
  const Coverage data = coverage(test::lecture_like_record(4, 4), test::four_grammars());
  const Json json = Json::parse(coverage_json(data));
  EXPECT_EQ(json["total"]["mean"].get<double>(), data.total.mean);
  EXPECT_EQ(json["glossy_rule"], "keep");
  ASSERT_EQ(json["grammars"].size(), data.grammars.size());
  for (std::size_t i = 0; i < data.grammars.size(); ++i) {
    EXPECT_EQ(json["grammars"][i]["name"], data.grammars[i].name);
    EXPECT_EQ(json["grammars"][i]["share"]["lower"].get<double>(), data.grammars[i].share.lower);
    EXPECT_EQ(json["grammars"][i]["top_missed"].size(), data.grammars[i].top_missed.size());
  }
  EXPECT_TRUE(json["left_out"].empty());
  const Json with_proxy = Json::parse(coverage_json(coverage(test::lecture_like_record(4, 4), grammars_and_a_proxy())));
  EXPECT_EQ(with_proxy["grammars"], json["grammars"]);
  ASSERT_EQ(with_proxy["left_out"].size(), 1u);
  EXPECT_EQ(with_proxy["left_out"][0]["name"], "occlusion");
  ASSERT_EQ(json["words"].size(), data.words.size());
  EXPECT_EQ(json["words"][0]["word"], data.words[0].word);
  EXPECT_EQ(json["words"][0]["count"], data.words[0].count);
}

TEST(Json, SurvivesAFileNameThatIsNotUtf8AndTheLargestSeed) {
  record::Record record = test::lecture_like_record(2, 2);
  record.info.scene = "caf\xe9";
  record.info.seed = ~std::uint64_t{0};
  const Json json = Json::parse(coverage_json(coverage(record, {})));
  EXPECT_EQ(json["render"]["scene"], "caf\xef\xbf\xbd");
  EXPECT_EQ(json["render"]["seed"].get<std::uint64_t>(), ~std::uint64_t{0});
}

TEST(Json, EmptyRecordIsADocumentToo) {
  const Json json = Json::parse(coverage_json(coverage(test::sample_record(1, 1, {}), test::four_grammars())));
  EXPECT_TRUE(json["words"].empty());
  EXPECT_EQ(json["grammars"][0]["share"]["mean"], 0.0);
}

}  // namespace
}  // namespace heckbert::report
