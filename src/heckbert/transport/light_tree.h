#pragma once
// Choosing one of many lights in proportion to what each might send to a place, in logarithmic time: a binary tree over
// the lights whose nodes bound all lights below them (Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights
// with Adaptive Tree Splitting", without the splitting). The way down draws a child by the importance of its bounds;
// the way up from a light that was hit by chance gives the probability of having drawn it, exactly.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include <heckbert/transport/light_bounds.h>

namespace heckbert::transport {

class LightTree {
 public:
  LightTree() = default;
  /// Cost: O(n log n) time, two nodes per light.
  explicit LightTree(const std::vector<LightBounds>& lights);

  struct Choice {
    std::size_t light = 0;
    double probability = 0;
  };
  /// Nothing where no light can shine; `u` is in [0, 1).
  std::optional<Choice> sample(glm::vec3 from, double u) const;
  double probability(std::size_t light, glm::vec3 from) const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Node {
    LightBounds bounds;
    std::uint32_t parent = kNone;
    std::uint32_t left = kNone, right = kNone;  ///< none: a leaf
    std::uint32_t light = kNone;                ///< of a leaf
  };
  std::uint32_t build(const std::vector<LightBounds>& lights, std::uint32_t* first, std::uint32_t* last,
                      std::uint32_t parent);

  std::vector<Node> nodes_;  ///< the root first
  std::vector<std::uint32_t> leaf_of_;
};

}  // namespace heckbert::transport
