#pragma once
// What came from a file, as messages show it.

#include <string>
#include <string_view>

namespace armtune::internal {

/// One line that a terminal can show, in UTF-8: line breaks, other control characters and bytes that are not
/// UTF-8 are escaped, and words longer than any path or key path (a name of a megabyte) are cut.
std::string one_line(std::string_view text);

/// A value as a message shows it: in quotes, cut when long, never in the middle of a UTF-8 character.
std::string shown(std::string_view text);

/// Whether a text is UTF-8 without overlong forms, surrogates or anything beyond U+10FFFF (Unicode, table
/// 3-7).
bool is_utf8(std::string_view text);

/// Whether a spreadsheet would take a cell with this text for a formula.
bool is_formula(std::string_view text);

}  // namespace armtune::internal
