#pragma once
// Which part of a record a command is asked about: flags for pixels, words, and, where the record has labels, for what
// is seen on an object or comes from a group of lights.

#include <string>

#include <heckbert/cli/settings.h>
#include <heckbert/report/part.h>

namespace CLI {
class App;
}

namespace heckbert::cli {

struct PartFlags {
  std::string region, pixel;        ///< "x0,y0,x1,y1", "x,y"; empty: not given
  std::string of;                   ///< an expression, @name or .grammar file
  std::string object, light_group;  ///< labels
};

/// Adds --region, --pixel, --of, --object and --light-group.
void add_part(CLI::App& command, PartFlags& flags);

/// Whether some pixels are asked for, and not the picture as a whole.
bool has_pixels(const PartFlags& flags);

/// A pixel of the record as "x,y". Errors: UsageError, also for one outside of it.
record::Window pixel_of(const std::string& flag, const std::string& text, const record::Record& record);

/// Errors: UsageError for values that do not fit the record; as find_grammar for --of.
report::Part part_of(const PartFlags& flags, const record::Record& record, const Settings& settings);

}  // namespace heckbert::cli
