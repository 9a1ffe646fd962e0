#pragma once
// Writes texts, such as names and paths, as YAML. Whatever a text contains, armtune's reader and every other
// YAML reader return the same text.

#include <string>
#include <string_view>

namespace armtune::internal::yaml {

/// Returns the text in double quotes. Quotes and backslashes are escaped. So are characters that are not
/// printable (see is_printable), because some readers take some of them for a line end. YAML cannot express a
/// byte that is not UTF-8; such a byte becomes the character with the same code.
std::string quoted(const std::string& text);

/// Returns the text unchanged if every YAML reader reads it, without quotes, as this text, both in a list and
/// as a key. Such a text begins with a letter or '_', continues with letters, digits, '_', '-', '.' and '/',
/// and is not a YAML word for true, false or null. Returns any other text quoted.
std::string word(const std::string& text);

/// Returns a line "KEY: VALUE" of a map, indented. The key is written as a word. If it is longer than readers
/// accept in one line, it becomes an explicit key ("? KEY"). The value must be YAML already.
std::string entry(std::string_view indent, const std::string& key, std::string_view value);

/// Returns a line "# TEXT". Characters that are not printable are escaped so that no reader ends the comment
/// earlier.
std::string comment(std::string_view text);

}  // namespace armtune::internal::yaml
