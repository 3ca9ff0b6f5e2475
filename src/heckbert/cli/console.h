#pragma once
// What this tool shows: results on standard output, everything else on standard error. Colours and the progress bar
// appear on a terminal only, unless asked for.

#include <string>
#include <string_view>

#include <heckbert/cli/settings.h>
#include <heckbert/report/text_table.h>

namespace heckbert::cli {

enum class Style : std::uint8_t { Good, Bad };
enum class ProgressStyle : std::uint8_t { None, Lines, Bar };

class Console {
 public:
  explicit Console(const Settings& settings);

  /// `text` in a style, when standard output shows colours.
  std::string paint(Style style, std::string_view text) const;
  /// How wide and how colourful tables on standard output may be.
  report::TextStyle table_style() const;
  ProgressStyle progress() const { return progress_; }

  /// Lines on standard error, unless --quiet. A missing newline is added; no text, no line.
  void note(std::string_view text) const;
  /// Lines on standard error with --verbose.
  void detail(std::string_view text) const;

 private:
  bool quiet_ = false, verbose_ = false, colours_ = false;
  ProgressStyle progress_ = ProgressStyle::None;
};

}  // namespace heckbert::cli
