// Questions about languages against slow twins that know nothing of automata: a language is there the set of its short
// words, found by backtracking, and every answer is found by going through all of them. All expressions are tried up to
// a size at which no two languages differ on long words only.

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/classifier.h>
#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/identification.h>
#include <heckbert/taxonomy/lattice.h>
#include <heckbert/taxonomy/partition.h>
#include <heckbert/taxonomy/possible.h>
#include <heckbert/taxonomy/spectrum.h>
#include <heckbert/taxonomy/strategies.h>

#include "oracle/regex.h"

namespace heckbert::taxonomy {
namespace {

using Set = std::vector<bool>;  // by place in the list of words

Word word_of(std::string_view events, Symbol light = Symbol::La, Symbol eye = Symbol::Ep) {
  Word word = parse_word("L" + std::string(events) + "E");
  word.light = light;
  word.eye = eye;
  return word;
}

/// A language and what the matcher says of it.
struct Twin {
  std::string text;
  Language language;
  Set words;
};

struct Sample {
  std::vector<std::string> words;  ///< between the ends, in the order of Word
  std::vector<Twin> languages;     ///< different ones
};

// The languages of all expressions of up to five nodes over D and S, and all words of up to seven scatterings.
const Sample& sample() {
  static const Sample made = [] {
    Sample s{oracle::all_words(7, "DS"), {}};
    std::set<Set> known;
    for (std::size_t nodes = 1; nodes <= 5; ++nodes)
      for (const auto& regex : oracle::all_of_size(nodes, "DS")) {
        Twin twin{"L(" + oracle::print(*regex) + ")E", {}, {}};
        for (const std::string& word : s.words) twin.words.push_back(oracle::matches(*regex, word));
        if (!known.insert(twin.words).second) continue;
        twin.language = compile(twin.text);
        s.languages.push_back(std::move(twin));
      }
    return s;
  }();
  return made;
}

/// The first word for which `is_member(place)` holds.
template <class Predicate>
std::optional<Word> first(Predicate is_member) {
  for (std::size_t i = 0; i < sample().words.size(); ++i)
    if (is_member(i)) return word_of(sample().words[i]);
  return std::nullopt;
}

TEST(Twin, EqualLanguagesAreThoseWithTheSameWords) {
  const Sample& s = sample();
  ASSERT_GT(s.languages.size(), 60u);
  ASSERT_TRUE(std::is_sorted(s.words.begin(), s.words.end(),
                             [](const std::string& a, const std::string& b) { return word_of(a) < word_of(b); }));
  for (std::size_t nodes = 1; nodes <= 5; ++nodes)
    for (const auto& regex : oracle::all_of_size(nodes, "DS")) {
      const Language language = compile("L(" + oracle::print(*regex) + ")E");
      Set words;
      for (const std::string& word : s.words) words.push_back(oracle::matches(*regex, word));
      for (const Twin& twin : s.languages)
        ASSERT_EQ(language == twin.language, words == twin.words) << oracle::print(*regex) << " and " << twin.text;
    }
}

TEST(Twin, InclusionDisjointnessAndWitnessesAreThoseOfTheSets) {
  const Sample& s = sample();
  std::size_t included = 0, disjoint = 0;
  for (const Twin& a : s.languages) {
    ASSERT_EQ(a.language.shortest_word(), first([&](std::size_t i) { return a.words[i]; })) << a.text;
    for (const Twin& b : s.languages) {
      const auto outside = first([&](std::size_t i) { return a.words[i] && !b.words[i]; });
      const auto shared = first([&](std::size_t i) { return a.words[i] && b.words[i]; });
      included += !outside;
      disjoint += !shared;
      ASSERT_EQ(a.language.is_subset_of(b.language), !outside) << a.text << " in " << b.text;
      ASSERT_EQ(witness_outside(a.language, b.language), outside) << a.text << " outside " << b.text;
      ASSERT_EQ((a.language & b.language).shortest_word(), shared) << a.text << " and " << b.text;
    }
  }
  EXPECT_GT(included, 500u);
  EXPECT_GT(disjoint, 200u);
}

TEST(Twin, PartitionsAreThoseOfTheSets) {
  const Sample& s = sample();
  const std::size_t n = s.languages.size();
  std::size_t partitions = 0;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      // A third one and a whole, each of them at every place now and then.
      const std::vector<const Twin*> classes{&s.languages[a], &s.languages[b], &s.languages[(3 * a + 5 * b) % n]};
      const Twin& whole = s.languages[(7 * a + b) % n];
      std::vector<Language> languages;
      for (const Twin* twin : classes) languages.push_back(twin->language);
      const Partition found = partition(languages, whole.language);
      std::size_t overlaps = 0;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i + 1; j < 3; ++j) {
          const auto shared =
              first([&](std::size_t w) { return classes[i]->words[w] && classes[j]->words[w] && whole.words[w]; });
          if (!shared) continue;
          ++overlaps;
          const auto listed = std::find_if(found.overlaps.begin(), found.overlaps.end(),
                                           [&](const Overlap& o) { return o.first == i && o.second == j; });
          ASSERT_NE(listed, found.overlaps.end());
          ASSERT_EQ(listed->shortest, *shared);
        }
      ASSERT_EQ(found.overlaps.size(), overlaps);
      const auto gap = first([&](std::size_t w) {
        return whole.words[w] &&
               std::none_of(classes.begin(), classes.end(), [&](const Twin* twin) { return twin->words[w]; });
      });
      ASSERT_EQ(found.gap, gap) << classes[0]->text << ", " << classes[1]->text << " of " << whole.text;
      partitions += found.is_disjoint() && found.is_exhaustive();
    }
  EXPECT_GT(partitions, 10u);
}

