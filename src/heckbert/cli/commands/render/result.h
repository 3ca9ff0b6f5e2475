#pragma once
// What `heckbert render` came to: pictures, files, and what is said of them.

#include <vector>

#include <heckbert/cli/commands/render/job.h>
#include <heckbert/cli/layers.h>
#include <heckbert/record/tile_pictures.h>
#include <heckbert/report/json_parts.h>

namespace heckbert::cli {

struct Result {
  record::SumsStream sums;
  bool keeps_sums = false;               ///< in the record
  record::Record record{};               ///< without pixels
  std::vector<ClassOfRecord> classes{};  ///< that were asked for
  record::Image beauty{};
  std::vector<record::Image> images{};  ///< by class
};

/// `pictures` are those of the sums, if they have been made. Without the file of a record the sums may have no entries,
/// if there are pictures.
Result result_of(record::SumsStream sums, const record::TilePictures* pictures, const RenderOptions& options,
                 const std::vector<taxonomy::Grammar>& grammars, const Settings& settings);

/// Errors: WriteError.
void write_outputs(const Outputs& outputs, const Result& result, bool with_cryptomatte, const Settings& settings,
                   const Console& console);

void tell_result(const Console& console, const Result& result, const Work& work);

report::Json to_json(const Outputs& outputs, const Result& result, const Work& work, const Settings& settings,
                     const import::Account& account);

}  // namespace heckbert::cli
