#pragma once
// Compares texts that differ in numbers.

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace armtune::internal::test {

/// A text, cut at its numbers: words[i] stands before numbers[i], and the last of the words at the end.
struct CutText {
  std::vector<std::string> words{1};
  std::vector<std::string> numbers;
};

/// Cuts a text at every number of digits, points, signs and exponents.
inline CutText cut_at_numbers(const std::string& text) {
  CutText cut;
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
      cut.words.back() += text[i];
      continue;
    }
    const auto goes_on = [&text](std::size_t at) {
      if (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.') return true;
      return (text[at] == '+' || text[at] == '-') && text[at - 1] == 'e';
    };
    const std::size_t begin = i;
    for (++i; i < text.size() && goes_on(i);) ++i;
    cut.numbers.push_back(text.substr(begin, i - begin));
    cut.words.emplace_back();
    --i;
  }
  return cut;
}

/// The text without its numbers.
inline std::vector<std::string> without_numbers(const std::string& text) {
  return cut_at_numbers(text).words;
}

/// The keys, such as `p` in `p: 600.0`, whose numbers differ between two texts that have the same words.
inline std::set<std::string> keys_of_other_numbers(const std::string& before, const std::string& after) {
  const CutText a = cut_at_numbers(before);
  const CutText b = cut_at_numbers(after);
  std::set<std::string> keys;
  for (std::size_t i = 0; i < std::min(a.numbers.size(), b.numbers.size()); ++i) {
    if (a.numbers[i] == b.numbers[i]) continue;
    const std::string& words = a.words[i];
    const auto is_of_key = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    std::size_t end = words.size();
    while (end > 0 && !is_of_key(words[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && is_of_key(words[begin - 1])) --begin;
    keys.insert(words.substr(begin, end - begin));
  }
  return keys;
}

}  // namespace armtune::internal::test
