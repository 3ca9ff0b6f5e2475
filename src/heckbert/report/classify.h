#pragma once
// The energy of a record sorted into groups of words: by spelling, by how many bounces of a kind they have, by named
// class or algorithm, by the labels of their letters. Some groupings are partitions; classes, algorithms and labels may
// overlap, so their shares need not add up to one.
//
// Of a partition it is also said how spread out the energy is: its entropy in bits, the number of equal groups that
// would have the same entropy, and how few groups reach a given share.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/part.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::report {

enum class GroupBy : std::uint8_t {
  Word,
  FineWord,
  Length,
  Diffuse,
  Glossy,
  Specular,
  Class,
  Algorithm,
  Light,
  Seen,
  Label
};

struct GroupByFacts {
  GroupBy by;
  std::string_view name;     ///< as on the command line
  std::string_view title;    ///< heading of the column of groups
  bool is_partition = true;  ///< every word is in exactly one group
  std::string_view meaning;
};

inline constexpr std::array<GroupByFacts, 11> kGroupings{{
    {GroupBy::Word, "word", "Word", true, "the word in plain letters"},
    {GroupBy::FineWord, "fine-word", "Word", true, "the word with subscripts"},
    {GroupBy::Length, "length", "Scatterings", true, "number of scatterings"},
    {GroupBy::Diffuse, "diffuse", "Diffuse", true, "number of letters D"},
    {GroupBy::Glossy, "glossy", "Glossy", true, "number of letters G"},
    {GroupBy::Specular, "specular", "Specular", true, "number of letters S"},
    {GroupBy::Class, "class", "Class", false, "named classes"},
    {GroupBy::Algorithm, "algorithm", "Algorithm", false, "algorithms of the teaching set"},
    {GroupBy::Light, "light", "Light", true, "kind of light, and its label where lights are labelled"},
    {GroupBy::Seen, "seen", "Seen on", true, "label of the event nearest the eye"},
    {GroupBy::Label, "label", "Touched", false, "labels of all events"},
}};

constexpr const GroupByFacts& facts(GroupBy by) {
  return kGroupings[static_cast<std::size_t>(by)];
}

struct WordGroup {
  std::string name;        ///< spelling, number, label, or name of the grammar
  std::string expression;  ///< of a class or algorithm; else empty
  record::Estimate energy;
  record::Estimate share;
  std::uint64_t count = 0;  ///< contributions
  std::size_t words = 0;    ///< distinct words of the record in the group
};

/// How the energy is spread over the groups of a partition.
struct Spread {
  record::Estimate entropy;         ///< bits
  double effective_groups = 0;      ///< 2 to the entropy
  double reach = 0;                 ///< the share asked for
  std::size_t groups_to_reach = 0;  ///< the fewest groups that have this share together
};

/// Energy by a number: scatterings, or letters of a kind.
struct Spectrum {
  std::string_view name;                 ///< of the grouping
  std::vector<record::Estimate> shares;  ///< by number, from 0
};

struct Classification {
  record::RenderInfo info;
  record::Tally tally;
  GroupBy by = GroupBy::Word;
  taxonomy::GlossyRule glossy_rule = taxonomy::GlossyRule::Keep;
  double confidence = 0.95;
  Part part;
  std::vector<WordGroup> groups;
  std::optional<Spread> spread;   ///< of a partition that has any energy
  std::vector<Spectrum> spectra;  ///< scatterings, diffuse, glossy and specular letters
};

struct ClassifyOptions {
  taxonomy::GlossyRule glossy_rule = taxonomy::GlossyRule::Keep;
  double confidence = 0.95;
  double reach = 0.99;
  Part part{};
};

/// Groups of the record's words. Numbers ascending; classes and algorithms in the order of the library, those without
/// energy too; all others by energy, most first.
Classification classify(const record::Record& record, GroupBy by, const taxonomy::GrammarLibrary& library,
                        const ClassifyOptions& options = {});

/// The groups that Spread::groups_to_reach counts, by energy; none for groups that overlap.
std::vector<WordGroup> fewest_to_reach(const Classification& classification);

}  // namespace heckbert::report
