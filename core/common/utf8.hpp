#pragma once
// Decodes UTF-8 text, and tests whether text is printable. YAML files and terminals show printable text
// unchanged.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace armtune::internal {

struct Utf8Character {
  std::size_t bytes = 1;         ///< length in bytes
  std::optional<char32_t> code;  ///< no value: the first byte starts no valid character (bytes is 1)
};

/// Returns the first character of the text, which must not be empty. Overlong forms, surrogates and anything
/// beyond U+10FFFF are not characters (Unicode, table 3-7).
Utf8Character first_character(std::string_view text);

/// True if YAML prints the character unchanged and no program takes it for a line end. Not printable are
/// control characters (C0, DEL, C1), line and paragraph separators (U+2028, U+2029), the byte order mark, and
/// codes that Unicode excludes.
bool is_printable(char32_t code);

/// True if every character of the text is printable, which implies that the text is UTF-8.
bool is_printable(std::string_view text);

/// Returns the text as UTF-8. Like a file name, the text may contain any bytes. A byte that is not part of a
/// UTF-8 character is taken for Latin-1, its usual origin, and becomes that Latin-1 character.
std::string as_utf8(std::string_view text);

}  // namespace armtune::internal