TEST(Twin, ClassifiersSayWhatTheMatcherSays) {
  const Sample& s = sample();
  std::vector<Language> languages;
  for (const Twin& twin : s.languages) languages.push_back(twin.language);
  for (const std::size_t budget : {kStateBudget, std::size_t{30}}) {
    const Classifier classifier(languages, WalkFrom::Light, budget);
    EXPECT_EQ(classifier.group_count() == 1, budget == kStateBudget);
    for (std::size_t w = 0; w < s.words.size(); ++w) {
      const Membership membership = classifier.classify(word_of(s.words[w]));
      for (std::size_t k = 0; k < languages.size(); ++k)
        ASSERT_EQ(membership[k], s.languages[k].words[w]) << s.languages[k].text << " on " << s.words[w];
    }
  }
}

TEST(Twin, ReversedLanguagesHoldTheStringsTurnedRound) {
  for (const Twin& twin : sample().languages) {
    const Language turned = reverse(twin.language);
    for (std::size_t i = 0; i < sample().words.size(); ++i) {
      const Word word = word_of(sample().words[i]);
      std::vector<Symbol> string{word.eye};
      string.insert(string.end(), word.events.rbegin(), word.events.rend());
      string.push_back(word.light);
      ASSERT_EQ(turned.contains(string), twin.words[i]) << twin.text << " on " << plain(word);
    }
  }
}

TEST(Twin, InverseImagesHoldTheWordsWhoseImageBelongs) {
  // Every event to one of D and S, all ways to do so for four of them.
  const std::vector<Symbol> letters{Symbol::Dr, Symbol::Dt, Symbol::Gr, Symbol::Sr};
  const std::map<Symbol, char> code{{letters[0], 'a'}, {letters[1], 'b'}, {letters[2], 'c'}, {letters[3], 'd'}};
  const auto words = oracle::all_words(4, "abcd");
  const std::map<std::string, std::size_t> place = [] {
    std::map<std::string, std::size_t> map;
    for (std::size_t i = 0; i < sample().words.size(); ++i) map[sample().words[i]] = i;
    return map;
  }();
  for (unsigned bits = 0; bits < 16; ++bits) {
    std::array<Symbol, kSymbolCount> h{};
    for (const SymbolFacts& f : kSymbols) h[index(f.symbol)] = f.symbol;
    std::map<char, char> image;
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const bool is_diffuse = (bits >> i & 1u) != 0;
      h[index(letters[i])] = is_diffuse ? Symbol::Dr : Symbol::St;
      image[code.at(letters[i])] = is_diffuse ? 'D' : 'S';
    }
    for (std::size_t k = bits % 3; k < sample().languages.size(); k += 3) {
      const Twin& twin = sample().languages[k];
      const Language found = inverse_image(twin.language, h);
      for (const std::string& word : words) {
        Word fine_word{Symbol::La, {}, Symbol::Ep};
        std::string mapped;
        for (const char c : word) {
          fine_word.events.push_back(letters[static_cast<std::size_t>(c - 'a')]);
          mapped += image.at(c);
        }
        ASSERT_EQ(found.contains(fine_word), twin.words[place.at(mapped)]) << twin.text << " on " << fine(fine_word);
      }
    }
  }
}

