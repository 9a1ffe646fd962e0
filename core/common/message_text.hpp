#pragma once
// Prepares text from files for messages: escapes what a terminal cannot show, and shortens long text. It also
// recognises UTF-8 and spreadsheet formulas.

#include <string>
#include <string_view>

namespace armtune::internal {

/// Returns the text as one line of UTF-8 that a terminal can show. Line breaks, other control characters and
/// bytes that are not UTF-8 are escaped. A word that is longer than any path or key path can be, such as a
/// name of a megabyte, is cut.
std::string one_line(std::string_view text);

/// Returns a value in quotes for a message. A long value is cut, never in the middle of a UTF-8 character.
std::string shown(std::string_view text);

/// True if the text is UTF-8 without overlong forms, surrogates or anything beyond U+10FFFF (Unicode, table
/// 3-7).
bool is_utf8(std::string_view text);

/// True if a spreadsheet would interpret a cell with this text as a formula.
bool is_formula(std::string_view text);

}  // namespace armtune::internal
