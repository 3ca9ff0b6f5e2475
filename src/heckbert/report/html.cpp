#include <heckbert/report/html.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <heckbert/report/facts.h>
#include <heckbert/report/html_text.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/picture.h>
#include <heckbert/report/words_text.h>
#include <heckbert/taxonomy/symbol.h>

namespace heckbert::report {

extern const char* const page_css;  // page.css, compiled in

namespace {

using fmt::arg;

std::string picture_element(const record::Image& image, float exposure, int width, std::string_view alternative) {
  const Picture picture = to_srgb(shrunk(image, width), exposure);
  if (picture.rgb.empty()) return "<p>The picture has no pixels.</p>";
  return fmt::format(R"(<img src="data:image/png;base64,{}" width="{}" height="{}" alt="{}">)",
                     base64(encode_png(picture)), picture.width, picture.height, escaped(alternative));
}

/// Small shares print with a "<".
std::string escaped_percent(double share) {
  return escaped(percent(share));
}

/// A bar as long as the share, with a mark over its interval. Ornament: the numbers stand beside it.
std::string bar(const record::Estimate& share) {
  const auto part = [](double x) { return 100 * std::clamp(x, 0.0, 1.0); };
  std::string marks = fmt::format(R"(<i style="width:{:.3f}%"></i>)", part(share.mean));
  if (share.known)
    marks += fmt::format(R"(<b style="left:{:.3f}%;width:{:.3f}%"></b>)", part(share.lower),
                         part(share.upper) - part(share.lower));
  return fmt::format(R"(<span class="bar" aria-hidden="true">{}</span>)", marks);
}

std::string anchor(const GrammarCoverage& grammar) {
  return escaped("algorithm-" + grammar.name);
}

/// The names of the words, for the alternative text of a picture.
std::string word_list(const std::vector<WordEnergy>& words) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(words.size(), 4); ++i) text += (i == 0 ? "" : ", ") + words[i].word;
  return text.empty() ? "no words" : text;
}

std::string introduction(const record::Record& record, const Coverage& coverage) {
  std::string notes;
  std::vector<std::string> to_note = warnings(coverage.info, coverage.tally);
  if (const std::string folded = folding(record); !folded.empty()) to_note.push_back(folded);
  for (const std::string& warning : to_note)
    notes += fmt::format("<p class=\"warning\"><strong>Take note.</strong> {}</p>\n", escaped(warning));
  if (!coverage.part.is_whole())
    notes += fmt::format(
        "<p class=\"part\">The numbers on this page are about <strong>{}</strong>; pictures show all "
        "pixels and words.</p>\n",
        escaped(coverage.part.description));
  return fmt::format(R"(<header>
<p class="kind">Light-path coverage</p>
<h1>{scene}</h1>
<p class="lead">How much of the light in this picture would each rendering algorithm have captured, and what would it
have missed?</p>
{notes}<nav aria-label="Sections"><ul>
<li><a href="#picture">Picture</a></li>
<li><a href="#reading">How to read</a></li>
<li><a href="#shares">Shares</a></li>
<li><a href="#algorithms">Algorithms</a></li>
<li><a href="#words">Words</a></li>
<li><a href="#facts">Facts</a></li>
</ul></nav>
</header>
)",
                     arg("scene", escaped(coverage.info.scene)), arg("notes", notes));
}

std::string picture_section(const record::Image& beauty, const Coverage& coverage, float exposure, int width) {
  return fmt::format(R"(<section id="picture" aria-label="The picture">
<figure class="picture">{picture}
<figcaption>The picture: all recorded light. Traced with <code>{algorithm}</code>, {samples} samples per pixel, {which}.
Every picture on this page has the same exposure, {stops:+.2f} stops.</figcaption></figure>
</section>
)",
                     arg("picture", picture_element(beauty, exposure, width, "The picture of " + coverage.info.scene)),
                     arg("algorithm", escaped(coverage.info.algorithm)),
                     arg("samples", coverage.info.samples_per_pixel),
                     arg("which", escaped(samples_text(coverage.info))), arg("stops", std::log2(exposure)));
}

