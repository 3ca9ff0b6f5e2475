#pragma once
// What an algorithm of the table can find: the words that its grammar claims, and with which techniques.
//
// Grammars are written for surfaces: their X is D, G or S. An algorithm that scatters light at particles of media too
// can join walks there, so that V counts as N; but it merges none there, and to merging V is as good as S.

#include <cstddef>

#include <heckbert/taxonomy/language.h>
#include <heckbert/transport/render.h>

namespace heckbert::transport {

/// None where the grammar has no language.
taxonomy::Language claimed_by(const AlgorithmFacts& algorithm);

/// As for its reach (reach.h); no word with a V where it does not scatter light in media.
bool has_technique(const AlgorithmFacts& algorithm, const taxonomy::Word& word, std::size_t light_vertices);

}  // namespace heckbert::transport
