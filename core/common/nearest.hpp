#pragma once
// Suggestions for misspelt words ("did you mean ...?"): the known word closest to a given one.

#include <span>
#include <string>
#include <string_view>

namespace armtune::internal {

/// Returns the candidate with the smallest edit distance to `word`; if several have it, the first of them.
/// The distance counts insertions, deletions, substitutions and swaps of neighbours (restricted
/// Damerau-Levenshtein, optimal string alignment) and ignores ASCII case. A candidate is not close if its
/// distance exceeds max(2, a third of the length of `word`), or if every letter would have to change. Returns
/// an empty string if no candidate is close. Throws only std::bad_alloc.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// Returns " (did you mean 'x'?)" with the nearest candidate, to follow `word` in a message; empty if nothing
/// is close.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace armtune::internal
