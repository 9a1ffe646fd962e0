#pragma once
// A text and a number as JSON.

#include <string>
#include <string_view>

namespace armtune::internal::record {

/// In quotes. The text may stand inside an HTML page: `<` is written as `\u003c`, so that nothing in it ends
/// a script element or begins a comment, and DEL as `\u007f`, which YAML's readers want. Bytes that are not
/// UTF-8 become U+FFFD.
std::string json_scalar(std::string_view text);

/// Reads back to the same bits; null where it is not finite.
std::string json_scalar(double number);

}  // namespace armtune::internal::record
