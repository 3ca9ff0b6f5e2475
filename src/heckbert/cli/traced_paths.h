#pragma once
// The paths behind a pixel of a record: the scene is loaded again, the pixel's samples are walked again, and what they
// find must be what the record says.

#include <cstddef>
#include <string>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/report/text_table.h>
#include <heckbert/transport/retrace.h>

namespace heckbert::cli {

/// The settings that a record was rendered with. Errors: ReadError for what this version does not know.
transport::RenderSettings settings_of(const record::RenderInfo& info);

/// All paths of a pixel, the heaviest first. `scene` names the scene's file; empty: as the record does.
/// Errors: ReadError when the scene is another one than that of the record, or when the paths are not the record's;
/// InputError as from reading a scene.
std::vector<transport::RetracedPath> traced_paths(const record::Record& record, const std::string& scene, int x, int y);

/// The first `most` paths with their vertices, 0 for all; shares are of the pixel's luminance.
std::string paths_text(const std::vector<transport::RetracedPath>& paths, const record::Record& record,
                       const report::TextStyle& style, std::size_t most);

/// One object per path: word, technique, sample, value, vertices.
report::Json to_json(const std::vector<transport::RetracedPath>& paths);

}  // namespace heckbert::cli
