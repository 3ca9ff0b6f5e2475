// Compares the output of a program with what is expected, line by line and token by token: words to the letter, numbers
// to half a percent, since the last digits of a render differ between processors. Bars are left out.
//
// Usage: compare_output EXPECTED ACTUAL      exit 0 when alike; otherwise prints the first difference and exits 1

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr double kRelative = 0.005;

/// The tokens of a line without its bars; thousands written as "12 345" stay two tokens, compared as one number.
std::vector<std::string> tokens(const std::string& line) {
  std::string plain;
  for (std::size_t i = 0; i < line.size(); ++i) {
    // The block elements of bars are U+2580 to U+259F: E2 96 80 to E2 96 9F in UTF-8.
    if (line.compare(i, 2, "\xE2\x96") == 0) {
      i += 2;
      continue;
    }
    const char c = line[i];
    plain += c == '[' || c == ']' || c == ',' ? ' ' : c;
  }
  std::istringstream stream(plain);
  std::vector<std::string> result;
  for (std::string token; stream >> token;) {
    const auto digits = [](const std::string& t) { return t.find_first_not_of("0123456789") == std::string::npos; };
    if (!result.empty() && token.size() == 3 && digits(token) && digits(result.back()))
      result.back() += token;
    else
      result.push_back(token);
  }
  return result;
}

std::optional<double> number(const std::string& token) {
  char* end = nullptr;
  const double value = std::strtod(token.c_str(), &end);
  if (end == token.c_str() || *end != 0) return std::nullopt;
  return value;
}

/// Numbers agree to half a percent or to two in the last printed place, whole ones to half a percent only.
bool alike(const std::string& expected, const std::string& actual) {
  if (expected == actual) return true;
  const auto e = number(expected), a = number(actual);
  if (!e || !a) return false;
  const std::size_t point = expected.find('.');
  const double last_place =
      point == std::string::npos ? 0.0 : std::pow(10.0, -static_cast<double>(expected.size() - point - 1));
  return std::abs(*e - *a) <= std::max(kRelative * std::abs(*e), 2 * last_place);
}

std::vector<std::string> lines(const char* path) {
  std::ifstream file(path);
  if (!file) {
    std::cerr << "cannot read " << path << "\n";
    std::exit(2);
  }
  std::vector<std::string> result;
  for (std::string line; std::getline(file, line);) result.push_back(line);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: compare_output EXPECTED ACTUAL\n";
    return 2;
  }
  const auto expected = lines(argv[1]), actual = lines(argv[2]);
  for (std::size_t i = 0; i < std::max(expected.size(), actual.size()); ++i) {
    const std::string e = i < expected.size() ? expected[i] : "(nothing)";
    const std::string a = i < actual.size() ? actual[i] : "(nothing)";
    const auto et = tokens(e), at = tokens(a);
    bool same = et.size() == at.size();
    for (std::size_t t = 0; same && t < et.size(); ++t) same = alike(et[t], at[t]);
    if (!same) {
      std::cerr << argv[1] << ":" << i + 1 << ":\n  expected: " << e << "\n  actual:   " << a << "\n";
      return 1;
    }
  }
  return 0;
}
