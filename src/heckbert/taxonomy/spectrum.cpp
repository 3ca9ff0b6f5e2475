#include <heckbert/taxonomy/spectrum.h>

#include <heckbert/taxonomy/label.h>

namespace heckbert::taxonomy {

std::vector<double> length_spectrum(const Language& language, const SymbolWeights& weights, std::size_t max_length) {
  const Language words = language & Language::universe();
  const std::vector<State>& states = words.states();
  const std::size_t unlabelled = words.alphabet().class_of(kUnlabelled);
  std::vector<double> arrived(states.size(), 0.0), spectrum;
  arrived[0] = 1.0;
  for (std::size_t letters = 1; letters <= max_length + 2; ++letters) {
    std::vector<double> next(states.size(), 0.0);
    for (std::size_t q = 0; q < states.size(); ++q)
      for (const SymbolFacts& f : kSymbols)
        next[states[q].next[Alphabet::column(f.symbol, unlabelled)]] += arrived[q] * weights[index(f.symbol)];
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
