#pragma once
// Characters of a text in UTF-8, and which of them every reader and every terminal takes for what they are.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace armtune::internal {

struct Utf8Character {
  std::size_t bytes = 1;         ///< how many it has
  std::optional<char32_t> code;  ///< none: the first byte begins no character, and stands for itself
};

/// Returns the character that the text begins with. The text must not be empty. Overlong forms, surrogates
/// and what lies beyond U+10FFFF are no characters (Unicode, table 3-7).
Utf8Character first_character(std::string_view text);

/// True for a character that YAML prints as it is and that ends no line anywhere: no control character (C0,
/// DEL, C1), no line or paragraph separator (U+2028, U+2029), no byte order mark, none that Unicode excludes.
bool is_printable(char32_t code);

/// True if every character of the text is printable, so that the text is UTF-8 as well.
bool is_printable(std::string_view text);

/// Returns the text as UTF-8, whatever bytes it holds, as names of files may. A byte that is part of no UTF-8
/// character becomes the Latin-1 character of its number, which is what it most often was.
std::string as_utf8(std::string_view text);

}  // namespace armtune::internal