TEST(Twin, ExplanationsEndWithTheLongestBeginningOfAMember) {
  for (std::size_t nodes = 1; nodes <= 3; ++nodes)
    for (const auto& regex : oracle::all_of_size(nodes, "DSG")) {
      const std::string text = "L(" + oracle::print(*regex) + ")E";
      const Language language = compile(text);
      std::set<std::string> beginnings;
      for (const std::string& word : oracle::all_words(7, "DSG")) {
        if (!oracle::matches(*regex, word)) continue;
        const std::string whole = "L" + word + "E";
        for (std::size_t n = 0; n <= whole.size(); ++n) beginnings.insert(whole.substr(0, n));
      }
      for (const std::string& word : oracle::all_words(4, "DSGV")) {
        const std::string whole = "L" + word + "E";
        std::size_t read = whole.size();
        while (!beginnings.contains(whole.substr(0, read))) --read;
        const Explanation e = explain(language, word_of(word));
        ASSERT_EQ(e.letters_read, read) << text << " on " << whole;
        ASSERT_EQ(e.matches, read == whole.size()) << text << " on " << whole;
        SymbolSet expected = 0;
        if (!e.matches)
          for (const char c : std::string_view("LDGSVE"))
            if (beginnings.contains(whole.substr(0, read) + c))
              expected = static_cast<SymbolSet>(expected | with_letter(c));
        ASSERT_EQ(e.expected, expected) << text << " on " << whole;
        ASSERT_EQ(e.culprit.has_value(), !e.matches);
        ASSERT_TRUE(e.matches || facts(e.culprit->symbol).letter == whole[read]);
        const auto steps = trace(language, word_of(word));
        ASSERT_EQ(steps.size(), std::min(read + 1, whole.size())) << text << " on " << whole;
      }
    }
}

TEST(Twin, ALanguageCanMatchWhenOneOfItsWordsMeetsTheConditions) {
  struct Ends {
    const char* light;
    const char* eye;
    SymbolSet lights, eyes;
  };
  const Ends all_ends[] = {{"L", "E", kLights, kEyes}, {"Lp", "El", single(Symbol::Lp), single(Symbol::El)}};
  const SymbolSet scattering[] = {kEvents, with_letter('D'), with_letter('S'), single(Symbol::Dt), SymbolSet{0}};
  std::size_t never = 0;
  for (const Ends& ends : all_ends)
    for (std::size_t nodes = 1; nodes <= 3; ++nodes)
      for (const auto& regex : oracle::all_of_size(nodes, "DS")) {
        const std::string text = ends.light + ("(" + oracle::print(*regex)) + ")" + ends.eye;
        const Language language = compile(text);
        for (const SymbolSet lights : {kLights, single(Symbol::La), single(Symbol::Lp)})
          for (const SymbolSet eyes : {kEyes, single(Symbol::Ep)})
            for (const SymbolSet events : scattering)
              for (const std::size_t depth : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{9}}) {
                const bool possible =
                    (ends.lights & lights) != 0 && (ends.eyes & eyes) != 0 &&
                    std::any_of(sample().words.begin(), sample().words.end(), [&](const std::string& w) {
                      return w.size() <= depth && oracle::matches(*regex, w) &&
                             std::all_of(w.begin(), w.end(), [&](char c) { return (with_letter(c) & events) != 0; });
                    });
                const Conditions conditions{.lights = lights, .events = events, .eyes = eyes, .max_length = depth};
                ASSERT_EQ(why_never(language, conditions).has_value(), !possible) << text << " at depth " << depth;
                never += !possible;
              }
      }
  EXPECT_GT(never, 500u);
}

