#pragma once
// Quotes words and command lines for a shell.

#include <string>
#include <vector>

namespace armtune::internal::cli {

/// Returns the word in a form that a shell reads as one word.
std::string shell_word(const std::string& word);

/// Returns the command line, quoted for a shell, with armtune in place of the program's path.
std::string quoted_command(const std::vector<std::string>& words);

}  // namespace armtune::internal::cli