/// The plain letters with what they stand for, from the table of symbols: letters that differ only in their subscript
/// come together.
std::string letter_rows() {
  std::string rows;
  for (std::size_t i = 0; i < taxonomy::kSymbolCount;) {
    const char letter = taxonomy::kSymbols[i].letter;
    std::string meanings;
    for (; i < taxonomy::kSymbolCount && taxonomy::kSymbols[i].letter == letter; ++i)
      meanings += (meanings.empty() ? "" : ", ") + std::string(taxonomy::kSymbols[i].meaning);
    rows += fmt::format("<tr><th scope=\"row\"><code>{}</code></th><td>{}</td></tr>\n", letter, escaped(meanings));
  }
  return rows;
}

std::string reading_section(const Coverage& coverage) {
  std::string lines;
  for (const TaxonomyLine& line : kTaxonomyLines)
    lines += fmt::format("<tr><th scope=\"row\">{}</th><td><code>{}</code></td><td>{}</td></tr>\n", line.algorithm,
                         escaped(line.expression), line.meaning);
  return fmt::format(R"(<section id="reading">
<h2>How to read this page</h2>
<p>{direction}</p>
<p>An expression stands for many words at once: <code>?</code> means at most once, <code>*</code> any number of times,
also none, <code>+</code> at least once, <code>|</code> either of two. <code>N</code> is D or G, <code>X</code> is D, G
or S, and a dot is any event.</p>
<p>Glossy rule {rule}.</p>
<div class="columns">
<table><caption>The letters</caption>
<thead><tr><th scope="col">Letter</th><th scope="col">Meaning</th></tr></thead>
<tbody>
{letters}</tbody></table>
<table><caption>The taxonomy in four lines ({source})</caption>
<thead><tr><th scope="col">Algorithm</th><th scope="col">Captures</th><th scope="col">In words</th></tr></thead>
<tbody>
{lines}</tbody></table>
</div>
</section>
)",
                     arg("direction", kReadingDirection), arg("rule", escaped(describe(coverage.glossy_rule))),
                     arg("letters", letter_rows()), arg("source", kTaxonomySource), arg("lines", lines));
}

std::string list_of(std::string_view title, const std::vector<std::string>& texts) {
  if (texts.empty()) return {};
  std::string items;
  for (const std::string& text : texts) items += fmt::format("<li>{}</li>\n", escaped(text));
  return fmt::format("<p>{}:</p>\n<ul>\n{}</ul>\n", title, items);
}

/// Grammars that were asked for and have no share.
std::string left_out(const Coverage& coverage) {
  std::vector<std::string> sentences;
  for (const LeftOut& grammar : coverage.left_out) sentences.push_back(grammar.why);
  return list_of("Left out", sentences);
}

std::string shares_section(const Coverage& coverage) {
  std::string rows;
  for (const GrammarCoverage& grammar : coverage.grammars)
    rows += fmt::format(
        R"(<tr><th scope="row"><a href="#{anchor}">{title}</a></th><td class="captures"><code>{expression}</code></td>
<td class="number">{share}</td><td class="number">{interval}</td><td>{bias}</td><td class="number">{practical}</td>
<td class="number">{worst}</td><td class="wide">{bar}</td></tr>
)",
        arg("bias", is_biased(grammar) ? "yes" : "-"), arg("practical", escaped_percent(grammar.practical_share)),
        arg("worst", grammar.worst_pixel ? escaped_percent(grammar.worst_pixel->share) : "-"),
        arg("anchor", anchor(grammar)), arg("title", escaped(grammar.title)),
        arg("expression", escaped(grammar.expression)), arg("share", escaped_percent(grammar.share.mean)),
        arg("interval", percent_interval(grammar.share)), arg("bar", bar(grammar.share)));
  return fmt::format(R"(<section id="shares">
<h2>Shares of the light</h2>
<p>Share of the picture's mean luminance, {total}, that the words of each algorithm carry. An algorithm that captures a
word may still give it a wrong value, which is its bias, listed with each, or a noisy one. {practical}</p>
<div class="scroll" tabindex="0" role="region" aria-label="Shares of the light"><table class="shares">
<thead><tr><th scope="col">Algorithm</th><th scope="col" class="captures">Captures</th><th scope="col" class="number">Share</th>
<th scope="col" class="number">{level} interval</th><th scope="col">Bias</th>
<th scope="col" class="number">Practical</th><th scope="col" class="number">Worst pixel</th>
<th scope="col" class="wide"><span class="unseen">Bar</span></th></tr></thead>
<tbody>
{rows}</tbody></table></div>
{left_out}</section>
)",
                     arg("left_out", left_out(coverage)), arg("practical", escaped(practical_rule(coverage))),
                     arg("total", number(coverage.total.mean)), arg("level", level(coverage.confidence)),
                     arg("rows", rows));
}

