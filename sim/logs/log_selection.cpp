#include "sim/logs/log_selection.hpp"

#include <algorithm>

namespace armtune::internal {

bool matches_pattern(std::string_view pattern, std::string_view text) {
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t star = std::string_view::npos;  // the last * so far, which can stand for more text
  std::size_t covered = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      covered = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++covered;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool is_selected(const LogSelection& selection, std::string_view topic) {
  return selection.topics.empty() ||
         std::any_of(selection.topics.begin(), selection.topics.end(),
                     [topic](const std::string& pattern) { return matches_pattern(pattern, topic); });
}

}  // namespace armtune::internal
