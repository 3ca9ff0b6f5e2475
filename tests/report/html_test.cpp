#include <heckbert/report/html.h>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/report/facts.h>
#include <heckbert/report/html_text.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/picture.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

using test::four_grammars;
using test::lecture_like_record;
using ::testing::HasSubstr;
using ::testing::Not;

std::string page_of(const record::Record& record, const HtmlOptions& options = {}) {
  return html(record, coverage(record, four_grammars()), classify(record, GroupBy::Word, {}), options);
}

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

/// Every piece of the text between `before` and the next `after`.
std::vector<std::string> between(const std::string& text, const std::string& before, const std::string& after) {
  std::vector<std::string> pieces;
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    pieces.push_back(text.substr(at, text.find(after, at) - at));
  }
  return pieces;
}

const std::string png_data = "data:image/png;base64,";

std::vector<std::string> pictures_of(const std::string& page) {
  return between(page, png_data, "\"");
}

/// The page without its style sheet and without the data of its pictures.
std::string skeleton(const std::string& page) {
  std::string rest = page.substr(0, page.find("<style>") + 7) + page.substr(page.find("</style>"));
  for (std::size_t at = rest.find(png_data); at != std::string::npos; at = rest.find(png_data, at)) {
    at += png_data.size();
    rest.erase(at, rest.find('"', at) - at);
  }
  return rest;
}

