#pragma once
// The input of the matching benchmark: words as a path tracer meets them, and expressions as its users write them.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <heckbert/taxonomy/symbol.h>

namespace bench {

using heckbert::taxonomy::Symbol;

/// Many words, back to back.
struct Words {
  std::vector<Symbol> from_light;        ///< the letters of every word, light -> eye
  std::vector<Symbol> from_eye;          ///< the same words, eye -> light
  std::vector<std::size_t> begin = {0};  ///< where word i begins; one more than there are words
  std::size_t count() const { return begin.size() - 1; }
  std::size_t letters(std::size_t word) const { return begin[word + 1] - begin[word]; }
};

/// Random walks from the eye: a room of mostly diffuse walls with a glass object, a mirror, something glossy and a
/// little mist; what is met next depends on what was met last, and roulette ends what the light does not. Tuned to the
/// statistics of a record: a mean of five scatterings, some 90 000 distinct words in ten million, of which 400 are 90
/// %.
Words random_walks(std::size_t count, std::uint64_t seed);

/// 256 expressions in native syntax, the everyday ones first: the grammars of all algorithms and the named classes,
/// what look developers ask for, ends by lobes, ranges of depth, and last numbers of events, whose states multiply.
std::vector<std::string> everyday_expressions();

}  // namespace bench