std::string word_rows(const std::vector<WordEnergy>& words, std::size_t most) {
  std::string rows;
  for (std::size_t i = 0; i < std::min(most, words.size()); ++i)
    rows += fmt::format(R"(<tr><th scope="row"><code>{word}</code></th><td class="number">{share}</td>
<td class="number">{interval}</td><td class="number">{samples}</td><td class="wide">{bar}</td></tr>
)",
                        arg("samples", samples_text(words[i].samples_needed)), arg("word", escaped(words[i].word)),
                        arg("share", escaped_percent(words[i].share.mean)),
                        arg("interval", percent_interval(words[i].share)), arg("bar", bar(words[i].share)));
  return rows;
}

std::string word_table(std::string_view caption, const std::vector<WordEnergy>& words, double confidence) {
  if (words.empty()) return fmt::format("<p class=\"none\">{}: none.</p>\n", escaped(caption));
  return fmt::format(R"(<table class="words"><caption>{caption}</caption>
<thead><tr><th scope="col">Word</th><th scope="col" class="number">Share</th>
<th scope="col" class="number">{level} interval</th><th scope="col" class="number">Samples</th>
<th scope="col" class="wide"><span class="unseen">Bar</span></th></tr></thead>
<tbody>
{rows}</tbody></table>
)",
                     arg("caption", escaped(caption)), arg("level", level(confidence)),
                     arg("rows", word_rows(words, words.size())));
}

std::string expressions(const GrammarCoverage& grammar) {
  if (!has_two_expressions(grammar))
    return fmt::format("<p><code class=\"expression\">{}</code></p>\n", escaped(grammar.expression));
  return fmt::format(
      R"(<dl class="expressions"><div><dt>Lights that a ray can hit</dt><dd><code class="expression">{}</code></dd></div>
<div><dt>Lights that it cannot: point, spot, distant</dt><dd><code class="expression">{}</code></dd></div></dl>
)",
      escaped(grammar.expression), escaped(grammar.expression_delta));
}

/// What the share of an algorithm does not tell.
std::string cautions(const GrammarCoverage& grammar) {
  return list_of("Known biases", grammar.biases) + list_of("Captured, but noisy", grammar.variances) +
         list_of("Needs", grammar.preconditions);
}

std::string part_figure(const record::Record& record, const std::vector<bool>& words, float exposure, int width,
                        const std::string& caption, const std::string& alternative) {
  return fmt::format("<figure>{}\n<figcaption>{}</figcaption></figure>\n",
                     picture_element(image_of(record, words), exposure, width, alternative), escaped(caption));
}

std::string algorithm_article(const record::Record& record, const Coverage& coverage, const GrammarCoverage& grammar,
                              float exposure, int width) {
  std::vector<bool> missed = grammar.captured;
  missed.flip();
  const std::string missed_percent = percent(missed_share(coverage, grammar));
  const std::string source =
      grammar.source.empty() ? "" : fmt::format("<p class=\"source\">Source: {}</p>\n", escaped(grammar.source));
  return fmt::format(
      R"(<article id="{anchor}">
<h3>{title}</h3>
{expressions}<p class="share"><strong>{share}</strong> of the light captured{bound}; {level} interval {interval}</p>
<div class="pair">
{captured_figure}{missed_figure}</div>
<div class="pair">
<div>{captured_words}</div>
<div>{missed_words}</div>
</div>
{cautions}{source}</article>
)",
      arg("anchor", anchor(grammar)), arg("title", escaped(grammar.title)), arg("expressions", expressions(grammar)),
      arg("share", escaped_percent(grammar.share.mean)), arg("level", level(coverage.confidence)),
      arg("interval", percent_interval(grammar.share)),
      arg("bound", grammar.is_exact ? "" : fmt::format(", {}", kAtLeast)),
      arg("captured_figure",
          part_figure(record, grammar.captured, exposure, width, "Captured: " + percent(grammar.share.mean),
                      fmt::format("{} captures {} of the light, mostly {}", grammar.title, percent(grammar.share.mean),
                                  word_list(grammar.top_captured)))),
      arg("missed_figure", part_figure(record, missed, exposure, width, "Missed: " + missed_percent,
                                       fmt::format("{} misses {} of the light, mostly {}", grammar.title,
                                                   missed_percent, word_list(grammar.top_missed)))),
      arg("captured_words", word_table("Words captured", grammar.top_captured, coverage.confidence)),
      arg("missed_words", word_table("Words missed", grammar.top_missed, coverage.confidence)),
      arg("cautions", cautions(grammar)), arg("source", source));
}