TEST(Twin, LatticeJoinsTheNeighboursOfTheSets) {
  const std::vector<Twin>& languages = sample().languages;
  std::vector<NamedLanguage> named;
  for (std::size_t i = 0; i < languages.size(); ++i) {
    named.push_back({std::to_string(i), languages[i].language});
    // Equal languages under several names are one node.
    if (i % 10 == 0) named.push_back({std::to_string(i), languages[i].language});
  }
  const auto is_below = [&](std::size_t a, std::size_t b) {
    for (std::size_t w = 0; w < languages[a].words.size(); ++w)
      if (languages[a].words[w] && !languages[b].words[w]) return false;
    return a != b;
  };
  std::vector<std::vector<bool>> below(languages.size(), std::vector<bool>(languages.size()));
  for (std::size_t a = 0; a < languages.size(); ++a)
    for (std::size_t b = 0; b < languages.size(); ++b) below[a][b] = is_below(a, b);
  std::map<std::pair<std::size_t, std::size_t>, Word> expected;
  for (std::size_t a = 0; a < languages.size(); ++a)
    for (std::size_t b = 0; b < languages.size(); ++b) {
      bool is_neighbour = below[a][b];
      for (std::size_t c = 0; c < languages.size(); ++c) is_neighbour = is_neighbour && !(below[a][c] && below[c][b]);
      if (is_neighbour)
        expected[{a, b}] = *first([&](std::size_t w) { return languages[b].words[w] && !languages[a].words[w]; });
    }
  // The longest chain below, by going down every one.
  std::map<std::size_t, std::size_t> heights;
  const std::function<std::size_t(std::size_t)> height = [&](std::size_t b) {
    if (const auto known = heights.find(b); known != heights.end()) return known->second;
    std::size_t most = 0;
    for (std::size_t a = 0; a < languages.size(); ++a)
      if (below[a][b]) most = std::max(most, height(a) + 1);
    return heights[b] = most;
  };

  const Lattice found = lattice(named);
  ASSERT_EQ(found.nodes.size(), languages.size());
  std::vector<std::size_t> place;  // in `languages`, of each node
  for (const LatticeNode& node : found.nodes) {
    place.push_back(std::stoul(node.names.front()));
    ASSERT_EQ(node.names.size(), place.back() % 10 == 0 ? 2u : 1u);
    ASSERT_EQ(node.level, height(place.back())) << languages[place.back()].text;
  }
  ASSERT_EQ(found.edges.size(), expected.size());
  for (const LatticeEdge& edge : found.edges) {
    const auto at = expected.find({place[edge.below], place[edge.above]});
    ASSERT_NE(at, expected.end());
    ASSERT_EQ(edge.witness, at->second);
  }
}

// The rule by cases, from what can be sampled: s vertices are chosen from the light, t from the eye.
bool finds(const Word& word, std::size_t s, std::size_t t) {
  const auto is_mirror = [&](std::size_t vertex) {  // 1 .. n, counted from the light
    return facts(word.events[vertex - 1]).letter == 'S';
  };
  if (s == 0) return word.light == Symbol::La || word.light == Symbol::Le;  // an eye path must hit the light
  if (t == 0) return word.eye == Symbol::El;                                // a light path must hit the lens
  // A connection between the last vertex of each side: neither may be a mirror, and lights and eyes never are.
  return (s == 1 || !is_mirror(s - 1)) && (t == 1 || !is_mirror(s));
}

