#include <heckbert/taxonomy/spectrum.h>

namespace heckbert::taxonomy {

std::vector<double> length_spectrum(const Language& language, const SymbolWeights& weights, std::size_t max_length) {
  const Language words = language & Language::universe();
  const std::vector<State>& states = words.states();
  std::vector<double> arrived(states.size(), 0.0), spectrum;
  arrived[0] = 1.0;
  for (std::size_t letters = 1; letters <= max_length + 2; ++letters) {
    std::vector<double> next(states.size(), 0.0);
    for (std::size_t q = 0; q < states.size(); ++q)
      for (std::size_t s = 0; s < kSymbolCount; ++s) next[states[q].next[s]] += arrived[q] * weights[s];
    arrived = std::move(next);
    if (letters < 2) continue;
    double total = 0.0;
    for (std::size_t q = 0; q < states.size(); ++q)
      if (states[q].accepting) total += arrived[q];
    spectrum.push_back(total);
  }
  return spectrum;
}

}  // namespace heckbert::taxonomy