std::string algorithms_section(const record::Record& record, const Coverage& coverage, float exposure, int width) {
  std::string articles;
  for (const GrammarCoverage& grammar : coverage.grammars)
    articles += algorithm_article(record, coverage, grammar, exposure, width);
  return fmt::format("<section id=\"algorithms\">\n<h2>Algorithm by algorithm</h2>\n{}</section>\n", articles);
}

/// One table of shares by number, with bars; numbers beyond the last that shows are left out.
std::string spectrum_table(const Spectrum& spectrum, std::string_view caption) {
  constexpr double kShows = 0.00005;  // in per cent with two decimals
  std::size_t end = spectrum.shares.size();
  while (end > 0 && spectrum.shares[end - 1].mean < kShows) --end;
  std::string rows;
  for (std::size_t n = 0; n < end; ++n)
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"wide\">{}</td></tr>\n", n,
                        escaped_percent(spectrum.shares[n].mean), bar(spectrum.shares[n]));
  return fmt::format(R"(<div><table><caption>{}</caption>
<thead><tr><th scope="col">Number</th><th scope="col" class="number">Share</th>
<th scope="col" class="wide"><span class="unseen">Bar</span></th></tr></thead>
<tbody>
{}</tbody></table></div>
)",
                     escaped(caption), rows);
}

/// How the light is spread over words and their letters; nothing when all is dark.
std::string spread(const Classification& words) {
  if (!words.spread) return {};
  std::string tables;
  for (const Spectrum& spectrum : words.spectra)
    for (const GroupByFacts& grouping : kGroupings)
      if (grouping.name == spectrum.name) tables += spectrum_table(spectrum, "By " + std::string(grouping.meaning));
  return fmt::format("<h3>How the light is spread over them</h3>\n<p>{}</p>\n<div class=\"pair\">\n{}</div>\n",
                     escaped(spread_text(words)), tables);
}

std::string words_section(const Coverage& coverage, const Classification& words, std::size_t most) {
  const std::size_t shown = std::min(most, coverage.words.size());
  double rest = 0;
  for (std::size_t i = shown; i < coverage.words.size(); ++i) rest += coverage.words[i].share.mean;
  const std::string rest_line =
      shown == coverage.words.size()
          ? ""
          : fmt::format("<p>And {} with {} of the light together.</p>\n",
                        counted(coverage.words.size() - shown, "more word"), escaped_percent(rest));
  const std::vector<WordEnergy> first(coverage.words.begin(),
                                      coverage.words.begin() + static_cast<std::ptrdiff_t>(shown));
  return fmt::format("<section id=\"words\">\n<h2>The words of this scene</h2>\n{}{}{}</section>\n",
                     word_table("Words by energy, most first", first, coverage.confidence), rest_line, spread(words));
}

