#include <taxonomy/hostile_expressions.h>

#include <algorithm>
#include <functional>

namespace heckbert::taxonomy {

namespace {

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

/// As often as it fits, with what goes before and after.
std::string filled(const std::string& before, const std::string& text, const std::string& after) {
  return before + repeated(text, (kLongestHostile - before.size() - after.size()) / text.size()) + after;
}

/// Piece after piece as long as they fit.
std::string filled_with(const std::string& before, const std::string& between, const std::string& after,
                        const std::function<std::string(std::size_t)>& piece) {
  std::string result = before + piece(0);
  for (std::size_t i = 1;; ++i) {
    const std::string next = between + piece(i);
    if (result.size() + next.size() + after.size() > kLongestHostile) return result + after;
    result += next;
  }
}

std::string letters(std::mt19937_64& random, std::size_t count, const std::string& of) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += of[random() % of.size()];
  return result;
}

std::string number(std::size_t n) {
  return std::to_string(n);
}

std::vector<Hostile> native() {
  std::mt19937_64 random(7);
  std::vector<Hostile> all{
      {"nullable counts in counts", "L((X?){1000}){1000}E"},
      {"counts in counts", "L((X{1,9}){1,90}){1,900}E"},
      {"three counts in counts", "L(((X?){30}){30}){30}E"},
      {"starred counts", "L((X*){1000}){1000}E"},
      {"a choice long ago", "L .*D.{30} E"},
      {"a choice long ago, in ends", "L(.*D.{30})E"},
      {"a choice just too long ago", "L.*D.{14}E"},
      {"a choice just not too long ago", "L.*D.{12}E"},
      {"choices within choices", "L(.*D.{9}(.*G.{9}(.*S.{9})))E"},
      {"two choices", "L.*D.{7}E & L.*G.{7}E"},
      {"three choices united", "L.*D.{6}E | L.*G.{6}E | L.*S.{6}E"},
      {"a choice from either end", "L.{12}D.*E & L.*D.{12}E"},
      {"a repeated choice", "L(.{9}D.{9})*E"},
      {"overlapping counts", "L(D{3,9}.{0,900})*E"},
      {"coprime loops", "L((.{7})*|(.{11})*|(.{13})*|(.{17})*|(.{19})*)E"},
      {"coprime loops intersected", "L(.{97})*E & L(.{89})*E & L(.{83})*E"},
      {"coprime counts", "L((.{197}|.{199}|.{211})*)E"},
      {"a long loop beside a long loop", "L(.{9973})*E - L(.{9967})*E"},
      {"the longest count", "L.{10000}E"},
      {"the longest counts", "L.{9999}.{9999}E"},
      {"many longest counts", filled("L", ".{9999}", "E")},
      {"long optional tail", "L(.?){10000}E"},
      {"a long word", filled("L", "D", "E")},
      {"a long random word", "L" + letters(random, kLongestHostile - 2, "DGSV") + "E"},
      {"a long word of sets", filled("L", "[DG]", "E")},
      {"a long word of subscripts", filled("L", "DrStGrV", "E")},
      {"a long word of dots", filled("L", ".", "E")},
      {"a long row of options", filled("L", "D?", "E")},
      {"a long row of stars", filled("L", "D*G*", "E")},
      {"a long row of loops", filled("L", "(DG)*", "E")},
      {"a long row of choices", filled("L", "(D|GS)", "E")},
      {"a long row of small counts", filled("L", "D{0,9}", "E")},
      {"a long row of dotted counts", filled("L", ".{1,9}", "E")},
      {"many long words", filled_with("L(", "|", ")E", [&](std::size_t) { return letters(random, 40, "DGSV"); })},
      {"many words", filled_with("L(", "|", ")E", [&](std::size_t) { return letters(random, 8, "DGSV"); })},
      {"many whole words",
       filled_with("", "|", "", [&](std::size_t) { return "L" + letters(random, 7, "DGSV") + "E"; })},
      {"many starred words", filled_with("L(", "|", ")*E", [&](std::size_t) { return letters(random, 9, "DGSV"); })},
      {"many choices of middles",
       filled_with("L(", "|", ")E", [&](std::size_t) { return ".*" + letters(random, 5, "DGSV") + ".*"; })},
      {"many suffixes", filled_with("L(", "|", ")E", [&](std::size_t) { return ".*" + letters(random, 9, "DGSV"); })},
      {"many counts", filled_with("L(", "|", ")E", [](std::size_t i) { return ".{" + number(9973 - i) + "}"; })},
      {"many loops", filled_with("L(", "|", ")E", [](std::size_t i) { return "(.{" + number(2 * i + 3) + "})*"; })},
      {"deep parentheses", "L" + repeated("(", 490) + "D" + repeated(")", 490) + "E"},
      {"deep stars", "L" + repeated("(", 240) + "D" + repeated(")*", 240) + "E"},
      {"deep options", "L" + repeated("(", 240) + "D{9000}" + repeated("G?)?", 240) + "E"},
      {"deep alternatives", "L" + repeated("(.{9000}|", 240) + "D" + repeated(")", 240) + "E"},
      {"deep counts", "L" + repeated("(", 160) + "D" + repeated("{2})", 160) + "E"},
      {"deep loops", "L" + repeated("(.{99}", 240) + "D" + repeated(")*", 240) + "E"},
      {"deep complements", repeated("!", 480) + "(L.*D.{10}E)"},
      {"many intersections", filled("L.*E", "&L.*D.*E", "")},
      {"many intersections of long loops",
       filled_with("", "&", "", [](std::size_t i) { return "L(.{" + number(i + 2) + "})*E"; })},
      {"many differences", filled("L.{10000}E", "-LD*E", "").substr(0, kLongestHostile)},
      {"a large automaton, often united", filled("L.{9990}E", "|!LD*E", "")},
      {"a large automaton, often intersected", "L.{9990}.*E" + repeated("&L.*E", 490)},
      {"large automata united",
       filled_with("", "|", "", [](std::size_t i) { return "!L.{" + number(9999 - i) + "}E"; })},
      {"many labels", filled_with("L(", "|", ")E", [](std::size_t i) { return "D'" + number(i) + "'"; })},
      {"a word of many labels", filled_with("L", "", "E", [](std::size_t i) { return "D'" + number(i) + "'"; })},
      {"touching many objects", filled_with("", "|", "", [](std::size_t i) { return "L.*.'" + number(i) + "'.*E"; })},
      {"touching all of many objects",
       filled_with("", "&", "", [](std::size_t i) { return "L.*.'" + number(i) + "'.*E"; })},
      {"touching many objects, in one path",
       filled_with("L(", "|", ")*E", [](std::size_t i) { return ".*D'" + number(i) + "'"; })},
      {"one of many labels, counted",
       filled_with("L(", "|", "){9}E", [](std::size_t i) { return "D'" + number(i) + "'G"; })},
      {"a choice of labels long ago", "L .*D'a'.{12} E & L .*G'b'.{3} E"},
      {"unknown letters", filled("", "Q", "")},
      {"closing parentheses", filled("L", ")", "E")},
      {"opening parentheses", filled("L", "(", "E")},
      {"bad counts", filled("L", "D{", "E")},
      {"ends in the middle", filled("L", "E", "E")},
      {"half paths", filled("LE", "|L", "")},
      {"names of nothing", filled("@wh", "|@wh", "")},
      {"one long name", filled("@", "whitted-", "x")},
      {"open labels", filled("L", "D'", "E")},
      {"letters of another script", filled("L", "\u0415", "E")},
      {"a set of many labels", filled_with("L[^", "", "]*E", [](std::size_t i) { return "D'" + number(i) + "'"; })},
  };
  return all;
}

/// The same hardships where the dialect can say them.
std::vector<Hostile> of_dialect(const DialectFacts& dialect) {
  const bool counts = dialect.has_exact, ranges = dialect.has_range;
  std::vector<std::pair<std::string, std::string>> all{
      {"a long word", filled("C", "D", "L")},
      {"a long word of dots", filled("C", ".", "L")},
      {"a long row of stars", filled("C", "D*G*", "L")},
      {"a long row of dotted stars", filled("C", ".*D", "L")},
      {"a choice long ago, spelt", "C.*D" + repeated(".", 30) + "L"},
      {"a choice long ago, seen from the eye", "C" + repeated(".", 30) + "D.*L"},
      {"a repeated choice", "C(" + repeated(".", 9) + "D" + repeated(".", 9) + ")*L"},
      {"coprime loops", "C(" + repeated(".", 97) + ")*(" + repeated(".", 89) + ")*L"},
      {"deep parentheses", "C" + repeated("(", 490) + "D" + repeated(")", 490) + "L"},
      {"unknown letters", filled("", "Q", "")},
      {"letters that it lacks", filled("C", "GSs", "L")},
      {"closing parentheses", filled("C", ")", "L")},
      {"open groups", filled("C", "<", "L")},
      {"empty groups", filled("C", "<>", "L")},
      {"deep stars", "C" + repeated("(", 240) + "DG" + repeated(")*", 240) + "L"},
      {"deep loops", "C" + repeated("(.D", 240) + "D" + repeated(")*", 240) + "L"},
  };
  if (counts) {
    all.emplace_back("counts in counts", "C((D{100}){100}){100}L");
    all.emplace_back("a choice long ago", "C.*D.{30}L");
    all.emplace_back("the longest counts", filled("C", ".{9999}", "L"));
    all.emplace_back("deep counts", "C" + repeated("(", 160) + "D" + repeated("{2})", 160) + "L");
  }
  if (ranges) {
    all.emplace_back("nullable counts in counts", "C((D{0,1}){1000}){1000}L");
    all.emplace_back("a long row of small counts", filled("C", ".{1,9}", "L"));
  }
  if (dialect.has_groups) all.emplace_back("a long word of groups", filled("C", "<RD><T[DG]>", "L"));
  if (!dialect.bar_binds_tightest) all.emplace_back("many words", filled("C(DGD", "|DDGVDDG", ")L"));
  if (dialect.has_whole_operators) {
    all.emplace_back("many intersections", filled("C.*L", "&C.*D.*L", ""));
    all.emplace_back("many differences", filled("C.*L", "-CD*L", ""));
  }
  std::vector<Hostile> result;
  for (auto& [name, text] : all) result.push_back({std::string(dialect.name) + ": " + name, text, dialect.dialect});
  return result;
}

class RandomText {
 public:
  RandomText(const DialectFacts& dialect, std::mt19937_64& random) : dialect_(dialect), random_(random) {}

