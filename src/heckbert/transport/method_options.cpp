#include <heckbert/transport/method_options.h>

#include <algorithm>

#include <fmt/format.h>

namespace heckbert::transport {

bool reads(AlgorithmId algorithm, const MethodOption& option) {
  return std::ranges::find(option.algorithms, algorithm) != option.algorithms.end();
}

const MethodOption* refining_option(AlgorithmId algorithm) {
  const auto found = std::ranges::find_if(
      kMethodOptions, [&](const MethodOption& option) { return option.order > 0 && reads(algorithm, option); });
  return found == kMethodOptions.end() ? nullptr : &*found;
}

std::string write(const Method& method) {
  std::string text;
  for (const MethodOption& option : kMethodOptions)
    if (option.get(method) != option.get({}))
      text += fmt::format("{}{}={:.7g}", text.empty() ? "" : ",", option.name, option.get(method));
  return text;
}

}  // namespace heckbert::transport
