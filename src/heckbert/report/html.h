#pragma once
// The report: one self-contained page that needs nothing but a browser. Style sheet and pictures are inside it; it runs
// no script and fetches nothing.

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <heckbert/record/record.h>
#include <heckbert/report/classify.h>
#include <heckbert/report/coverage.h>

namespace heckbert::report {

struct HtmlOptions {
  std::optional<float> exposure{};  ///< one for all pictures; else auto_exposure() of the beauty
  std::size_t words = 24;           ///< rows of the table of the scene's words
  int picture_width = 1280;         ///< of the picture, at most
  int part_width = 640;             ///< of captured and missed, at most
};

/// `coverage`, `words`, the classification by word, and `labels`, those by what the record is labelled with, must come
/// from the same part of `record`. The page grows by some two pictures per grammar; pictures are of all pixels.
std::string html(const record::Record& record, const Coverage& coverage, const Classification& words,
                 const HtmlOptions& options = {}, std::span<const Classification> labels = {});

}  // namespace heckbert::report
