#pragma once
// What `heckbert render` is to do, and everything that can be wrong with it, looked at before any ray is traced.

#include <string>
#include <vector>

#include <heckbert/cli/ranks.h>
#include <heckbert/cli/settings.h>
#include <heckbert/cli/tracing.h>
#include <heckbert/import/import.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {

struct RenderOptions {
  std::string scene;
  std::string algorithm{transport::kAlgorithms.front().name};
  std::string output, record, preview;  ///< empty: not wanted
  std::string resume;                   ///< empty: from the start
  std::string precision;                ///< of the record
  bool no_preview = false, exact = false;
  std::vector<std::string> classes;  ///< "name=EXPR" or "EXPR"
  bool cryptomatte = false;
  bool adaptive = false;
  bool json = false;
  SettingFlags flags;
};

/// Where the results go; empty: not wanted.
struct Outputs {
  std::string picture, record, preview;
  std::vector<std::string> all() const;
};

/// Errors: UsageError; WriteError for files that cannot be made.
Outputs outputs_of(const RenderOptions& options);

/// What the tracing is told, apart from the scene. Errors: UsageError.
transport::RenderSettings render_settings(const RenderOptions& options, const Settings& settings,
                                          const transport::RenderDefaults& scene, const Ranks& ranks);

/// The same with what becomes of it. Errors: UsageError.
TracingJob job_of(const RenderOptions& options, const Settings& settings, const transport::RenderSettings& render,
                  const import::Imported& imported, const Outputs& outputs, const Ranks& ranks);

}  // namespace heckbert::cli
