#pragma once
// Expressions that are hard on whoever compiles them: those known to be worst of their kind, and random ones of any
// length in any dialect. Each has at most ten thousand characters. Tests bound the work and the memory that they take;
// the benchmark of limits prints times.

#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <heckbert/taxonomy/dialect.h>

namespace heckbert::taxonomy {

inline constexpr std::size_t kLongestHostile = 10'000;

struct Hostile {
  std::string name;
  std::string text;
  Dialect dialect = Dialect::Heckbert;
};

/// Counts in counts, long words, wide unions, deep nesting, long chains of operators, many labels; where a dialect can
/// say them, in each dialect.
std::vector<Hostile> hostile_expressions();

/// A well-formed expression of the dialect, about `length` characters long, that likes counts, stars and alternatives.
std::string random_expression(Dialect dialect, std::size_t length, std::mt19937_64& random);

}  // namespace heckbert::taxonomy
