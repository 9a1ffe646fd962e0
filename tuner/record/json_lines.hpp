#pragma once
// Breaks JSON text into lines, for files that people may open or compare.

#include <string>
#include <string_view>

namespace armtune::internal::record {

/// Returns the same JSON value with each member of an object, and each item of a list, on a line of its own.
/// What is nested deeper than `depth` stays on the line of the value that contains it. json: valid JSON text
/// without spaces between its tokens, as JsonWriter writes it.
std::string in_lines(std::string_view json, int depth);

}  // namespace armtune::internal::record
