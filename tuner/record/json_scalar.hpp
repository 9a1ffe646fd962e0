#pragma once
// Writes a text or a number as JSON.

#include <string>
#include <string_view>

namespace armtune::internal::record {

/// Returns the text in quotes. The result can be inserted into an HTML page: `<` is written as `\u003c`, so
/// that nothing in it ends a script element or begins a comment. DEL is written as `\u007f`, which readers of
/// YAML need. Bytes that are not UTF-8 become U+FFFD.
std::string json_scalar(std::string_view text);

/// Returns the number as text, with all digits that are needed to read back the same value; "null" if the
/// number is not finite.
std::string json_scalar(double number);

}  // namespace armtune::internal::record