TEST(Twin, StrategiesAreTheConnectionsThatNoMirrorForbids) {
  for (const std::string& events : oracle::all_words(5, "DSGV"))
    for (const Symbol light : members(kLights))
      for (const Symbol eye : members(kEyes)) {
        const Word word = word_of(events, light, eye);
        const auto found = strategies(word);
        for (std::size_t s = 0; s <= events.size() + 2; ++s) {
          const std::size_t t = events.size() + 2 - s;
          const bool listed = std::any_of(found.begin(), found.end(), [&](const Strategy& x) {
            return x.light_vertices == s && x.eye_vertices == t;
          });
          ASSERT_EQ(listed, finds(word, s, t)) << fine(word) << " (" << s << ", " << t << ")";
        }
      }
}

TEST(Twin, SpectrumIsTheSumOverTheWords) {
  SymbolWeights weights{};
  weights[index(Symbol::La)] = 2;
  weights[index(Symbol::Ep)] = 3;
  weights[index(Symbol::Dr)] = 0.5;
  weights[index(Symbol::Sr)] = 0.25;
  for (const Twin& twin : sample().languages) {
    std::vector<double> expected(8);
    for (std::size_t i = 0; i < sample().words.size(); ++i) {
      if (!twin.words[i]) continue;
      double product = 6;
      for (const char c : sample().words[i]) product *= c == 'D' ? 0.5 : 0.25;
      expected[sample().words[i].size()] += product;
    }
    ASSERT_EQ(length_spectrum(twin.language, weights, 7), expected) << twin.text;  // powers of two: exact
  }
}

// Identification over sets of words with both kinds of lights and eyes.
struct Library {
  GrammarLibrary grammars;
  std::vector<Word> words;

  Library() {
    const auto file = [](const std::string& name, const std::string& hit, const std::string& delta) {
      const bool is_class = delta.empty();
      return std::string("kind: ") + (is_class ? "class" : "algorithm") + "\nname: " + name + "\ntitle: " + name +
             "\norder: 1\nsource: this test\nexpression: " + hit + "\n" +
             (is_class ? "" : "expression-delta: " + delta + "\n");
    };
    const std::vector<std::string> texts{
        file("hits", "LX*E", "none"),      file("whitted", "LN?S*E", "LNS*E"),
        file("radiosity", "LD*E", "LD+E"), file("lens", "LD*El", ""),
        file("caustics", "LS+DE", ""),     file("points", "LpDS*E", ""),
        file("first", "LD?E | LpSE", ""),  file("two", "LXXE", ""),
        file("direct", "LDE", "LDE"),      file("mirrors", "LS*E", "LS+DSE"),
        file("again", "LD*E", "LDD*E"),
    };
    std::vector<GrammarText> files;
    for (const std::string& text : texts) files.push_back({"library", text});
    grammars = read_grammars(files);
    for (const std::string& events : oracle::all_words(4, "DGS"))
      for (const Symbol light : {Symbol::La, Symbol::Lp})
        for (const Symbol eye : members(kEyes)) words.push_back(word_of(events, light, eye));
    std::sort(words.begin(), words.end());
  }
};

struct Form {
  const Grammar* grammar;
  LightForm form;
  Set words;
};

