#include <heckbert/cli/console.h>

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace heckbert::cli {
namespace {

constexpr std::size_t kPlainWidth = 100;  ///< of tables when there is no terminal

bool wanted(When when, bool by_itself) {
  return when == When::Always || (when == When::Auto && by_itself);
}

bool terminal_with_colours() {
  const char* no_color = std::getenv("NO_COLOR");  // https://no-color.org
  const char* term = std::getenv("TERM");
  return isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == 0) &&
         (term == nullptr || std::string_view(term) != "dumb");
}

}  // namespace

Console::Console(const Settings& settings)
    : quiet_(settings.quiet), verbose_(settings.verbose), colours_(wanted(settings.color, terminal_with_colours())) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  if (wanted(settings.progress, terminal && !settings.quiet))
    progress_ = terminal ? ProgressStyle::Bar : ProgressStyle::Lines;
}

std::string Console::paint(Style style, std::string_view text) const {
  if (!colours_) return std::string(text);
  const int code = style == Style::Good ? 32 : 31;
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

report::TextStyle Console::table_style() const {
  report::TextStyle style{.width = kPlainWidth, .colour = colours_};
  // Behind a pipe there may still be a terminal, as in "heckbert coverage r.exr | less".
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    winsize size{};
    if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) continue;
    style.width = size.ws_col;
    break;
  }
  return style;
}

void Console::note(std::string_view text) const {
  if (!quiet_ && !text.empty()) fmt::print(stderr, "{}{}", text, text.ends_with('\n') ? "" : "\n");
}

void Console::detail(std::string_view text) const {
  if (verbose_) note(text);
}

}  // namespace heckbert::cli
