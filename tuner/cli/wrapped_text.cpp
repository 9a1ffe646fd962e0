#include "tuner/cli/wrapped_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

void say_wrapped(const std::string& sentence, const char* indent) {
  constexpr std::size_t kLineWidth = 80;
  std::string line = indent;
  std::size_t begin = 0;
  bool first = true;
  while (begin < sentence.size()) {
    const std::size_t end = std::min(sentence.find(' ', begin), sentence.size());
    const std::string word = sentence.substr(begin, end - begin);
    if (!first && line.size() + 1 + word.size() > kLineWidth) {
      say(line + "\n");
      line = std::string(indent) + "  ";
      first = true;
    }
    line += (first ? "" : " ") + word;
    first = false;
    begin = end + 1;
  }
  say(line + "\n");
}

void say_list(const char* heading, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  say(fmt::format("\n{}\n", heading));
  for (const std::string& sentence : sentences) say_wrapped(sentence);
}

}  // namespace armtune::internal::cli
