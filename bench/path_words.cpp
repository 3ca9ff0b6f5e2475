#include "path_words.h"

#include <array>
#include <random>

#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/simplest.h>

namespace bench {

namespace {

using namespace heckbert;

/// What a walk does after one event: how likely it is to end at a light there, and otherwise what it meets.
struct Habit {
  Symbol after;
  double ends;
  std::array<double, 7> meets;  ///< weights of Dr Dt Gr Gt Sr St V
};

constexpr std::array<Habit, 8> kHabits{{
    //                 Dr    Dt     Gr     Gt      Sr     St     V
    {Symbol::Ep, .02, {.80, .002, .06, .001, .05, .08, .002}},
    {Symbol::Dr, .19, {.965, .0003, .010, .0002, .010, .014, .0003}},
    {Symbol::Dt, .20, {.97, .01, .01, .00, .00, .01, .00}},
    {Symbol::Gr, .20, {.955, .001, .02, .0005, .010, .013, .0005}},
    {Symbol::Gt, .05, {.10, .00, .05, .85, .00, .00, .00}},
    {Symbol::Sr, .10, {.93, .001, .01, .00, .02, .038, .001}},
    {Symbol::St, .05, {.44, .0005, .01, .00, .02, .5295, .0005}},
    {Symbol::V, .30, {.65, .00, .02, .00, .00, .08, .25}},
}};

constexpr std::size_t kMostEvents = 16;

/// A number in [0, 1), the same on every platform.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// An index drawn by weight.
template <std::size_t N>
std::size_t draw(const std::array<double, N>& weights, std::mt19937_64& random) {
  double total = 0;
  for (const double w : weights) total += w;
  double rest = uniform(random) * total;
  std::size_t i = 0;
  while (i + 1 < N && rest >= weights[i]) rest -= weights[i++];
  return i;
}

const Habit& habit_after(Symbol event) {
  for (const Habit& habit : kHabits)
    if (habit.after == event) return habit;
  return kHabits[0];
}

}  // namespace

Words random_walks(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Words words;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Symbol> walk{Symbol::Ep};
    while (walk.size() <= kMostEvents) {
      const Habit& habit = habit_after(walk.back());
      if (uniform(random) < habit.ends) break;
      walk.push_back(static_cast<Symbol>(taxonomy::index(Symbol::Dr) + draw(habit.meets, random)));
    }
    walk.push_back(uniform(random) < .93 ? Symbol::La : Symbol::Le);
    words.from_eye.insert(words.from_eye.end(), walk.begin(), walk.end());
    words.from_light.insert(words.from_light.end(), walk.rbegin(), walk.rend());
    words.begin.push_back(words.from_eye.size());
  }
  return words;
}

std::vector<std::string> everyday_expressions() {
  std::vector<std::string> all;
  const taxonomy::GrammarLibrary& library = taxonomy::builtin_grammars();
  std::vector<taxonomy::Language> seen;
  const auto add_grammars = [&](auto is_wanted) {
    for (const taxonomy::Grammar& grammar : library.grammars) {
      if (!is_wanted(grammar) || !has_language(grammar)) continue;
      bool is_new = true;
      for (const taxonomy::Language& language : seen) is_new = is_new && language != grammar.language;
      if (!is_new) continue;
      if (const auto expression = taxonomy::simplest_expression(grammar.language)) {
        seen.push_back(grammar.language);
        all.push_back(*expression);
      }
    }
  };
  add_grammars([](const taxonomy::Grammar& g) { return g.is_core; });
  add_grammars([](const taxonomy::Grammar& g) { return !g.is_core; });

  // What light path expressions are asked for: direct and indirect by lobe, transmission, mirrors seen in mirrors.
  for (const char* text : {
           "L D E",           "L G E",     "L S E",       "L V E",     "L .+ D E", "L .+ G E",         "L .+ S E",
           "L .+ V E",        "L .* Sr E", "L .* St E",   "L D+ S+ E", "L S S E",  "L [DG]+ E",        "L .* St St E",
           "L .* Dt .* E",    "L V+ E",    "L .* V .* E", "L S+ D+ E", "L S+ V E", "L .* D S+ D .* E", "L St+ D St* E",
           "L .* Gr Gr .* E", "Le .* E",   "La .* E",     "L [GS]+ E", "L Dr+ E",  "L .* G S E",       "L N N E",
           "L D G E",         "L G D E",   "L .? S+ E",   "L X{2} E",
       })
    all.emplace_back(text);
  const std::array<const char*, 7> lobes{"Dr", "Dt", "Gr", "Gt", "Sr", "St", "V"};
  for (const char* light : {"La", "Le"})
    for (const char* lobe : lobes) all.push_back(std::string(light) + " .* " + lobe + " E");
  for (int least = 0; least < 6; ++least)
    for (int most = least + 1; most < least + 5; ++most)
      all.push_back("L .{" + std::to_string(least) + "," + std::to_string(most) + "} E");
  for (const char* at_light : lobes)
    for (const char* at_eye : lobes) all.push_back(std::string("L ") + at_light + " .* " + at_eye + " E");
  for (const char* first : lobes)
    for (const char* second : lobes) all.push_back(std::string("L .* ") + first + " " + second + " E");
  for (const char* letter : {"D", "G", "S", "V"})
    for (int times = 1; times < 16; ++times) {
      const std::string others = std::string("[^") + letter + "]*";
      all.push_back("L " + others + "(" + letter + " " + others + "){" + std::to_string(times) + "} E");
    }
  all.resize(256);
  return all;
}

}  // namespace bench