/// What is wrong with the nesting of tags; empty when nothing is.
std::string nesting_error(const std::string& page) {
  static const std::set<std::string> without_end{"!DOCTYPE", "meta", "img"};
  std::vector<std::string> open;
  for (const std::string& tag : between(page, "<", ">")) {
    const bool closes = tag.starts_with('/');
    const std::string name = tag.substr(closes ? 1 : 0, tag.find(' ') - (closes ? 1 : 0));
    if (without_end.count(name) != 0) continue;
    if (!closes) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> closes " + (open.empty() ? "nothing" : "<" + open.back() + ">");
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

TEST(Html, NestingCheckerSeesMistakes) {
  EXPECT_EQ(nesting_error("<p><b>x</b></p>"), "");
  EXPECT_EQ(nesting_error("<p><b>x</p></b>"), "</p> closes <b>");
  EXPECT_EQ(nesting_error("<p>"), "<p> is not closed");
}

TEST(Html, IsWellNestedWithAndWithoutLight) {
  record::Record with_buffers = lecture_like_record(8, 6);
  with_buffers.ambient.assign(48, Rgb(0.1f));
  with_buffers.info.partial = true;
  const std::vector<record::Record> records{lecture_like_record(8, 6), with_buffers, test::sample_record(4, 4, {}),
                                            test::sample_record(4, 4, {{.word = "LDE", .batches = {0, 0}}}),
                                            test::sample_record(1, 1, {{.word = "LE", .batches = {1}}})};
  for (const record::Record& record : records) EXPECT_EQ(nesting_error(skeleton(page_of(record))), "");
}

TEST(Html, FetchesNothingAndRunsNothing) {
  const std::string page = page_of(lecture_like_record(8, 6));
  const std::string text = skeleton(page);
  const auto links = between(text, "href=\"", "\""), sources = between(text, "src=\"", "\"");
  EXPECT_EQ(links.size(), 6u + 4u) << "sections and algorithms";
  EXPECT_EQ(sources.size(), 1u + 2u * 4u) << "the picture and two parts of it per algorithm";
  for (const std::string& link : links) EXPECT_TRUE(link.starts_with("#")) << link;
  for (const std::string& source : sources) EXPECT_EQ(source, png_data);
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
}

TEST(Html, LinksLeadToPlacesOnThePage) {
  const std::string text = skeleton(page_of(lecture_like_record(8, 6)));
  const auto links = between(text, "href=\"#", "\"");
  EXPECT_EQ(links.size(), 6u + 4u) << "sections and algorithms";
  for (const std::string& link : links) EXPECT_EQ(count_of(text, "id=\"" + link + '"'), 1u) << link;
}

TEST(Html, SaysWhichPartTheNumbersAreAbout) {
  const record::Record record = lecture_like_record(8, 6);
  const Part pixel{.pixels = record::Window{3, 2, 4, 3}, .words = {}, .description = "pixel 3, 2"};
  const Coverage coverage = report::coverage(record, four_grammars(), {.part = pixel});
  const std::string text = skeleton(html(record, coverage, classify(record, GroupBy::Word, {}, {.part = pixel})));
  EXPECT_THAT(text, HasSubstr("about <strong>pixel 3, 2</strong>"));
  const std::string words = text.substr(text.find("id=\"words\""));
  EXPECT_THAT(words, HasSubstr("<code>" + coverage.words.front().word + "</code>"));
  EXPECT_THAT(words, HasSubstr(escaped(percent(coverage.words.front().share.mean))));
  EXPECT_THAT(skeleton(page_of(record)), Not(HasSubstr("numbers on this page are about")));
}

TEST(Html, ListsLabelsWhereThereAreSome) {
  const record::Record record = lecture_like_record(8, 6);
  EXPECT_THAT(skeleton(page_of(record)), Not(HasSubstr("What the light met")));
  Classification labels = classify(record, GroupBy::Label, {});
  labels.groups = {{.name = "<ball>", .expression = {}, .energy = {}, .share = {.mean = 0.25}}};
  const std::string text =
      skeleton(html(record, coverage(record, four_grammars()), classify(record, GroupBy::Word, {}), {}, {&labels, 1}));
  const std::string section = text.substr(text.find("What the light met"));
  EXPECT_THAT(section, HasSubstr("&lt;ball&gt;"));
  EXPECT_THAT(section, HasSubstr("25.0"));
  EXPECT_THAT(section, HasSubstr("labels of all events"));
}

TEST(Html, ShowsEveryGrammarWithItsWords) {
  const record::Record record = lecture_like_record(8, 6);
  const Coverage coverage = report::coverage(record, four_grammars());
  const std::string text = skeleton(html(record, coverage, classify(record, GroupBy::Word, {})));
  for (const GrammarCoverage& grammar : coverage.grammars) {
    const std::size_t begin = text.find("<article id=\"algorithm-" + grammar.name + '"');
    ASSERT_NE(begin, std::string::npos) << grammar.name;
    const std::string article = text.substr(begin, text.find("</article>", begin) - begin);
    EXPECT_THAT(article, HasSubstr(escaped(grammar.title)));
    EXPECT_THAT(article, HasSubstr(escaped(grammar.expression)));
    EXPECT_THAT(article, HasSubstr(escaped(grammar.source)));
    for (const auto* cautions : {&grammar.biases, &grammar.variances, &grammar.preconditions})
      for (const std::string& caution : *cautions) EXPECT_THAT(article, HasSubstr(escaped(caution)));
    for (const auto* words : {&grammar.top_captured, &grammar.top_missed})
      for (const WordEnergy& word : *words) EXPECT_THAT(article, HasSubstr("<code>" + word.word + "</code>"));
    EXPECT_EQ(count_of(article, "<img "), 2u) << "captured and missed";
  }
}

TEST(Html, ShowsTheFactsTheRuleAndTheTaxonomy) {
  const record::Record record = lecture_like_record(8, 6);
  const std::string text = skeleton(page_of(record));
  for (const Fact& fact : facts(record.info, record.tally))
    EXPECT_THAT(text, HasSubstr("<dt>" + fact.label + "</dt><dd>" + escaped(fact.value) + "</dd>"));
  EXPECT_THAT(text, HasSubstr(escaped(describe(taxonomy::GlossyRule::Keep))));
  for (const TaxonomyLine& line : kTaxonomyLines)
    EXPECT_THAT(text, HasSubstr("<code>" + escaped(line.expression) + "</code>"));
}

TEST(Html, CutsTheWordsOfTheSceneAndSaysSo) {
  const record::Record record = lecture_like_record(8, 6);
  const std::string text = skeleton(page_of(record, {.words = 5}));
  EXPECT_THAT(text, HasSubstr("And 7 more words with "));
  EXPECT_THAT(skeleton(page_of(record)), Not(HasSubstr("more word")));
}

TEST(Html, AllPicturesHaveOneExposure) {
  const record::Record record = lecture_like_record(8, 6);
  const Coverage coverage = report::coverage(record, four_grammars());
  const float exposure = auto_exposure(record::beauty(record));
  std::vector<std::string> expected{base64(encode_png(to_srgb(record::beauty(record), exposure)))};
  for (const GrammarCoverage& grammar : coverage.grammars) {
    std::vector<bool> missed = grammar.captured;
    missed.flip();
    for (const auto& words : {grammar.captured, missed})
      expected.push_back(base64(encode_png(to_srgb(image_of(record, words), exposure))));
  }
  EXPECT_EQ(pictures_of(html(record, coverage, classify(record, GroupBy::Word, {}))), expected);
  EXPECT_EQ(pictures_of(html(record, coverage, classify(record, GroupBy::Word, {}), {.exposure = 3.0f}))[0],
            base64(encode_png(to_srgb(record::beauty(record), 3.0f))));
}

TEST(Html, EveryPictureHasAnAlternativeText) {
  const std::string text = skeleton(page_of(lecture_like_record(8, 6)));
  const auto images = between(text, "<img ", ">");
  EXPECT_EQ(images.size(), 9u);
  for (const std::string& image : images) {
    const auto alternatives = between(image, "alt=\"", "\"");
    ASSERT_EQ(alternatives.size(), 1u) << image;
    EXPECT_GT(alternatives[0].size(), 10u) << image;
  }
  EXPECT_THAT(text, HasSubstr("alt=\"Ray casting captures "));
}

TEST(Html, EscapesWhatUsersWrite) {
  record::Record record = lecture_like_record(4, 4);
  record.info.scene = "<script>alert('x')</script> & \"more\"";
  record.info.algorithm = record.info.version = "<b>";
  auto grammars = four_grammars();
  grammars[0].title = "<i>title</i>";
  grammars[0].name = "a\"b";
  grammars[0].source = "<u>source</u>";
  grammars[0].biases = {"<s>bias</s>"};
  const std::string text = skeleton(html(record, coverage(record, grammars), classify(record, GroupBy::Word, {})));
  for (const char* bad : {"<script", "<b>&", "<i>title", "a\"b\"", "<u>", "<s>", "name=\"<b>"})
    EXPECT_THAT(text, Not(HasSubstr(bad)));
  EXPECT_THAT(text, HasSubstr("<h1>&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;more&quot;</h1>"));
  EXPECT_EQ(nesting_error(text), "");
}

TEST(Html, EscapesSmallShares) {
  const record::Record record =
      test::sample_record(1, 1, {{.word = "LDE", .batches = {1, 1}}, {.word = "LSE", .batches = {1e-5f, 1e-5f}}});
  const std::string text = skeleton(page_of(record, {.words = 1}));
  EXPECT_THAT(text, HasSubstr("<td class=\"number\">&lt; 0.01 %</td>"));
  EXPECT_THAT(text, HasSubstr("And 1 more word with &lt; 0.01 %"));
  EXPECT_THAT(text, Not(HasSubstr("< 0")));
}

TEST(Html, ShowsLightThatNoPathCarriesOnlyWhenThereIsSome) {
  record::Record record = lecture_like_record(4, 4);
  EXPECT_THAT(skeleton(page_of(record)), Not(HasSubstr("no path carries")));
  const std::string before = page_of(record);
  record.phantom.assign(16, Rgb(0.5f));
  const std::string text = skeleton(page_of(record));
  EXPECT_THAT(text, HasSubstr("outside of coverage"));
  EXPECT_THAT(text, HasSubstr("Phantom mirror"));
  EXPECT_THAT(text, Not(HasSubstr("Ambient term")));
  auto pictures = pictures_of(page_of(record));
  pictures.pop_back();
  EXPECT_EQ(pictures, pictures_of(before)) << "it changes no other picture";
}

TEST(Html, WarnsOfWhatMustNotBeOverlooked) {
  record::Record record = lecture_like_record(4, 4);
  EXPECT_EQ(count_of(page_of(record), "class=\"warning\""), 0u);
  record.info.partial = true;
  record.tally.rejected_not_finite = 3;
  const std::string text = skeleton(page_of(record));
  EXPECT_THAT(text, HasSubstr("interrupted"));
  EXPECT_THAT(text, HasSubstr("3 not finite"));
}

TEST(Html, SaysWhichSamplesAPartHas) {
  record::Record record = lecture_like_record(8, 8);
  const std::string traced = "16 samples per pixel, ";
  EXPECT_THAT(page_of(record), HasSubstr(traced + "seed 7."));
  record.info.parts = {{.seed = 7, .of = 64, .first = 16, .last = 32}};
  EXPECT_THAT(page_of(record), HasSubstr(traced + "samples 16 to 31 of 64, seed 7."));
}

TEST(Html, SaysThatLongWordsAreFoldedAndWhatThatLeavesOpen) {
  record::Record record = lecture_like_record(4, 4);
  record.folding = record::Folding{.longest = 2, .first = record.words.size() - 1, .exact = {}};
  const std::string page = page_of(record), text = skeleton(page);
  EXPECT_EQ(count_of(page, "class=\"warning\""), 1u);
  EXPECT_THAT(text, HasSubstr("words of more than 2 scatterings"));
  EXPECT_THAT(text, HasSubstr("at least; the rest of the interval is folded words"));
}

TEST(Base64, EncodesTheVectorsOfRfc4648) {
  const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, encoded] : vectors) EXPECT_EQ(base64(std::as_bytes(std::span(plain))), encoded);
  const std::string high = "\xfb\xff\xfe";
  EXPECT_EQ(base64(std::as_bytes(std::span(high))), "+//+");
}

}  // namespace
}  // namespace heckbert::report
