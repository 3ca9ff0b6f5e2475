#pragma once
// Records made by hand, for tests that know every number in them.

#include <functional>
#include <string>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::report::test {

/// One word, what each batch says of its picture mean (grey), and where in the picture it is.
struct SampleWord {
  std::string word;            ///< as parse_word() reads it
  std::vector<float> batches;  ///< one per sample of a pixel, at most kBatches
  std::uint32_t count = 1;     ///< contributions per pixel
  std::function<Rgb(int x, int y)> light = [](int, int) { return Rgb(1); };
};

/// The words need not be sorted. The number of samples per pixel is the number of batches of the first word.
record::Record sample_record(int width, int height, const std::vector<SampleWord>& words);

/// A picture as the lecture's scene might give it: soft blobs for LE, LDE, LDDE, LSE, LSSE, LDSE, LSDE, LGE.
record::Record lecture_like_record(int width, int height);

taxonomy::Grammar grammar_of(const std::string& name, const std::string& title, const std::string& expression);

/// Ray casting, radiosity, recursive ray tracing, global illumination.
std::vector<taxonomy::Grammar> four_grammars();

/// What has no language.
taxonomy::Grammar proxy();

}  // namespace heckbert::report::test
