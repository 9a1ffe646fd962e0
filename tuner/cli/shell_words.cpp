#include "tuner/cli/shell_words.hpp"

namespace armtune::internal::cli {

std::string shell_word(const std::string& word) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string quoted_command(const std::vector<std::string>& words) {
  std::string text = "armtune";
  for (std::size_t i = 1; i < words.size(); ++i) text += ' ' + shell_word(words[i]);
  return text;
}

}  // namespace armtune::internal::cli
