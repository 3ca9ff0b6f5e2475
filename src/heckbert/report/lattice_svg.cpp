#include <heckbert/report/lattice_svg.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/report/html_text.h>
#include <heckbert/report/text_table.h>

namespace heckbert::report {

namespace {

// Layers by level, order within a layer by the mean of the neighbours, then places as near to them as the widths
// allow. Lines across several layers bend at points of their own, so that they go round the boxes between.
// Source: Sugiyama, Tagawa, Toda 1981, "Methods for visual understanding of hierarchical system structures".

constexpr double kLetter = 7.3;  // width of a letter of the font below, in pixels
constexpr double kBoxHeight = 26, kLayerHeight = 96, kGap = 22, kMargin = 20;
constexpr double kLabelLetter = 6.7, kLabelHeight = 13;
constexpr int kSweeps = 24;

struct Point {
  std::size_t layer = 0;
  double width = 0, x = 0;  ///< x is the middle
  std::vector<std::size_t> below{}, above{};
};

std::string title_of(const taxonomy::LatticeNode& node) {
  return fmt::format("{}", fmt::join(node.names, " = "));
}

class Layout {
 public:
  explicit Layout(const taxonomy::Lattice& lattice) {
    for (const taxonomy::LatticeNode& node : lattice.nodes)
      add({node.level, static_cast<double>(display_width(title_of(node))) * kLetter + 16});
    for (const taxonomy::LatticeEdge& edge : lattice.edges) {
      std::vector<std::size_t> path{edge.below};
      for (std::size_t layer = points_[edge.below].layer + 1; layer < points_[edge.above].layer; ++layer)
        path.push_back(add({layer, kGap}));
      path.push_back(edge.above);
      for (std::size_t i = 1; i < path.size(); ++i) {
        points_[path[i - 1]].above.push_back(path[i]);
        points_[path[i]].below.push_back(path[i - 1]);
      }
      paths_.push_back(std::move(path));
    }
    arrange();
  }

  double width() const { return width_; }
  double height() const { return static_cast<double>(layers_.size() - 1) * kLayerHeight + kBoxHeight + 2 * kMargin; }
  const Point& point(std::size_t i) const { return points_[i]; }
  /// Of the middle of the point's box, from the top.
  double y(std::size_t i) const {
    return kMargin + kBoxHeight / 2 + static_cast<double>(layers_.size() - 1 - points_[i].layer) * kLayerHeight;
  }
  const std::vector<std::vector<std::size_t>>& paths() const { return paths_; }

 private:
  std::size_t add(Point point) {
    if (layers_.size() <= point.layer) layers_.resize(point.layer + 1);
    layers_[point.layer].push_back(points_.size());
    points_.push_back(std::move(point));
    return points_.size() - 1;
  }

  double wanted(std::size_t i, bool from_below) const {
    const std::vector<std::size_t>& near = from_below ? points_[i].below : points_[i].above;
    if (near.empty()) return points_[i].x;
    double sum = 0;
    for (const std::size_t n : near) sum += points_[n].x;
    return sum / static_cast<double>(near.size());
  }

  double separation(std::size_t left, std::size_t right) const {
    return (points_[left].width + points_[right].width) / 2 + kGap;
  }

  // Where each wants to be, pushed apart from the left and from the right, and the middle of both.
  void place(std::vector<std::size_t>& layer, bool from_below, bool may_swap) {
    std::vector<double> want(points_.size());
    for (const std::size_t i : layer) want[i] = wanted(i, from_below);
    if (may_swap)
      std::stable_sort(layer.begin(), layer.end(), [&](std::size_t a, std::size_t b) { return want[a] < want[b]; });
    std::vector<double> right(layer.size()), left(layer.size());
    for (std::size_t k = 0; k < layer.size(); ++k)
      right[k] = k == 0 ? want[layer[0]] : std::max(want[layer[k]], right[k - 1] + separation(layer[k - 1], layer[k]));
    for (std::size_t k = layer.size(); k-- > 0;)
      left[k] = k + 1 == layer.size() ? want[layer[k]]
                                      : std::min(want[layer[k]], left[k + 1] - separation(layer[k], layer[k + 1]));
    for (std::size_t k = 0; k < layer.size(); ++k) points_[layer[k]].x = (left[k] + right[k]) / 2;
  }

