#include "tuner/cli/say.hpp"

#include <cstdio>
#include <string>

#include "core/common/message_text.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal::cli {

void say(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    shown += is_printable(line) ? std::string(line) : one_line(line);
    text.remove_prefix(line.size());
    if (text.empty()) break;
    shown += '\n';
    text.remove_prefix(1);
  }
  std::fwrite(shown.data(), 1, shown.size(), stdout);
}

}  // namespace armtune::internal::cli
