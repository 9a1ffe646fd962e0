#include "core/common/utf8.hpp"

#include <algorithm>

#include "core/common/message_text.hpp"

namespace armtune {

std::string as_utf8(std::string_view text) {
  constexpr std::size_t kLongest = 4;
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    std::size_t bytes = std::min(text.size(), kLongest);
    while (bytes > 0 && !is_utf8(text.substr(0, bytes))) --bytes;
    if (bytes == 0) {  // 0x80 .. 0xFF are U+0080 .. U+00FF in Latin-1
      const auto c = static_cast<unsigned char>(text[0]);
      out += static_cast<char>(0xC0 | (c >> 6));
      out += static_cast<char>(0x80 | (c & 0x3F));
      bytes = 1;
    } else {
      out += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return out;
}

}  // namespace armtune
