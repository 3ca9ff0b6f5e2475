#pragma once
// A render that nothing will be added to: its tiles go into the pictures and to the record's file as they are finished,
// so that memory does not grow with the record.

#include <atomic>
#include <optional>
#include <span>
#include <string>

#include <heckbert/cli/console.h>
#include <heckbert/cli/tracing.h>
#include <heckbert/record/record_spool.h>
#include <heckbert/record/tile_pictures.h>

namespace heckbert::cli {

struct Streamed {
  record::RecordSpool spool;
  record::TilePictures pictures;

  /// `record` is the name of the record's file, beside which the tiles are kept; empty: none is wanted. Errors:
  /// WriteError.
  Streamed(const record::RenderInfo& info, const std::string& record, std::span<const taxonomy::Language> classes,
           taxonomy::GlossyRule rule, const std::optional<record::FoldRule>& folding);
};

/// Traces until it is done or stopped; gives back whether it is done. Errors: WriteError.
bool trace(const transport::Scene& scene, const TracingJob& job, const Console& console, const std::atomic<bool>& stop,
           Work& work, Streamed& streamed);

}  // namespace heckbert::cli
