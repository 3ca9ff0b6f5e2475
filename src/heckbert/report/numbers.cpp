#include <heckbert/report/numbers.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace heckbert::report {
namespace {

/// Per cent with two decimals and no sign on nought.
std::string two_decimals(double share) {
  const double rounded = std::round(share * 1e4) / 1e2;
  return fmt::format("{:.2f}", rounded == 0 ? 0.0 : rounded);
}

}  // namespace

std::string percent(double share) {
  if (share > 0 && share < 0.5e-4) return "< 0.01 %";
  return two_decimals(share) + " %";
}

std::string percent_interval(const record::Estimate& share) {
  if (!share.known) return "unknown";
  return fmt::format("{} to {} %", two_decimals(share.lower), two_decimals(share.upper));
}

std::string bracketed_percent(const record::Estimate& share) {
  if (!share.known) return "-";
  return fmt::format("[{}, {}]", two_decimals(share.lower), two_decimals(share.upper));
}

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

std::string aligned_number(double value, double largest) {
  if (largest <= 0) return "0";
  const int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 12);
  return fmt::format("{:.{}f}", value, decimals);
}

std::string grouped(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ' ');
  return text;
}

std::string counted(std::uint64_t count, const std::string& singular) {
  return grouped(count) + " " + singular + (count == 1 ? "" : "s");
}

std::string samples_text(const std::optional<double>& needed) {
  if (!needed) return "-";
  constexpr double kMost = 1e15;
  const double count = std::clamp(*needed, 1.0, kMost);
  const double unit = std::pow(10.0, std::max(std::floor(std::log10(count)) - 2, 0.0));
  return grouped(static_cast<std::uint64_t>(std::ceil(count / unit) * unit));
}

std::string level(double confidence) {
  return fmt::format("{:g} %", 100 * confidence);
}

}  // namespace heckbert::report
