// How fast are many expressions matched against the words of paths? Ten million words, random walks with the statistics
// of a record; 1, 8, 64 and 256 expressions; this library beside RE2::Set, PCRE2 and Hyperscan, which read the same
// words as texts of one byte per letter. Every way must count the same matches, or the program fails.
//
//   in flight        a renderer that carries a state in each of the 1024 paths of a tile, one table step per event
//   path by path     the same, walking one path to its end before the next
//   reading only     path by path without the steps: what the loop over the events costs by itself
//   distinct words   each walk carries a node of a word trie; afterwards each distinct word is classified once
//
// The words are dealt out in portions and every way has its turn on each portion; printed is the median over the
// portions. A render has one eye, whose step is taken once for all paths; a word of n events is n + 1 more steps, since
// it ends at a light. The price of a whole path, the look-up of its outcome included, is printed by path, by step, and
// by event, where the events bear all of it.
//
// Usage: matching [WORDS [PORTION]]     defaults 10 000 000 and 100 000

#include <time.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/taxonomy/classifier.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/expression_parser.h>
#include <heckbert/taxonomy/word_trie.h>

#include "path_words.h"
#include "peers.h"

namespace {

using namespace heckbert::taxonomy;
using bench::Words;

constexpr std::array<std::size_t, 4> kExpressionCounts{1, 8, 64, 256};
constexpr std::size_t kInFlight = 1024;

using Counts = std::vector<std::uint64_t>;

/// Processor time of this thread, so that what else the machine does counts less.
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class F>
double seconds(F f) {
  const double start = now();
  f();
  return now() - start;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The letters of words for the other engines: one byte each, from 'a'.
char byte(Symbol s) {
  return static_cast<char>('a' + index(s));
}

std::string pattern(const Node& node) {
  std::string text;
  switch (node.kind) {
    case NodeKind::Letters:
      for (const Symbol s : members(node.set.others())) text += byte(s);
      return text.size() == 1 ? text : "[" + text + "]";
    case NodeKind::Repeat:
      return "(?:" + pattern(node.children[0]) + "){" + std::to_string(node.at_least) + "," +
             (node.at_most ? std::to_string(*node.at_most) : "") + "}";
    case NodeKind::Alternation:
      for (const Node& child : node.children) text += (text.empty() ? "" : "|") + pattern(child);
      return "(?:" + text + ")";
    default:
      for (const Node& child : node.children) text += pattern(child);
      return text;
  }
}

std::string pattern(const std::string& expression) {
  ExpressionSource source{"expression", expression, 0, expression.size(), {}};
  return pattern(parse_expression(source));
}

/// A portion of the words as a renderer meets it, 4096 paths at a time: for each depth, who goes on and with what.
struct Flight {
  struct Step {
    std::uint16_t path;
    Symbol letter;
  };
  std::vector<Step> steps;
  std::size_t paths;
};

std::vector<Flight> take_off(const Words& words, std::size_t first, std::size_t last) {
  std::vector<Flight> flights;
  for (; first < last; first += kInFlight) {
    Flight flight{{}, std::min(kInFlight, last - first)};
    for (std::size_t depth = 1, met = 1; met > 0; ++depth) {
      met = 0;
      for (std::size_t i = 0; i < flight.paths; ++i)
        if (depth < words.letters(first + i)) {
          flight.steps.push_back({static_cast<std::uint16_t>(i), words.from_eye[words.begin[first + i] + depth]});
          ++met;
        }
    }
    flights.push_back(std::move(flight));
  }
  return flights;
}

/// How often each outcome was seen, by group: the work of a renderer at the end of a path.
class Tally {
 public:
  explicit Tally(const Classifier& classifier) : classifier_(classifier) {
    for (std::size_t g = 0; g < classifier.group_count(); ++g) seen_.emplace_back(classifier.outcome_count(g));
  }
  void add(Classifier::Prefix word) {
    for (std::size_t g = 0; g < seen_.size(); ++g) ++seen_[g][classifier_.outcome(word, g)];
  }
  Counts counts() const {
    Counts counts(classifier_.language_count());
    for (std::size_t g = 0; g < seen_.size(); ++g)
      for (std::size_t outcome = 0; outcome < seen_[g].size(); ++outcome) {
        const auto bits = classifier_.members(outcome, g);
        for (std::size_t i = 0; i < counts.size(); ++i)
          if (bits[i / 64] >> i % 64 & 1) counts[i] += seen_[g][outcome];
      }
    return counts;
  }

 private:
  const Classifier& classifier_;
  std::vector<Counts> seen_;
};

struct Ours {
  explicit Ours(std::unique_ptr<Classifier> c)
      : classifier(std::move(c)),
        at_eye(classifier->step(classifier->start(), Symbol::Ep)),
        in_flight(*classifier),
        by_path(*classifier) {}

  void fly(const std::vector<Flight>& flights) {
    std::array<Classifier::Prefix, kInFlight> at{};
    for (const Flight& flight : flights) {
      std::fill_n(at.begin(), flight.paths, at_eye);
      for (const Flight::Step& s : flight.steps) at[s.path] = classifier->step(at[s.path], s.letter);
      for (std::size_t i = 0; i < flight.paths; ++i) in_flight.add(at[i]);
    }
  }
  void walk(const Words& words, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Classifier::Prefix at = at_eye;
      for (std::size_t k = words.begin[i] + 1; k < words.begin[i + 1]; ++k)
        at = classifier->step(at, words.from_eye[k]);
      by_path.add(at);
    }
  }

  std::unique_ptr<Classifier> classifier;
  Classifier::Prefix at_eye;
  Tally in_flight, by_path;
};

std::uint64_t read_only(const Words& words, std::size_t first, std::size_t last) {
  std::uint64_t sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    std::uint64_t word = 0;
    for (std::size_t k = words.begin[i]; k < words.begin[i + 1]; ++k) word += index(words.from_eye[k]);
    sum ^= word;
  }
  return sum;
}

