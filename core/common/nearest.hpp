#pragma once
// "Did you mean": the known word closest to a misspelt one.

#include <span>
#include <string>
#include <string_view>

namespace armtune::internal {

/// The candidate with the smallest edit distance to `word`: insertions, deletions, substitutions and swaps of
/// neighbours (Damerau-Levenshtein in its restricted form, optimal string alignment), ASCII case ignored; the
/// first one of equals. Empty when nothing is close: distance > max(2, length of word / 3), or not one letter
/// in place. Throws nothing but std::bad_alloc.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// "; did you mean 'x'?" with the nearest candidate, ready to end a message; empty when nothing is close.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace armtune::internal
