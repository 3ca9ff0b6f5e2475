#include <heckbert/taxonomy/counting.h>

#include <algorithm>
#include <array>

namespace heckbert::taxonomy {

namespace {

using Residue = std::uint64_t;

// A prime may by accident divide what must not vanish; then the check fails and the next one is tried.
constexpr std::array<std::uint32_t, 3> kPrimes{2147483647u, 2147483629u, 2147483587u};

Residue power(Residue base, Residue exponent, Residue prime) {
  Residue result = 1;
  for (; exponent > 0; exponent >>= 1, base = base * base % prime)
    if (exponent & 1) result = result * base % prime;
  return result;
}

struct Recurrence {
  std::vector<Residue> connection;  ///< c[0] = 1; sum of c[i] s[n-i] is 0 for n >= order
  std::size_t order = 0;
};

// Berlekamp and Massey: the shortest recurrence that the sequence obeys modulo the prime.
Recurrence shortest_recurrence(const std::vector<Residue>& s, Residue prime) {
  std::vector<Residue> c{1}, before{1};
  std::size_t order = 0, shift = 1;
  Residue discrepancy_before = 1;
  for (std::size_t n = 0; n < s.size(); ++n) {
    Residue discrepancy = 0;
    for (std::size_t i = 0; i < c.size() && i <= n; ++i) discrepancy = (discrepancy + c[i] * s[n - i]) % prime;
    if (discrepancy == 0) {
      ++shift;
      continue;
    }
    const std::vector<Residue> kept = c;
    const Residue factor = discrepancy * power(discrepancy_before, prime - 2, prime) % prime;
    c.resize(std::max(c.size(), before.size() + shift), 0);
    for (std::size_t i = 0; i < before.size(); ++i)
      c[i + shift] = (c[i + shift] + (prime - factor) * before[i]) % prime;
    if (2 * order <= n) {
      order = n + 1 - order;
      before = kept;
      discrepancy_before = discrepancy;
      shift = 1;
    } else {
      ++shift;
    }
  }
  return {c, order};
}

std::int64_t nearest_to_zero(Residue value, Residue prime) {
  return value > prime / 2 ? static_cast<std::int64_t>(value) - static_cast<std::int64_t>(prime)
                           : static_cast<std::int64_t>(value);
}

void trim(std::vector<std::int64_t>& polynomial) {
  while (polynomial.size() > 1 && polynomial.back() == 0) polynomial.pop_back();
}

GeneratingFunction guess(const std::vector<Natural>& counts, std::uint32_t prime) {
  std::vector<Residue> s;
  s.reserve(counts.size());
  for (const Natural& n : counts) s.push_back(n.modulo(prime));
  const Recurrence recurrence = shortest_recurrence(s, prime);
  GeneratingFunction f{{0}, {}};
  for (const Residue r : recurrence.connection) f.denominator.push_back(nearest_to_zero(r, prime));
  for (std::size_t n = 0; n < recurrence.order; ++n) {
    Residue sum = 0;
    for (std::size_t i = 0; i < recurrence.connection.size() && i <= n; ++i)
      sum = (sum + recurrence.connection[i] * s[n - i]) % prime;
    f.numerator.resize(n + 1);
    f.numerator[n] = nearest_to_zero(sum, prime);
  }
  trim(f.numerator);
  trim(f.denominator);
  return f;
}

// denominator * counts == numerator, in whole numbers; what is negative goes to the other side.
bool holds(const GeneratingFunction& f, const std::vector<Natural>& counts) {
  for (std::size_t n = 0; n < counts.size(); ++n) {
    Natural left, right;
    for (std::size_t i = 0; i < f.denominator.size() && i <= n; ++i) {
      const std::int64_t c = f.denominator[i];
      (c > 0 ? left : right).add(counts[n - i], static_cast<std::uint32_t>(c > 0 ? c : -c));
    }
    const std::int64_t c = n < f.numerator.size() ? f.numerator[n] : 0;
    (c > 0 ? right : left).add(Natural(1), static_cast<std::uint32_t>(c > 0 ? c : -c));
    if (left != right) return false;
  }
  return true;
}

std::string write(const std::vector<std::int64_t>& polynomial) {
  std::string text;
  for (std::size_t n = 0; n < polynomial.size(); ++n) {
    const std::int64_t c = polynomial[n];
    if (c == 0) continue;
    if (text.empty())
      text = c < 0 ? "-" : "";
    else
      text += c < 0 ? " - " : " + ";
    const std::string size = std::to_string(c < 0 ? -c : c);
    const std::string x = n == 0 ? "" : n == 1 ? "x" : "x^" + std::to_string(n);
    if (x.empty() || size != "1") text += size;
    if (!x.empty() && size != "1") text += ' ';
    text += x;
  }
  return text.empty() ? "0" : text;
}

bool is_one_term(const std::string& polynomial) {
  return polynomial.find(" + ") == std::string::npos && polynomial.find(" - ") == std::string::npos;
}

}  // namespace

std::vector<Natural> count_words(const Language& language, std::size_t max_length) {
  const Language words = language & Language::universe();
  const std::vector<State>& states = words.states();
  std::vector<std::vector<std::size_t>> columns;
  for (const State& state : states) columns.push_back(representative_columns(words.alphabet(), state));
  std::vector<Natural> arrived(states.size());
  arrived[0] = Natural(1);
  std::vector<Natural> counts;
  for (std::size_t letters = 1; letters <= max_length + 2; ++letters) {
    std::vector<Natural> next(states.size());
    for (std::size_t q = 0; q < states.size(); ++q) {
      if (arrived[q].is_zero()) continue;
      for (const std::size_t c : columns[q]) next[states[q].next[c]].add(arrived[q]);
    }
    arrived = std::move(next);
    if (letters < 2) continue;
    Natural total;
    for (std::size_t q = 0; q < states.size(); ++q)
      if (states[q].accepting) total.add(arrived[q]);
    counts.push_back(std::move(total));
  }
  return counts;
}

std::optional<GeneratingFunction> generating_function(const Language& language) {
  const std::size_t size = (language & Language::universe()).states().size();
  if (size > kGeneratingFunctionStates) return std::nullopt;
  // The counts are a quotient whose two sides have degree below `size`; so is the guess, as the shortest recurrence.
  // Two such quotients that agree on 2 * size terms are equal.
  const std::vector<Natural> counts = count_words(language, 2 * size + 1);
  for (const std::uint32_t prime : kPrimes)
    if (GeneratingFunction f = guess(counts, prime); holds(f, counts)) return f;
  return std::nullopt;
}

std::string write(const GeneratingFunction& function) {
  const std::string below = write(function.denominator);
  std::string above = write(function.numerator);
  if (below == "1") return above;
  return (is_one_term(above) ? above : "(" + above + ")") + " / " + (is_one_term(below) ? below : "(" + below + ")");
}

}  // namespace heckbert::taxonomy