/// A table for each thing that letters are labelled with; nothing where there are no labels.
std::string labels_section(std::span<const Classification> labels, std::size_t most) {
  std::string tables;
  for (const Classification& by : labels) {
    std::string rows;
    for (const WordGroup& group : std::span(by.groups).first(std::min(most, by.groups.size())))
      rows += fmt::format(R"(<tr><th scope="row">{}</th><td class="number">{}</td><td class="number">{}</td>
<td class="wide">{}</td></tr>
)",
                          escaped(group.name), escaped_percent(group.share.mean), percent_interval(group.share),
                          bar(group.share));
    tables += fmt::format(R"(<div><table><caption>By {}</caption>
<thead><tr><th scope="col">Label</th><th scope="col" class="number">Share</th>
<th scope="col" class="number">{} interval</th><th scope="col" class="wide"><span class="unseen">Bar</span></th></tr></thead>
<tbody>
{}</tbody></table></div>
)",
                          escaped(facts(by.by).meaning), level(by.confidence), rows);
  }
  if (tables.empty()) return {};
  return fmt::format(
      "<section id=\"labels\">\n<h2>What the light met</h2>\n<div class=\"pair\">\n{}</div>\n</section>\n", tables);
}

/// The buffers of light that no path carries; nothing when the render had none.
std::string non_path_section(const record::Record& record, float exposure, int width) {
  struct Buffer {
    const std::vector<Rgb>& pixels;
    std::string_view title, meaning;
  };
  const std::array<Buffer, 2> buffers{{
      {record.ambient, "Ambient term", "A constant added to every surface. It has no path and no visibility."},
      {record.phantom, "Phantom mirror",
       "The mirror ray that the lecture's tracer continues at a diffuse surface, whose material does not reflect so."},
  }};
  std::string figures;
  for (const Buffer& buffer : buffers) {
    if (buffer.pixels.empty()) continue;
    const record::Image image{record.info.window, buffer.pixels};
    figures += fmt::format("<figure>{}\n<figcaption><strong>{}.</strong> {}</figcaption></figure>\n",
                           picture_element(image, exposure, width, fmt::format("{} alone", buffer.title)), buffer.title,
                           buffer.meaning);
  }
  if (figures.empty()) return {};
  return fmt::format(R"(<section id="non-path">
<h2>Light that no path carries</h2>
<p>This light is in no picture above and in no share: it is outside of coverage.</p>
<div class="pair">
{}</div>
</section>
)",
                     figures);
}

/// What the importer left out of the scene; nothing when that is nothing.
std::string ignored_list(const record::RenderInfo& info) {
  if (info.ignored.empty()) return "";
  std::string items;
  for (const std::string& sentence : info.ignored) items += fmt::format("<li>{}</li>\n", escaped(sentence));
  return fmt::format("<h3>What the scene file says and was not used</h3>\n<ul class=\"ignored\">\n{}</ul>\n", items);
}

std::string facts_section(const Coverage& coverage) {
  std::string items;
  for (const Fact& fact : facts(coverage.info, coverage.tally))
    items += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(fact.label), escaped(fact.value));
  return fmt::format(R"(<section id="facts">
<h2>Facts</h2>
<dl class="facts">
{}<div><dt>Glossy rule</dt><dd>{}</dd></div>
<div><dt>Intervals</dt><dd>{} confidence, from the spread of up to {} batches of samples</dd></div>
</dl>
{}</section>
)",
                     items, escaped(describe(coverage.glossy_rule)), level(coverage.confidence), record::kBatches,
                     ignored_list(coverage.info));
}

}  // namespace

std::string html(const record::Record& record, const Coverage& coverage, const Classification& words,
                 const HtmlOptions& options, std::span<const Classification> labels) {
  const record::Image beauty = record::beauty(record);
  const float exposure = options.exposure.value_or(auto_exposure(beauty));
  std::string page = fmt::format(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="heckbert {version}">
<title>{scene} - light-path coverage</title>
<style>
{css}</style>
</head>
<body>
)",
                                 arg("version", escaped(coverage.info.version)),
                                 arg("scene", escaped(coverage.info.scene)), arg("css", page_css));
  page += introduction(record, coverage);
  page += "<main>\n";
  page += picture_section(beauty, coverage, exposure, options.picture_width);
  page += reading_section(coverage);
  page += shares_section(coverage);
  page += algorithms_section(record, coverage, exposure, options.part_width);
  page += words_section(coverage, words, options.words);
  page += labels_section(labels, options.words);
  page += non_path_section(record, exposure, options.part_width);
  page += facts_section(coverage);
  page += "</main>\n</body>\n</html>\n";
  return page;
}

}  // namespace heckbert::report
