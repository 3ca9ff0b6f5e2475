// Classifies the paths of your own renderer, with heckbert::taxonomy and nothing else: one integer per path, one step
// per event. The renderer here is the smallest that has an answer to check: a closed room whose walls emit 1, reflect
// half the light diffusely and a fifth like mirrors, so a word with d D's and s S's is worth 0.5^d 0.2^s.

#include <array>
#include <cstdio>
#include <random>
#include <vector>

#include <heckbert/taxonomy/classifier.h>
#include <heckbert/taxonomy/expression.h>

int main() {
  using namespace heckbert::taxonomy;
  const std::array expressions{"L E", "L D E", "L S+ E", "L S+ D E", "L D S+ E", "L D D+ E", "L .* E"};
  const std::array exact{1., .5, .2 / .8, .2 / .8 * .5, .5 * .2 / .8, .25 / .5, 1 / .3};

  std::vector<Language> languages;
  for (const char* expression : expressions) languages.push_back(compile(expression));
  const Classifier classifier(languages, WalkFrom::Eye);

  std::mt19937 random(1);
  std::array<double, expressions.size()> sums{};
  constexpr int kPaths = 1'000'000;
  for (int i = 0; i < kPaths; ++i) {
    auto at = classifier.step(classifier.start(), Symbol::Ep);
    for (;;) {
      // Each wall that is met emits: a path ends here, and the walk goes on unless it is absorbed.
      const auto path = classifier.step(at, Symbol::La);
      classifier.for_each_member(path, [&](std::size_t class_of_paths) { sums[class_of_paths] += 1; });
      const auto tenths = random() % 10;
      if (tenths >= 7) break;
      at = classifier.step(at, tenths < 5 ? Symbol::Dr : Symbol::Sr);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    std::printf("%-10s %.3f, exactly %.3f\n", expressions[i], sums[i] / kPaths, exact[i]);
}
