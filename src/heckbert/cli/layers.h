#pragma once
// The picture and its classes as layers of one EXR, made in one way for `render --lpe` and for `query`, so that asking
// afterwards gives the same bits as declaring before.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <heckbert/record/file.h>
#include <heckbert/record/record.h>
#include <heckbert/record/rows.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::cli {

/// What a record holds of one language.
struct ClassOfRecord {
  taxonomy::Grammar grammar;
  std::string never;              ///< "'LVE' matches nothing in this record, because ...", or empty
  std::vector<bool> members;      ///< by word of the record
  std::vector<bool> undecided{};  ///< by word, where the record is folded and does not know; else empty
  record::Estimate energy, share;
  std::size_t words = 0;    ///< distinct words of the record in the language
  std::uint64_t count = 0;  ///< contributions
};

/// All classes in one pass: membership is asked once per distinct word, and words that are in the same classes are
/// added up once.
std::vector<ClassOfRecord> classes_of(const record::Record& record, const std::vector<taxonomy::Grammar>& grammars,
                                      taxonomy::GlossyRule rule, double confidence);

/// The picture of each class, and behind them that of all words. Here and below `rows` shows the pixels of a record
/// that need not have any.
std::vector<record::Image> images_of(const record::Record& record, const record::Rows& rows,
                                     const std::vector<ClassOfRecord>& classes);

/// One layer per class, of its picture; names are made legal and distinct, attributes say the expression as it was
/// typed, its dialect, its canonical form and the rule for G. With `first_unnamed` the first class becomes the
/// unprefixed R, G, B.
std::vector<record::Layer> layers_of(std::span<const record::Image> images, const std::vector<ClassOfRecord>& classes,
                                     taxonomy::GlossyRule rule, bool first_unnamed = false);

/// For each class that a folded record cannot decide, a layer "NAME_undecided": what may be in it besides.
void add_undecided_layers(const record::Record& record, const record::Rows& rows,
                          const std::vector<ClassOfRecord>& classes, std::vector<record::Layer>& layers);

/// What happened to names that had to be changed, in sentences: "the layer of 'LS+DE' is called LS_DE".
std::vector<std::string> renamed(const std::vector<record::Layer>& layers);

/// The classes as a Cryptomatte, the first that has a word owning it; without classes every word is one.
record::Attachment cryptomatte_of(const record::Record& record, const record::Rows& rows,
                                  const std::vector<ClassOfRecord>& classes);

/// Light that no path carries, as far as the record has it: layers "ambient" and "phantom". It is not in the picture.
void add_non_path_layers(const record::Record& record, std::vector<record::Layer>& layers);

/// "caustic = LS+DE: 3.12 % of the energy, 3.01 to 3.23 %"
std::string describe(const ClassOfRecord& item);

/// The classes as a table for people.
std::string classes_text(const std::vector<ClassOfRecord>& classes, const report::TextStyle& style);

/// Keys "name", "expression", "dialect", "canonical", "never", "exact", "energy", "share", "words", "count".
report::Json to_json(const std::vector<ClassOfRecord>& classes);

}  // namespace heckbert::cli
