#pragma once
// What a render has found so far, on top of what was there before it. Tiles go into the pictures and into temporary
// files as they are finished, so that memory does not grow with the record.

#include <optional>
#include <string>
#include <vector>

#include <heckbert/record/record_spool.h>
#include <heckbert/record/sums_stream.h>
#include <heckbert/record/tile_pictures.h>

namespace heckbert::cli {

/// What is wanted of them.
struct Wanted {
  std::string file{};  ///< beside which entries are kept; empty: none are
  std::optional<record::FoldRule> folding{};
  bool pictures = false;  ///< to be made as tiles come. Takes: tiles that do not overlap, and nothing begun
  std::vector<taxonomy::Language> classes{};
  taxonomy::GlossyRule rule = taxonomy::GlossyRule::Keep;
};

class Findings {
 public:
  /// `begun` is what was there before. Errors: WriteError; LimitError, see TilePictures.
  Findings(const record::RenderInfo& info, std::optional<record::SumsStream> begun, const Wanted& wanted);

  /// One at a time. Errors: WriteError.
  void take(record::Tile tile);
  /// All of it, as long as no more is taken. The findings must outlive it.
  record::SumsStream sums() const;
  const std::optional<record::SumsStream>& begun() const { return begun_; }
  bool is_folded() const { return spool_.is_folded(); }
  /// Null: they were not wanted as tiles come.
  const record::TilePictures* pictures() const { return pictures_ ? &*pictures_ : nullptr; }

 private:
  std::optional<record::SumsStream> begun_;
  record::RecordSpool spool_;
  std::optional<record::TilePictures> pictures_;
};

}  // namespace heckbert::cli