TEST(Twin, IdentificationComparesTheSets) {
  const Library library;
  const auto none = [](const Set& set) { return std::none_of(set.begin(), set.end(), [](bool b) { return b; }); };
  const auto is_part = [](const Set& a, const Set& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] && !b[i]) return false;
    return true;
  };
  std::vector<Form> forms;
  for (const Grammar& g : library.grammars.grammars) {
    std::vector<Form> of_one;
    for (const LightForm form : {LightForm::AsWritten, LightForm::Hit, LightForm::Delta}) {
      Set set;
      for (Word word : library.words) {
        if (form != LightForm::AsWritten) word.light = form == LightForm::Hit ? Symbol::La : Symbol::Lp;
        set.push_back(g.language.contains(word));
      }
      const bool is_new =
          std::none_of(of_one.begin(), of_one.end(), [&](const Form& other) { return other.words == set; });
      if (is_new && !none(set)) of_one.push_back({&g, form, set});
    }
    forms.insert(forms.end(), of_one.begin(), of_one.end());
  }

  std::size_t same = 0, restricted = 0, neighbours = 0;
  for (const auto& [light, eye] : {std::pair{"L", "E"}, {"Lp", "E"}, {"La", "El"}})
    for (std::size_t nodes = 1; nodes <= 3; ++nodes)
      for (const auto& regex : oracle::all_of_size(nodes, "DSG")) {
        const std::string text = std::string(light) + "(" + oracle::print(*regex) + ")" + eye;
        const Language language = compile(text);
        Set asked;
        unsigned used = 0;
        for (const Word& word : library.words) {
          asked.push_back(language.contains(word));
          if (!asked.back()) continue;
          used |= with_letter('L') & (light[1] == 0 ? kLights : single(word.light));
          used |= single(word.eye);
          for (const Symbol s : word.events) used |= with_letter(facts(s).letter);
        }
        const Identification found = identify(language, library.grammars);

        // As it is; with the ends that it has; with the ends and events that it has.
        std::vector<std::pair<std::string, LightForm>> expected;
        const unsigned ends = used & ~unsigned{kEvents};
        for (const unsigned within : {unsigned{kLights | kEvents | kEyes}, ends | kEvents, used}) {
          if ((within & kEvents) == 0) break;
          for (const Form& f : forms) {
            Set kept = f.words;
            for (std::size_t i = 0; i < kept.size(); ++i) {
              const Word& word = library.words[i];
              unsigned letters = single(word.light) | single(word.eye);
              for (const Symbol s : word.events) letters |= single(s);
              if ((letters & ~within) != 0) kept[i] = false;
            }
            const bool is_listed = std::any_of(expected.begin(), expected.end(),
                                               [&](const auto& e) { return e.first == f.grammar->name; });
            if (!is_listed && kept == asked) expected.emplace_back(f.grammar->name, f.form);
          }
          if (!expected.empty()) {
            for (const Match& m : found.same)
              ASSERT_EQ(m.within, within == (kLights | kEvents | kEyes) ? 0u : within) << text;
            break;
          }
        }
        std::vector<std::pair<std::string, LightForm>> named;
        for (const Match& m : found.same) {
          named.emplace_back(m.grammar->name, m.form);
          restricted += m.within != 0;
        }
        ASSERT_EQ(named, expected) << text;
        same += !named.empty();
        if (!named.empty()) continue;

        for (const bool above : {true, false}) {
          const auto is_related = [&](const Form& f) {
            return above ? is_part(asked, f.words) : is_part(f.words, asked);
          };
          const auto& listed = above ? found.containing : found.contained;
          std::size_t nearest = 0;
          for (std::size_t k = 0; k < forms.size(); ++k) {
            if (!is_related(forms[k])) continue;
            bool is_nearest = true;
            for (std::size_t other = 0; other < forms.size(); ++other) {
              if (!is_related(forms[other]) || other == k) continue;
              const Set &mine = forms[k].words, &theirs = forms[other].words;
              if (mine == theirs)
                is_nearest = is_nearest && k < other;
              else
                is_nearest = is_nearest && !(above ? is_part(theirs, mine) : is_part(mine, theirs));
            }
            if (!is_nearest) continue;
            ASSERT_LT(nearest, listed.size()) << text;
            const Neighbour& n = listed[nearest++];
            ASSERT_EQ(std::pair(n.grammar->name, n.form), std::pair(forms[k].grammar->name, forms[k].form)) << text;
            for (std::size_t i = 0; i < asked.size(); ++i)
              if (asked[i] != forms[k].words[i]) {
                ASSERT_EQ(n.witness, library.words[i]) << text;
                break;
              }
          }
          ASSERT_EQ(listed.size(), nearest) << text;
          neighbours += nearest;
        }
      }
  EXPECT_GT(same, 10u);
  EXPECT_GT(restricted, 3u);
  EXPECT_GT(neighbours, 50u);
}

}  // namespace
}  // namespace heckbert::taxonomy
