#pragma once
// Prints sentences on standard output, broken into lines of at most 80 characters.

#include <string>
#include <vector>

namespace armtune::internal::cli {

/// Prints a sentence with an indent. Its further lines have two blanks more.
void say_wrapped(const std::string& sentence, const char* indent = "  ");

/// Prints a heading, and sentences below it; nothing if there are none.
void say_list(const char* heading, const std::vector<std::string>& sentences);

}  // namespace armtune::internal::cli
