#include <heckbert/taxonomy/partition.h>

#include <heckbert/taxonomy/work.h>

namespace heckbert::taxonomy {

Partition partition(std::span<const Language> classes, const Language& whole) {
  const WorkLimit limit((classes.size() + 1) * kCompileSteps);
  Partition result;
  Language covered;
  for (std::size_t j = 0; j < classes.size(); ++j) {
    const Language within = classes[j] & whole;
    // Most lists are disjoint, and then one intersection per class is enough.
    if (!(within & covered).is_empty())
      for (std::size_t i = 0; i < j; ++i)
        if (const auto shared = (classes[i] & within).shortest_word()) result.overlaps.push_back({i, j, *shared});
    covered = covered | within;
  }
  result.gap = (whole - covered).shortest_word();
  return result;
}

}  // namespace heckbert::taxonomy
