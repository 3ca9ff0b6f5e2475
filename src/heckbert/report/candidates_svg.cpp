// Captured share over the time that it takes, on a logarithmic axis: what is enough lies above the dashed line, and the
// cheapest of it farthest to the left.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <heckbert/report/diagnosis_text.h>
#include <heckbert/report/html_text.h>
#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

constexpr double kWidth = 640, kHeight = 400, kLeft = 60, kRight = 150, kTop = 24, kBottom = 48;

}  // namespace

std::string candidates_svg(const Diagnosis& diagnosis) {
  std::vector<const Candidate*> shown;
  for (const Candidate& candidate : diagnosis.candidates)
    if (candidate.seconds && *candidate.seconds > 0) shown.push_back(&candidate);
  int first = 0, last = 1;  // decades
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double decade = std::log10(*shown[i]->seconds);
    first = i == 0 ? static_cast<int>(std::floor(decade)) : std::min(first, static_cast<int>(std::floor(decade)));
    last = i == 0 ? static_cast<int>(std::ceil(decade)) : std::max(last, static_cast<int>(std::ceil(decade)));
  }
  last = std::max(last, first + 1);
  const auto x = [&](double seconds) {
    return kLeft + (std::log10(seconds) - first) / (last - first) * (kWidth - kLeft - kRight);
  };
  const auto y = [](double share) { return kTop + (1 - share) * (kHeight - kTop - kBottom); };

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kWidth, kHeight);
  for (int decade = first; decade <= last; ++decade) {
    const double at = x(std::pow(10.0, decade));
    svg += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g} "
        "s</text>\n",
        at, kTop, kHeight - kBottom, kHeight - kBottom + 18, std::pow(10.0, decade));
  }
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    svg += fmt::format(
        "<path d=\"M{} {:.1f}H{}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g} %</text>\n",
        kLeft, y(share), kWidth - kRight, kLeft - 8, y(share) + 4, 100 * share);
  svg += fmt::format("<path d=\"M{} {:.1f}H{}\" stroke=\"#888\" stroke-dasharray=\"4 3\"/>\n", kLeft, y(kSufficient),
                     kWidth - kRight);
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">time to an error of {}</text>\n",
                     (kLeft + kWidth - kRight) / 2, kHeight - 10, percent(diagnosis.options.error));
  // Names that would stand on each other move down.
  std::stable_sort(shown.begin(), shown.end(),
                   [](const Candidate* a, const Candidate* b) { return a->share > b->share; });
  double lowest = 0;
  for (const Candidate* candidate : shown) {
    const double at_x = x(*candidate->seconds), at_y = y(candidate->share);
    const double text_y = std::max(at_y + 4, lowest + 14);
    lowest = text_y;
    svg += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"4\" fill=\"{2}\"/><path d=\"M{0:.1f} {1:.1f}L{3:.1f} {4:.1f}\" "
        "stroke=\"#aaa\" stroke-width=\".5\"/><text x=\"{3:.1f}\" y=\"{5:.1f}\">{6}</text>\n",
        at_x, at_y, candidate->is_minimal ? "#c33" : "#336", kWidth - kRight + 8, text_y - 4, text_y,
        escaped(candidate->algorithm));
  }
  return svg + "</svg>\n";
}

}  // namespace heckbert::report
