#pragma once
// Private to sim/yaml: what a text must be before it is parsed, and where a message says something is.

#include <string>
#include <string_view>

namespace armtune::internal::yaml {

/// Throws InputError "FILE:LINE: key 'a/b': what", on one line; without the key where the path is empty.
[[noreturn]] void fail_at(const std::string& file, int line, std::string_view key_path,
                          std::string_view what);

/// Throws InputError for text that is not UTF-8 and for control characters. yaml-cpp replaces what is not
/// UTF-8, ends a file at the character 4 without a word, keeps NUL in values and guesses UTF-16.
void check_characters(std::string_view text, const std::string& file);

/// Whether the quote that `text` begins with is closed in it. True for a text that begins with none.
bool closes_quote(std::string_view text);

}  // namespace armtune::internal::yaml
