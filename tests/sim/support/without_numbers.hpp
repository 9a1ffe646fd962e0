#pragma once
// What two files that differ in numbers alone have in common.

#include <cctype>
#include <string>

namespace armtune::internal::test {

/// The text with every number of digits, points, signs and exponents taken out.
inline std::string without_numbers(const std::string& text) {
  std::string rest;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto digit = [&text](std::size_t at) {
      return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
    };
    const bool word =
        i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_');
    const bool number =
        !word && (digit(i) || (text[i] == '.' && (digit(i + 1) || text.substr(i, 4) == ".inf")) ||
                  (text[i] == '+' && digit(i + 1)));
    if (!number) {
      rest += text[i];
      continue;
    }
    const auto goes_on = [&text](std::size_t at) {
      if (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.') return true;
      return (text[at] == '+' || text[at] == '-') && text[at - 1] == 'e';
    };
    for (++i; i < text.size() && goes_on(i);) ++i;
    rest += '#';
    --i;
  }
  return rest;
}

}  // namespace armtune::internal::test
