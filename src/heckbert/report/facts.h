#pragma once
// What has to be known about a record to judge any number taken from it, said once for the terminal and the page.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/glossy_rule.h>

namespace heckbert::report {

struct Fact {
  std::string label, value;
};

/// Scene, algorithm, picture, samples, seed, depth, labels, how walks ended, what was rejected, version.
std::vector<Fact> facts(const record::RenderInfo& info, const record::Tally& tally);

/// What a picture of this mean luminance lacks for its depth limit, in a sentence; empty when no walk reached it.
/// Roulette loses nothing on average: what it ends, others carry.
std::string termination(const record::RenderInfo& info, const record::Tally& tally, double luminance);

/// What a reader must not overlook: an interrupted render, rejected contributions, too few samples for intervals.
/// Each one or two sentences; usually none.
std::vector<std::string> warnings(const record::RenderInfo& info, const record::Tally& tally);

/// What became of words that found no room, in a sentence; empty when all did.
std::string folding(const record::Record& record);
/// What is said beside an answer that folded words leave open.
inline constexpr std::string_view kAtLeast = "at least; the rest of the interval is folded words";

/// "seed 1"; of a part or of several renders, which samples: "samples 8 to 15 of 32, seed 1".
std::string samples_text(const record::RenderInfo& info);

/// "scene, path, 512 x 512 pixels, 64 samples per pixel, seed 1, heckbert 0.1.0"
std::string summary(const record::RenderInfo& info);

/// "keep: G is a letter of its own: ..."
std::string describe(taxonomy::GlossyRule rule);

/// The lecture's four lines, in its own two letters: what each family of algorithms captures of light's paths.
struct TaxonomyLine {
  std::string_view algorithm, expression, meaning;
};
inline constexpr std::array<TaxonomyLine, 4> kTaxonomyLines{{
    {"ray casting", "LD?E", "at most one diffuse bounce"},
    {"radiosity", "LD*E", "diffuse bounces only, any number"},
    {"recursive ray tracing", "LD?S*E", "at most one diffuse bounce, then any number of specular ones"},
    {"global illumination", "L(D|S)*E", "every bounce, any number, in any order"},
}};
inline constexpr std::string_view kTaxonomySource = "TU Wien Rendering #11, K. Zsolnai, 2015; after P. Heckbert, 1990";

/// How a word is to be read, in one sentence.
inline constexpr std::string_view kReadingDirection =
    "Words run from the light to the eye: LSDE is light that left a lamp (L), met a mirror or glass (S), then a matt "
    "surface (D), and reached the eye (E).";

}  // namespace heckbert::report
