#include <heckbert/transport/light_tree.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include <glm/common.hpp>

namespace heckbert::transport {

namespace {

constexpr int kBuckets = 12;

glm::vec3 center_of(const LightBounds& b) {
  return 0.5f * (b.low + b.high);
}

}  // namespace

LightTree::LightTree(const std::vector<LightBounds>& lights) : leaf_of_(lights.size()) {
  if (lights.empty()) return;
  nodes_.reserve(2 * lights.size());
  std::vector<std::uint32_t> order(lights.size());
  std::iota(order.begin(), order.end(), 0u);
  build(lights, order.data(), order.data() + order.size(), kNone);
}

std::uint32_t LightTree::build(const std::vector<LightBounds>& lights, std::uint32_t* first, std::uint32_t* last,
                               std::uint32_t parent) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({.bounds = lights[*first], .parent = parent});
  if (last - first == 1) {
    nodes_[index].light = *first;
    leaf_of_[*first] = index;
    return index;
  }
  glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low);
  for (const std::uint32_t* at = first; at != last; ++at) {
    const glm::vec3 center = center_of(lights[*at]);
    low = glm::min(low, center);
    high = glm::max(high, center);
  }

  // The cheapest of the planes between equal slabs, along all three axes.
  const auto bucket_of = [&](std::uint32_t light, int axis) {
    const float place = (center_of(lights[light])[axis] - low[axis]) / (high[axis] - low[axis]);
    return std::clamp(static_cast<int>(place * kBuckets), 0, kBuckets - 1);
  };
  int best_axis = -1, best_bucket = 0;
  double best_cost = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (!(high[axis] > low[axis])) continue;
    std::array<std::optional<LightBounds>, kBuckets> buckets;
    for (const std::uint32_t* at = first; at != last; ++at) {
      auto& bucket = buckets[static_cast<std::size_t>(bucket_of(*at, axis))];
      bucket = bucket ? join(*bucket, lights[*at]) : lights[*at];
    }
    const auto extend = [](std::optional<LightBounds>& sum, const std::optional<LightBounds>& more) {
      if (more) sum = sum ? join(*sum, *more) : *more;
    };
    std::array<double, kBuckets> cost_above{};
    std::optional<LightBounds> sum;
    for (std::size_t i = kBuckets; i-- > 1;) {
      extend(sum, buckets[i]);
      cost_above[i] = sum ? split_cost(*sum) : 0;
    }
    sum.reset();
    for (std::size_t i = 1; i < kBuckets; ++i) {
      extend(sum, buckets[i - 1]);
      const double cost = (sum ? split_cost(*sum) : 0) + cost_above[i];
      if (cost < best_cost) {
        best_cost = cost;
        best_axis = axis;
        best_bucket = static_cast<int>(i);
      }
    }
  }
  std::uint32_t* middle = first;
  if (best_axis >= 0)
    middle = std::partition(first, last, [&](std::uint32_t l) { return bucket_of(l, best_axis) < best_bucket; });
  if (middle == first || middle == last) middle = first + (last - first) / 2;

  const std::uint32_t left = build(lights, first, middle, index), right = build(lights, middle, last, index);
  Node& node = nodes_[index];
  node.left = left;
  node.right = right;
  node.bounds = join(nodes_[left].bounds, nodes_[right].bounds);
  return index;
}

std::optional<LightTree::Choice> LightTree::sample(glm::vec3 from, double u) const {
  if (nodes_.empty()) return std::nullopt;
  double probability = 1;
  std::uint32_t at = 0;
  while (nodes_[at].light == kNone) {
    const double left = importance(nodes_[nodes_[at].left].bounds, from);
    const double right = importance(nodes_[nodes_[at].right].bounds, from);
    if (!(left + right > 0)) return std::nullopt;
    const double p_left = left / (left + right);
    const bool go_left = u < p_left;
    u = go_left ? u / p_left : (u - p_left) / (1 - p_left);
    probability *= go_left ? p_left : 1 - p_left;
    at = go_left ? nodes_[at].left : nodes_[at].right;
  }
  return Choice{nodes_[at].light, probability};
}

double LightTree::probability(std::size_t light, glm::vec3 from) const {
  double probability = 1;
  for (std::uint32_t at = leaf_of_[light]; nodes_[at].parent != kNone; at = nodes_[at].parent) {
    const Node& parent = nodes_[nodes_[at].parent];
    const double left = importance(nodes_[parent.left].bounds, from);
    const double right = importance(nodes_[parent.right].bounds, from);
    if (!(left + right > 0)) return 0;
    const double p_left = left / (left + right);
    probability *= parent.left == at ? p_left : 1 - p_left;
  }
  return probability;
}

}  // namespace heckbert::transport
