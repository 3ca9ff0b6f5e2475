#pragma once
// How many words a language has at each length, exactly, and in closed form: the counts of a regular language are the
// coefficients of a quotient of two polynomials with whole coefficients (Chomsky and Schuetzenberger 1963; Flajolet and
// Sedgewick, "Analytic Combinatorics", I.4). Which words count is the caller's choice: intersect with possible_words()
// for one kind of each end, or take plain_words() to count plain letters.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/natural.h>

namespace heckbert::taxonomy {

/// Element n is the number of words with n scatterings, as first_words() would list them, n = 0 .. max_length. Cost:
/// states times max_length squared.
std::vector<Natural> count_words(const Language& language, std::size_t max_length);

/// numerator / denominator in lowest terms, coefficients of x^0, x^1, ...; denominator[0] is 1.
struct GeneratingFunction {
  std::vector<std::int64_t> numerator, denominator;
  bool operator==(const GeneratingFunction&) const = default;
};

/// States up to which a generating function is looked for; the search costs their number to the fourth.
inline constexpr std::size_t kGeneratingFunctionStates = 60;

/// The sum of count(n) x^n, proven equal for every n. Nothing when the automaton has more than
/// kGeneratingFunctionStates states or a coefficient would not fit 31 bits.
/// Source: Massey 1969, "Shift-register synthesis and BCH decoding", modulo a prime; then checked in whole numbers on
/// more terms than the two sides have poles together, which proves equality.
std::optional<GeneratingFunction> generating_function(const Language& language);

/// "(1 + x) / (1 - x - x^2)".
std::string write(const GeneratingFunction& function);

}  // namespace heckbert::taxonomy