  void arrange() {
    for (std::vector<std::size_t>& layer : layers_) place(layer, true, false);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      const bool may_swap = sweep < kSweeps / 2;
      for (std::size_t l = 1; l < layers_.size(); ++l) place(layers_[l], true, may_swap);
      for (std::size_t l = layers_.size() - 1; l-- > 0;) place(layers_[l], false, may_swap);
    }
    double leftmost = points_[0].x, rightmost = leftmost;
    for (const Point& p : points_) {
      leftmost = std::min(leftmost, p.x - p.width / 2);
      rightmost = std::max(rightmost, p.x + p.width / 2);
    }
    for (Point& p : points_) p.x += kMargin - leftmost;
    width_ = rightmost - leftmost + 2 * kMargin;
  }

  std::vector<Point> points_;                     ///< nodes of the lattice first, then bends
  std::vector<std::vector<std::size_t>> layers_;  ///< from the bottom, each from left to right
  std::vector<std::vector<std::size_t>> paths_;   ///< one per edge
  double width_ = 0;
};

struct Place {
  double x, y;  ///< of the middle
};

// Where the labels of lines are: in the middle, or as near to it as other labels leave room.
class Labels {
 public:
  Place add(Place from, Place to, double width) {
    Label best{};
    double least = std::numeric_limits<double>::infinity();
    for (const double along : {.5, .38, .62, .26, .74, .14, .86}) {
      const Label label{{from.x + along * (to.x - from.x), from.y + along * (to.y - from.y)}, width};
      double hidden = 0;
      for (const Label& other : labels_) hidden += overlap(label, other);
      if (hidden >= least) continue;
      best = label;
      least = hidden;
    }
    labels_.push_back(best);
    return best.middle;
  }

 private:
  struct Label {
    Place middle;
    double width;
  };
  static double overlap(const Label& a, const Label& b) {
    const double across = (a.width + b.width) / 2 - std::abs(a.middle.x - b.middle.x);
    const double down = kLabelHeight - std::abs(a.middle.y - b.middle.y);
    return std::max(0., across) * std::max(0., down);
  }
  std::vector<Label> labels_;
};

}  // namespace

std::string lattice_svg(const taxonomy::Lattice& lattice) {
  if (lattice.nodes.empty()) return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\" height=\"1\"/>\n";
  const Layout layout(lattice);
  std::string lines, witnesses, boxes, names;
  Labels labels;
  for (std::size_t e = 0; e < lattice.edges.size(); ++e) {
    const std::vector<std::size_t>& path = layout.paths()[e];
    std::string points;
    // Upright past the boxes of a layer, straight from layer to layer.
    for (std::size_t i = 0; i < path.size(); ++i)
      for (const double reach : {kBoxHeight / 2, -kBoxHeight / 2}) {
        const bool is_inside = reach > 0 ? i == 0 : i + 1 == path.size();
        if (!is_inside) points += fmt::format("{:.0f},{:.0f} ", layout.point(path[i]).x, layout.y(path[i]) + reach);
      }
    points.pop_back();
    lines += fmt::format("<polyline points=\"{}\"/>\n", points);
    // In the middle of a long line, where those of one node have spread out.
    const std::size_t lower = (path.size() - 2) / 2, from = path[lower], to = path[lower + 1];
    const std::string witness = plain(lattice.edges[e].witness);
    const Place place = labels.add({layout.point(from).x, layout.y(from) - kBoxHeight / 2},
                                   {layout.point(to).x, layout.y(to) + kBoxHeight / 2},
                                   static_cast<double>(display_width(witness)) * kLabelLetter + 4);
    witnesses += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n", place.x, place.y + 4, escaped(witness));
  }
  for (std::size_t i = 0; i < lattice.nodes.size(); ++i) {
    const Point& p = layout.point(i);
    boxes += fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" rx=\"4\"/>\n",
                         p.x - p.width / 2, layout.y(i) - kBoxHeight / 2, p.width, kBoxHeight);
    names += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n", p.x, layout.y(i) + 4,
                         escaped(title_of(lattice.nodes[i])));
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"monospace\" font-size=\"12\" text-anchor=\"middle\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<g fill=\"none\" stroke=\"#99a\">\n{2}</g>\n"
      "<g fill=\"#a40\" font-size=\"11\" stroke=\"white\" stroke-width=\"4\" paint-order=\"stroke\">\n{3}</g>\n"
      "<g fill=\"#eef3fa\" stroke=\"#468\">\n{4}</g>\n<g fill=\"#123\">\n{5}</g>\n</svg>\n",
      layout.width(), layout.height(), lines, witnesses, boxes, names);
}

}  // namespace heckbert::report
