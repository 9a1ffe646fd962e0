#pragma once
// Suggestions for misspelt words ("did you mean ...?"): the known word closest to a given one.

#include <span>
#include <string>
#include <string_view>

namespace armtune::internal {

/// Returns the candidate with the smallest edit distance to `word`, the first one of equals. The distance
/// counts insertions, deletions, substitutions and swaps of neighbours (restricted Damerau-Levenshtein,
/// optimal string alignment) and ignores ASCII case. Returns an empty string if nothing is close: distance >
/// max(2, length of word / 3), or no letter in place. Throws only std::bad_alloc.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// Returns " (did you mean 'x'?)" with the nearest candidate, to follow `word` in a message; empty if nothing
/// is close.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace armtune::internal
