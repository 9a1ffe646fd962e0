#pragma once
// Checks a YAML text before it is parsed, and throws errors that name a place in it. Only sim/yaml uses this.

#include <string>
#include <string_view>

#include "armtune/error.hpp"

namespace armtune::internal::yaml {

/// Returns the InputError "FILE:LINE: key 'a/b': PROBLEM; expected LIMIT", on one line, with this place. The
/// key is left out if the path is empty, and the limit if it is empty.
InputError error_at(const std::string& file, int line, std::string_view key_path, InputFault fault);

/// Throws InputError "FILE:LINE: key 'a/b': what" with this place. limit: see InputError::limit().
[[noreturn]] void fail_at(const std::string& file, int line, std::string_view key_path, std::string what,
                          std::string limit = {});

/// Throws InputError for text that is not UTF-8 and for control characters. Without this check, yaml-cpp
/// would replace bytes that are not UTF-8, silently end the file at a character with code 4, keep NUL in
/// values, and take some texts for UTF-16.
void check_characters(std::string_view text, const std::string& file);

/// Returns true if `text` does not begin with a quote, or if the quote at its beginning is closed in it.
bool closes_quote(std::string_view text);

}  // namespace armtune::internal::yaml
