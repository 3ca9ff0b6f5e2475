// What a question costs once the render is over: the energies of 1, 16 and 256 expressions of the record of the
// lecture's scene in one call, beside their compilation and what of the record is read for them; coverage, which reads
// all pixels; and whether declaring expressions before the render costs anything: the time of a render whose record is
// then asked 256 expressions, over that of one whose record is not.
//
// Usage: asking [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]     defaults 5 64 512

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/import/import.h>
#include <heckbert/record/file.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/energies.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/transport/render.h>

namespace {

using namespace heckbert;

template <class F>
double seconds(F f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Different expressions of the kinds that people ask: a word, a word with a tail, what goes through a letter.
std::vector<std::string> expressions(std::size_t count) {
  const std::vector<std::string> letters{"D", "S", "G", "(D|S)", "(D|G)", "S+", "D*", ".*"};
  std::vector<std::string> result;
  for (std::size_t i = 0; result.size() < count; ++i)
    result.push_back("L " + letters[i % 8] + " " + letters[i / 8 % 8] + " " + letters[i / 64 % 8] + " E");
  return result;
}

std::vector<taxonomy::Language> compiled(std::size_t count) {
  std::vector<taxonomy::Language> languages;
  for (const std::string& expression : expressions(count)) languages.push_back(taxonomy::compile(expression));
  return languages;
}

void ask(const record::Record& record, const std::vector<taxonomy::Language>& languages) {
  const auto sums = report::Energies(record, 0.95).of_outcomes(record::outcomes(record, languages), languages.size());
  if (sums.size() != languages.size()) std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
  const int samples = argc > 2 ? std::atoi(argv[2]) : 64;
  const int size = argc > 3 ? std::atoi(argv[3]) : 512;
  if (rounds < 1 || samples < 1 || size < 1) {
    fmt::print(stderr, "usage: asking [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]\n");
    return 2;
  }
  const transport::Scene scene = import::load_scene_or_builtin("lecture").scene;
  const transport::RenderSettings settings{.width = size, .height = size, .samples_per_pixel = samples};
  const auto file = std::filesystem::temp_directory_path() / "heckbert-asking.paths.exr";
  record::write_record(transport::render(scene, settings), file);
  fmt::print("lecture {}x{}, {} samples: {:.1f} MB on disk\n", size, size, samples,
             static_cast<double>(std::filesystem::file_size(file)) / 1e6);

  const std::vector<std::size_t> counts{1, 16, 256};
  std::vector<double> reading;
  std::vector<std::vector<double>> compiling(counts.size()), asking(counts.size()), whole(counts.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < counts.size(); ++i) {
      record::Record record;
      std::vector<taxonomy::Language> languages;
      const double read = seconds([&] { record = record::read_record_totals(file); });
      const double compile = seconds([&] { languages = compiled(counts[i]); });
      const double answer = seconds([&] { ask(record, languages); });
      reading.push_back(read);
      compiling[i].push_back(compile);
      asking[i].push_back(answer);
      whole[i].push_back(read + compile + answer);
    }
  fmt::print("reading without pixels {:.0f} ms\n", 1e3 * median(reading));
  for (std::size_t i = 0; i < counts.size(); ++i)
    fmt::print(
        "{:3} expressions: compiling {:.1f} ms, answering {:.1f} ms, with reading {:.0f} ms, {:.2f} times that of 1\n",
        counts[i], 1e3 * median(compiling[i]), 1e3 * median(asking[i]), 1e3 * median(whole[i]),
        median(whole[i]) / median(whole[0]));

  const std::vector<taxonomy::Grammar> core = taxonomy::core_algorithms(taxonomy::builtin_grammars());
  std::vector<double> covering, holding;
  for (int round = 0; round < rounds; ++round) {
    covering.push_back(seconds([&] {
      const record::RecordFile open(file);
      report::coverage(open.totals(), rows_of(open), core);
    }));
    holding.push_back(seconds([&] { report::coverage(record::read_record(file), core); }));
  }
  fmt::print("coverage of {} algorithms with reading: {:.0f} ms, {:.0f} ms when the pixels are held\n", core.size(),
             1e3 * median(covering), 1e3 * median(holding));

  std::vector<double> ratios;
  const std::vector<taxonomy::Language> many = compiled(256);
  for (int round = 0; round < rounds; ++round) {
    const double without = seconds([&] { transport::render(scene, settings); });
    const double with = seconds([&] { ask(transport::render(scene, settings), many); });
    ratios.push_back(with / without);
  }
  fmt::print("render with 256 expressions asked over one with none, median of {} pairs: {:.3f} ({:.3f} to {:.3f})\n",
             rounds, median(ratios), *std::min_element(ratios.begin(), ratios.end()),
             *std::max_element(ratios.begin(), ratios.end()));
  std::filesystem::remove(file);
}
