#pragma once
// The picture and the pictures of classes, made while tiles are finished: for a render that keeps no record in memory.
// Each is bit for bit that of the whole record.

#include <mutex>
#include <span>
#include <vector>

#include <heckbert/record/recorder.h>
#include <heckbert/taxonomy/classifier.h>

namespace heckbert::record {

class TilePictures {
 public:
  /// `rule` says what the languages' letters mean for glossy events. Errors: LimitError, see Classifier.
  TilePictures(RenderInfo info, std::span<const taxonomy::Language> classes, taxonomy::GlossyRule rule);
  /// Thread-safe; tiles come in any order. Cost: O(entries x classes that have them).
  void add(const Tile& tile);

  const Image& beauty() const { return images_.front(); }
  /// By class.
  std::span<const Image> classes() const { return std::span(images_).subspan(1); }

 private:
  RenderInfo info_;
  taxonomy::Classifier classifier_;
  std::mutex mutex_;
  std::vector<Image> images_;  ///< the beauty, then the classes
};

}  // namespace heckbert::record
