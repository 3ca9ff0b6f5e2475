// How long does the worst expression take, and how much memory? Compiles the hostile expressions of the tests, then
// random ones of any length in any dialect, and prints the slowest and the largest. Aim: no expression of up to ten
// thousand characters takes more than 100 ms and 64 MiB, whether it is compiled or refused.
//
// Usage: limits [RANDOM_EXPRESSIONS [SEED]]     defaults 2000 1

#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/work.h>
#include <taxonomy/hostile_expressions.h>

namespace {

std::size_t live_bytes = 0, peak_bytes = 0;

}  // namespace

void* operator new(std::size_t size) {
  void* block = std::malloc(size);
  if (block == nullptr) throw std::bad_alloc();
  live_bytes += malloc_usable_size(block);
  peak_bytes = std::max(peak_bytes, live_bytes);
  return block;
}
void operator delete(void* block) noexcept {
  live_bytes -= malloc_usable_size(block);
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  operator delete(block);
}

namespace {

using namespace heckbert;
using namespace heckbert::taxonomy;

double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Cost {
  double milliseconds;
  double mebibytes;
  double steps;
  std::string name, outcome;
};

Cost cost_of(const Hostile& hostile) {
  std::string outcome;
  const std::size_t before = live_bytes;
  peak_bytes = before;
  const WorkLimit counter(std::size_t{1} << 40);
  const double start = now();
  try {
    outcome = fmt::format("{} states", read_expression(hostile.text, hostile.dialect).language.states().size());
  } catch (const std::exception& error) {
    outcome = error.what();
  }
  const double end = now();
  outcome = outcome.substr(outcome.find("error: ") == std::string::npos ? 0 : outcome.find("error: ") + 7);
  std::replace(outcome.begin(), outcome.end(), '\n', ' ');
  return {1e3 * (end - start), static_cast<double>(peak_bytes - before) / (1 << 20),
          static_cast<double>(counter.spent()), hostile.name, outcome.substr(0, 110)};
}

void print(std::vector<Cost> costs, std::size_t most) {
  const auto show = [&](std::string_view what, auto key) {
    std::sort(costs.begin(), costs.end(), [&](const Cost& a, const Cost& b) { return key(a) > key(b); });
    fmt::print("the {}\n", what);
    for (std::size_t i = 0; i < std::min(most, costs.size()); ++i)
      fmt::print("  {:8.1f} ms {:6.1f} MiB {:9.0f} steps  {:<42} {}\n", costs[i].milliseconds, costs[i].mebibytes,
                 costs[i].steps, costs[i].name, costs[i].outcome);
  };
  show("slowest", [](const Cost& c) { return c.milliseconds; });
  show("largest", [](const Cost& c) { return c.mebibytes; });
}

}  // namespace

int main(int argc, char** argv) {
  const auto random_count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  const auto seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::vector<Cost> costs;
  for (const Hostile& hostile : hostile_expressions()) costs.push_back(cost_of(hostile));
  fmt::print("{} hostile expressions: ", costs.size());
  print(costs, 25);

  std::mt19937_64 random(seed);
  costs.clear();
  for (std::size_t i = 0; i < random_count; ++i) {
    const Dialect dialect = kDialects[random() % kDialects.size()].dialect;
    const std::size_t length = 10u << random() % 10;
    std::string text = random_expression(dialect, length, random);
    if (text.size() > kLongestHostile) continue;
    std::string name = fmt::format("{} of {}: {}", facts(dialect).name, text.size(), text.substr(0, 24));
    costs.push_back(cost_of({std::move(name), std::move(text), dialect}));
  }
  fmt::print("\n{} random expressions: ", costs.size());
  print(costs, 12);
}
