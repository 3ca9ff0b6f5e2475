// What it costs to have all grammars ready: every command reads them on first use, so their time is in every start of
// the program. Aim: at most 10 ms. Prints the first use in this process, cold, and the median of reading the same files
// again, with the slowest files by themselves.
//
// Usage: grammar_compile [ROUNDS [DIRECTORY]]     defaults 50 and the grammars of the source tree

#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/taxonomy/grammar.h>

namespace {

using namespace heckbert;

/// Processor time, so that what else the machine does counts less.
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

template <class F>
double milliseconds(F f) {
  const double start = now();
  f();
  return now() - start;
}

template <class F>
double median_milliseconds(int rounds, F f) {
  std::vector<double> times(static_cast<std::size_t>(rounds));
  for (double& time : times) time = milliseconds(f);
  std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
  return times[static_cast<std::size_t>(rounds / 2)];
}

struct File {
  std::string name, text;
};

std::vector<File> read(const std::string& directory) {
  std::vector<File> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() != ".grammar") continue;
    std::ifstream in(entry.path());
    files.push_back({entry.path().filename(), {std::istreambuf_iterator<char>(in), {}}});
  }
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 50;
  const std::string directory = argc > 2 ? argv[2] : HECKBERT_GRAMMAR_DIR;

  const double first = milliseconds([] { taxonomy::builtin_grammars(); });
  const taxonomy::GrammarLibrary& library = taxonomy::builtin_grammars();
  std::size_t states = 0;
  for (const taxonomy::Grammar& grammar : library.grammars) states += grammar.language.states().size();
  fmt::print("{} built-in grammars, {} states in all\n", library.grammars.size(), states);
  fmt::print("first use, cold      {:6.2f} ms\n", first);

  const std::vector<File> files = read(directory);
  std::vector<taxonomy::GrammarText> texts;
  texts.reserve(files.size());
  for (const File& file : files) texts.push_back({file.name, file.text});
  fmt::print("{} files, all        {:6.2f} ms, median of {}\n", files.size(),
             median_milliseconds(rounds, [&] { taxonomy::read_grammars(texts); }), rounds);

  struct Cost {
    double time;
    std::string name;
  };
  std::vector<Cost> costs;
  for (const File& file : files) {
    taxonomy::GrammarLibrary others = library;
    std::erase_if(others.grammars, [&](const auto& grammar) { return grammar.name + ".grammar" == file.name; });
    costs.push_back(
        {median_milliseconds(rounds, [&] { taxonomy::parse_grammar(file.text, file.name, others); }), file.name});
  }
  std::sort(costs.begin(), costs.end(), [](const Cost& a, const Cost& b) { return a.time > b.time; });
  for (std::size_t i = 0; i < std::min<std::size_t>(5, costs.size()); ++i)
    fmt::print("  {:<40} {:6.3f} ms\n", costs[i].name, costs[i].time);
}
