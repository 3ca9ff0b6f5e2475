#include <heckbert/record/record_header.h>

#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/ranges.h>

#include <heckbert/record/exr.h>
#include <heckbert/record/parallel.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/letter.h>
#include <heckbert/taxonomy/simplest.h>

namespace heckbert::record::exr {

namespace {

constexpr int kLayoutVersion = 3;
constexpr const char* kLayout = "heckbert.record";
constexpr const char* kWords = "heckbert.words";
constexpr const char* kIdChannel = "id";
// For people and other tools: the kinds of ends that paths were found from and to, "La Le".
constexpr const char* kLights = "heckbert.lights";
constexpr const char* kEyes = "heckbert.eyes";
// Absent unless the record is folded (folding.h).
constexpr const char* kLongest = "heckbert.folding.longest";
constexpr const char* kClasses = "heckbert.folding.classes";
constexpr const char* kExact = "heckbert.folding.exact";

std::string tally_name(std::string_view name) {
  return fmt::format("heckbert.tally.{}", name);
}

Imf::IDManifest manifest_of(const Imf::StringVector& words) {
  Imf::IDManifest manifest;
  Imf::IDManifest::ChannelGroupManifest& group = manifest.add(kIdChannel);
  group.setComponent("word");
  group.setLifetime(Imf::IDManifest::LIFETIME_FRAME);
  group.setHashScheme(Imf::IDManifest::NOTHASHED);
  group.setEncodingScheme(Imf::IDManifest::ID_SCHEME);
  for (std::size_t w = 0; w < words.size(); ++w) group.insert(w, words[w]);
  return manifest;
}

void check_info(const RenderInfo& info) {
  const Window& window = info.window;
  require(window.x0 >= 0 && window.y0 >= 0 && window.x1 <= info.width && window.y1 <= info.height,
          "the data window reaches beyond the picture");
  require(info.samples_per_pixel >= 1, "the number of samples per pixel is not positive");
}

/// The symbols of a word without labels that is spelled in full; nothing of any other text.
std::optional<std::vector<taxonomy::Symbol>> symbols_of(std::string_view text) {
  std::vector<taxonomy::Symbol> symbols;
  while (!text.empty()) {
    const char subscript = text.size() > 1 ? text[1] : '\0';
    const auto found = std::ranges::find_if(taxonomy::kSymbols, [&](const taxonomy::SymbolFacts& facts) {
      return facts.letter == text[0] && (facts.subscript == 0 || facts.subscript == subscript);
    });
    if (found == taxonomy::kSymbols.end()) return {};
    symbols.push_back(found->symbol);
    text.remove_prefix(found->subscript == 0 ? 1 : 2);
  }
  return symbols;
}

/// The word that `text` spells in full. Errors: std::runtime_error.
taxonomy::Word word_from(const std::string& text) {
  // Nearly all words of nearly all records, in a third of the time that it takes to read what people write.
  if (const auto symbols = symbols_of(text); symbols && symbols->size() >= 2) {
    const bool has_events = std::all_of(symbols->begin() + 1, symbols->end() - 1, taxonomy::is_event);
    if (has_events && taxonomy::is_light(symbols->front()) && taxonomy::is_eye(symbols->back()))
      return {symbols->front(), {symbols->begin() + 1, symbols->end() - 1}, symbols->back()};
  }
  taxonomy::Word word;
  try {
    word = taxonomy::parse_word(text);
  } catch (const InputError&) {
    throw std::runtime_error(fmt::format("the id manifest has '{}', which is not a word", text));
  }
  require(taxonomy::fine(word) == text, fmt::format("the id manifest has '{}' without subscripts", text));
  return word;
}

std::vector<taxonomy::Word> read_words(const Imf::Header& header, std::uint64_t file_bytes) {
  require(Imf::hasIDManifest(header), "the id manifest is missing");
  const Imf::CompressedIDManifest& packed = Imf::idManifest(header);
  require(can_unpack_to(packed._uncompressedDataSize, file_bytes),
          "the file is damaged: its id manifest promises more words than it can hold");
  const Imf::IDManifest manifest(packed);
  const std::size_t group = manifest.find(kIdChannel);
  require(group < manifest.size(), "the id manifest does not tell about the channel 'id'");
  std::vector<const std::string*> texts;
  texts.reserve(manifest[group].size());
  for (auto i = manifest[group].begin(); !(i == manifest[group].end()); ++i) {
    require(i.id() == texts.size() && i.text().size() == 1, "the id manifest does not number the words 0, 1, 2 ...");
    texts.push_back(&i.text().front());
  }
  constexpr std::size_t kWordsPerPiece = 1024;
  std::vector<taxonomy::Word> words(texts.size());
  in_parallel((words.size() + kWordsPerPiece - 1) / kWordsPerPiece, [&] {
    return [&](std::size_t piece) {
      const std::size_t first = piece * kWordsPerPiece, last = std::min(first + kWordsPerPiece, words.size());
      for (std::size_t w = first; w < last; ++w) words[w] = word_from(*texts[w]);
    };
  });
  const auto unsorted = std::adjacent_find(words.begin(), words.end(), std::not_fn(std::less<>()));
  require(unsorted == words.end(), "the words of the id manifest are not sorted");
  return words;
}

/// The kinds that one end of the words has, each once, in the order of the alphabet.
std::string kinds_of(const std::vector<taxonomy::Word>& words, taxonomy::Symbol taxonomy::Word::*end) {
  std::set<taxonomy::Symbol> kinds;
  for (const taxonomy::Word& word : words) kinds.insert(word.*end);
  std::vector<std::string> names;
  for (const taxonomy::Symbol kind : kinds) names.push_back(taxonomy::name(taxonomy::Letter{kind, ""}));
  return fmt::format("{}", fmt::join(names, " "));
}

void insert_folding(Imf::Header& header, const Record& record) {
  if (!record.folding) return;
  Imf::StringVector exact;
  for (const taxonomy::Language& language : record.folding->exact) {
    const std::optional<std::string> expression = taxonomy::simplest_expression(language);
    if (!expression) throw std::logic_error("what stays exact can be written as an expression");
    exact.push_back(*expression);
  }
  header.insert(kLongest, Imf::IntAttribute(record.folding->longest));
  header.insert(kClasses, Imf::IntAttribute(static_cast<int>(record.words.size() - record.folding->first)));
  header.insert(kExact, Imf::StringVectorAttribute(exact));
}

void read_folding(const Imf::Header& header, Record& record) {
  if (header.find(kLongest) == header.end()) return;
  Folding folding{.longest = attribute<Imf::IntAttribute>(header, kLongest)};
  const int classes = attribute<Imf::IntAttribute>(header, kClasses);
  const bool can_be = folding.longest >= 0 && classes > 0 && static_cast<std::size_t>(classes) <= record.words.size();
  if (can_be) folding.first = record.words.size() - static_cast<std::size_t>(classes);
  // Words are sorted, short ones first.
  const auto has_length = [&](std::size_t word) { return record.words[word].length(); };
  const auto longest = static_cast<std::size_t>(folding.longest);
  require(
      can_be && (folding.first == 0 || has_length(folding.first - 1) <= longest) && has_length(folding.first) > longest,
      "what the header says of folded words does not fit the words");
  for (const std::string& expression : attribute<Imf::StringVectorAttribute>(header, kExact)) try {
      folding.exact.push_back(taxonomy::compile(expression));
    } catch (const std::exception&) {
      throw std::runtime_error(fmt::format("the header attribute '{}' has '{}', no expression", kExact, expression));
    }
  record.folding = std::move(folding);
}

}  // namespace

Imf::Header part_header(const RenderInfo& info, const char* name, const std::string& type, const Window& window) {
  Imf::Header header(box_of({0, 0, info.width, info.height}), box_of(window));
  header.setName(name);
  header.setType(type);
  header.compression() = type == Imf::DEEPSCANLINE ? Imf::ZIPS_COMPRESSION : Imf::ZIP_COMPRESSION;
  return header;
}

void insert_totals(Imf::Header& header, const Record& record) {
  Imf::addComments(
      header,
      "A record of light paths, made by heckbert. Each deep sample is the light that one word, a kind of path "
      "from the light L to the eye E, brings to one pixel: id is the number of the word in heckbert.words, "
      "from 0; R, G and B are the mean over the pixel's samples; count is the number of paths. Flattened, it "
      "is the picture. To ask it: heckbert query, coverage, classify.");
  header.insert(kLayout, Imf::IntAttribute(kLayoutVersion));
  Imf::StringVector words;
  words.reserve(record.words.size());
  for (const taxonomy::Word& word : record.words) words.push_back(taxonomy::fine(word));
  header.insert(kWords, Imf::StringVectorAttribute(words));
  Imf::addIDManifest(header, manifest_of(words));
  header.insert(kLights, Imf::StringAttribute(kinds_of(record.words, &taxonomy::Word::light)));
  header.insert(kEyes, Imf::StringAttribute(kinds_of(record.words, &taxonomy::Word::eye)));
  insert_folding(header, record);
  for (const TallyFacts& facts : kTallyFields)
    header.insert(tally_name(facts.name), Imf::StringAttribute(std::to_string(record.tally.*facts.field)));
  for (const TallySumFacts& facts : kTallySums)
    header.insert(tally_name(facts.name), Imf::StringAttribute(fmt::to_string(record.tally.*facts.field)));
}

void check_layout(const Imf::Header& header) {
  const std::string wanted =
      fmt::format("expected a record, that is a deep EXR with the attribute '{}' = {}", kLayout, kLayoutVersion);
  require(header.hasType() && header.type() == Imf::DEEPSCANLINE, fmt::format("this is a flat EXR; {}", wanted));
  const auto* layout = header.findTypedAttribute<Imf::IntAttribute>(kLayout);
  require(layout != nullptr, fmt::format("this is a deep EXR of another kind; {}", wanted));
  require(layout->value() == kLayoutVersion,
          fmt::format("this is a record of layout version {}; {}", layout->value(), wanted));
}

Record read_totals(const Imf::Header& header, std::uint64_t file_bytes) {
  Record record;
  record.info = info_of(header);
  check_info(record.info);
  require(can_unpack_to(record.info.window.pixel_count() * sizeof(unsigned), file_bytes),
          "the file is damaged: it promises more pixels than it can hold");
  for (const TallyFacts& facts : kTallyFields) {
    const std::string name = tally_name(facts.name);
    record.tally.*facts.field = parse_number(attribute<Imf::StringAttribute>(header, name), name);
  }
  for (const TallySumFacts& facts : kTallySums) {
    const std::string name = tally_name(facts.name);
    record.tally.*facts.field = parse_quanta(attribute<Imf::StringAttribute>(header, name), name);
  }
  record.words = read_words(header, file_bytes);
  read_folding(header, record);
  return record;
}

}  // namespace heckbert::record::exr
