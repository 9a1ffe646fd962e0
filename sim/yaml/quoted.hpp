#pragma once
// Texts as YAML that armtune's reader and every other one read back as the same text, whatever they hold.

#include <string>
#include <string_view>

namespace armtune::internal::yaml {

/// The text in double quotes, escaped where it holds quotes, backslashes, or characters that are not
/// printable (see is_printable): some of them end a line for some readers. A byte that is not UTF-8, for
/// which YAML has no word, becomes the character of that number.
std::string quoted(const std::string& text);

/// The text as it is where no reader can take it for anything else, in lists and as a key too: it begins with
/// a letter or '_', continues with letters, digits, '_', '-', '.' and '/', and is no word for a truth value
/// or nothing. Else quoted.
std::string word(const std::string& text);

/// A line "KEY: VALUE" of a map, indented. The key is written as a word, and as an explicit key ("? KEY")
/// where it is longer than readers take it to be in one line. The value is YAML already.
std::string entry(std::string_view indent, const std::string& key, std::string_view value);

/// A line "# TEXT" that no reader takes to end earlier: what is not printable is escaped.
std::string comment(std::string_view text);

}  // namespace armtune::internal::yaml