  std::string path(std::size_t length) { return dialect_.eyes.back() + piece(length, 0) + "L"; }

  std::string whole(std::size_t length) {
    if (!dialect_.has_whole_operators || length < 40 || one_in(3)) return path(length);
    const std::size_t left = 8 + below(length - 20);
    return path(left) + pick({"&", "-", "|"}) + whole(length - left);
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  std::string pick(const std::vector<std::string>& texts) { return texts[below(texts.size())]; }

  std::string piece(std::size_t length, std::size_t depth) {
    std::string text;
    while (text.empty() || text.size() < length) text += repeat(length - std::min(length, text.size()), depth);
    return text;
  }
  std::string repeat(std::size_t length, std::size_t depth) {
    std::string text = atom(length, depth);
    if (one_in(2)) return text;
    std::vector<std::string> signs{"*", "+"};
    const std::string n = number(one_in(4) ? below(2000) : below(20)), more = number(2000 + below(9));
    if (dialect_.has_optional) signs.emplace_back("?");
    if (dialect_.has_exact) signs.push_back("{" + n + "}");
    if (dialect_.has_open) signs.push_back("{" + n + ",}");
    if (dialect_.has_range) signs.insert(signs.end(), {"{0," + n + "}", "{" + n + "," + more + "}", "{0,1}"});
    return text + pick(signs);
  }
  std::string atom(std::size_t length, std::size_t depth) {
    if (length < 8 || depth > 60 || one_in(3)) return letter();
    const std::size_t inner = 1 + below(std::max<std::size_t>(1, length - 4));
    if (dialect_.bar_binds_tightest || one_in(2)) return "(" + piece(inner, depth + 1) + ")";
    const std::size_t left = 1 + below(inner);
    return "(" + piece(left, depth + 1) + "|" + piece(inner - left + 1, depth + 1) + ")";
  }
  std::string letter() {
    std::vector<std::string> known{".", ".", "V", "D", "[DV]", "[^D]"};
    for (const KindLetter& kind : dialect_.kinds)
      if (kind.letter != 0) known.emplace_back(1, kind.letter);
    if (dialect_.has_groups) known.insert(known.end(), {"<RD>", "<TD'a'>", "<.D>"});
    if (dialect_.dialect == Dialect::Heckbert) known.insert(known.end(), {"D'a'", "G'b'", "[^'a']", "St", "N", "X"});
    return pick(known);
  }

  const DialectFacts& dialect_;
  std::mt19937_64& random_;
};

}  // namespace

std::vector<Hostile> hostile_expressions() {
  std::vector<Hostile> all = native();
  for (const DialectFacts& dialect : kDialects) {
    if (dialect.dialect == Dialect::Heckbert) continue;
    const std::vector<Hostile> of = of_dialect(dialect);
    all.insert(all.end(), of.begin(), of.end());
  }
  return all;
}

std::string random_expression(Dialect dialect, std::size_t length, std::mt19937_64& random) {
  std::string text = RandomText(facts(dialect), random).whole(length);
  return text;
}

}  // namespace heckbert::taxonomy
