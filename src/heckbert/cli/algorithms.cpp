#include <heckbert/cli/algorithms.h>

#include <fmt/format.h>

#include <heckbert/transport/render.h>

namespace heckbert::cli {

std::string with_algorithms(std::string help) {
  for (const transport::AlgorithmFacts& algorithm : transport::kAlgorithms)
    help += fmt::format("\n{:<17} {}", algorithm.name, algorithm.title);
  return help;
}

}  // namespace heckbert::cli