/// Walks that carry a word, and how often each word was met.
struct Distinct {
  void walk(const Words& words, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      std::size_t k = words.begin[i];
      WordTrie::Node at = trie.eye(words.from_eye[k]);
      while (++k < words.begin[i + 1]) at = trie.step(at, words.from_eye[k]);
      if (at >= met.size()) met.resize(trie.size());
      ++met[at];
    }
  }
  std::vector<std::pair<Word, std::uint64_t>> words() const {
    std::vector<std::pair<Word, std::uint64_t>> result;
    for (WordTrie::Node node = 0; node < met.size(); ++node)
      if (met[node] > 0) result.emplace_back(trie.word(node), met[node]);
    return result;
  }
  WordTrie trie;
  Counts met;  ///< by node
};

/// One way of matching n expressions.
struct Contender {
  std::string name;
  double compile_seconds = 0;
  std::function<void(std::size_t first, std::size_t last, const std::vector<Flight>&)> run;
  std::function<Counts()> counts;
  std::vector<double> times;  ///< by portion, seconds
};

}  // namespace

int main(int argc, char** argv) try {
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000'000;
  const std::size_t portion = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 100'000;
  if (count == 0 || portion == 0) {
    fmt::print(stderr, "usage: matching [WORDS [PORTION]]\n");
    return 2;
  }
  const Words words = bench::random_walks(count, 1);
  std::string bytes(words.from_light.size(), '\0');
  std::transform(words.from_light.begin(), words.from_light.end(), bytes.begin(), byte);
  const double events = static_cast<double>(words.from_eye.size() - 2 * count);
  fmt::print("{} words, {:.2f} events each\n", count, events / static_cast<double>(count));

  const std::vector<std::string> expressions = bench::everyday_expressions();
  std::vector<std::string> patterns;
  for (const std::string& expression : expressions) patterns.push_back(pattern(expression));

  const std::vector<bench::EngineKind> kinds = bench::engine_kinds();
  for (const bench::EngineKind& kind : kinds)
    if (!kind.compile) fmt::print("{} is not installed and is skipped\n", kind.name);

  // Contenders of each number of expressions; the counters of all must agree in the end.
  std::vector<std::vector<Contender>> races;
  for (const std::size_t n : kExpressionCounts) {
    std::vector<Contender> race;
    std::unique_ptr<Classifier> classifier;
    const double compile_seconds = seconds([&] {
      std::vector<Language> languages;
      for (std::size_t i = 0; i < n; ++i) languages.push_back(compile(expressions[i]));
      classifier = std::make_unique<Classifier>(languages, WalkFrom::Eye);
    });
    fmt::print("{} expressions: {} states in {} {}, {:.0f} KiB\n", n, classifier->state_count(),
               classifier->group_count(), classifier->group_count() == 1 ? "group" : "groups",
               static_cast<double>(classifier->table_bytes()) / 1024);
    const auto ours = std::make_shared<Ours>(std::move(classifier));
    race.push_back({"in flight",
                    compile_seconds,
                    [ours](std::size_t, std::size_t, const std::vector<Flight>& flights) { ours->fly(flights); },
                    [ours] { return ours->in_flight.counts(); },
                    {}});
    race.push_back(
        {"path by path",
         compile_seconds,
         [ours, &words](std::size_t first, std::size_t last, const auto&) { ours->walk(words, first, last); },
         [ours] { return ours->by_path.counts(); },
         {}});
    for (const bench::EngineKind& kind : kinds) {
      if (!kind.compile) continue;
      std::shared_ptr<bench::Engine> engine;
      const double seconds_to_compile = seconds([&] {
        engine = kind.compile({patterns.begin(), patterns.begin() + static_cast<std::ptrdiff_t>(n)});
      });
      const auto counted = std::make_shared<Counts>(n);
      race.push_back({std::string(kind.name),
                      seconds_to_compile,
                      [engine, counted, &words, &bytes](std::size_t first, std::size_t last, const auto&) {
                        engine->count(bytes.data(), std::span(words.begin).subspan(first, last - first + 1), *counted);
                      },
                      [counted] { return *counted; },
                      {}});
    }
    races.push_back(std::move(race));
  }

  Distinct distinct;
  std::vector<double> reading, interning;
  std::uint64_t checksum = 0;
  for (std::size_t first = 0; first < count; first += portion) {
    const std::size_t last = std::min(count, first + portion);
    const std::vector<Flight> flights = take_off(words, first, last);
    const auto per_path = [&](double time) { return 1e9 * time / static_cast<double>(last - first); };
    reading.push_back(per_path(seconds([&] { checksum ^= read_only(words, first, last); })));
    interning.push_back(per_path(seconds([&] { distinct.walk(words, first, last); })));
    for (std::vector<Contender>& race : races)
      for (Contender& contender : race)
        contender.times.push_back(per_path(seconds([&] { contender.run(first, last, flights); })));
  }

  const auto distinct_words = distinct.words();
  std::vector<std::uint64_t> by_count;
  for (const auto& [word, met] : distinct_words) by_count.push_back(met);
  std::sort(by_count.rbegin(), by_count.rend());
  const auto top =
      std::accumulate(by_count.begin(),
                      by_count.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(400, by_count.size())), 0.0);
  fmt::print("{} distinct words, the commonest 400 are {:.1f} % (checksum {})\n", distinct_words.size(),
             100 * top / static_cast<double>(count), checksum % 1000);

  fmt::print("\n{:<24}{:>10}{:>10}{:>10}{:>12}{:>14}\n", "", "ns/step", "ns/event", "ns/path", "x in flight",
             "compile, ms");
  const double events_per_path = events / static_cast<double>(count);
  const auto row = [&](const std::string& name, double ns_per_path) {
    fmt::print("{:<24}{:>10.2f}{:>10.2f}{:>10.1f}", name, ns_per_path / (events_per_path + 1),
               ns_per_path / events_per_path, ns_per_path);
  };
  row("reading only", median(reading));
  fmt::print("\n");
  row("carrying words", median(interning));
  fmt::print("\n");
  bool is_agreed = true;
  for (std::size_t r = 0; r < races.size(); ++r) {
    const std::size_t n = kExpressionCounts[r];
    const Counts expected = races[r][0].counts();
    fmt::print("{} expressions, {:.2f} matches per path\n", n,
               static_cast<double>(std::accumulate(expected.begin(), expected.end(), std::uint64_t{0})) /
                   static_cast<double>(count));
    const double base = median(races[r][0].times);
    for (const Contender& contender : races[r]) {
      const double time = median(contender.times);
      row("  " + contender.name, time);
      fmt::print("{:>12.1f}{:>14.2f}\n", time / base, 1e3 * contender.compile_seconds);
      if (contender.counts() == expected) continue;
      fmt::print(stderr, "{} counts other matches than {}\n", contender.name, races[r][0].name);
      is_agreed = false;
    }
    std::vector<Language> languages;
    for (std::size_t i = 0; i < n; ++i) languages.push_back(compile(expressions[i]));
    const Classifier classifier(languages);
    Counts by_word(n);
    const double time = seconds([&] {
      for (const auto& [word, met] : distinct_words) {
        const Membership membership = classifier.classify(word);
        for (std::size_t i = 0; i < n; ++i)
          if (membership[i]) by_word[i] += met;
      }
    });
    fmt::print("  distinct words, once each: {:.1f} ms, {:.2f} ns per path\n", 1e3 * time,
               1e9 * time / static_cast<double>(count));
    if (by_word != expected) {
      fmt::print(stderr, "distinct words count other matches than {}\n", races[r][0].name);
      is_agreed = false;
    }
  }
  return is_agreed ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
