#pragma once
// Text from anywhere as UTF-8, for formats that know nothing else.

#include <string>
#include <string_view>

namespace armtune {

/// Returns the text as UTF-8, whatever bytes it holds, as names of files may. A byte that is part of no UTF-8
/// character becomes the Latin-1 character of its number, which is what it most often was.
std::string as_utf8(std::string_view text);

}  // namespace armtune
