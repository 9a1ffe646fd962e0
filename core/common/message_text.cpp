#include "core/common/message_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace armtune {
namespace {

constexpr std::size_t kLongestValue = 60;
constexpr std::size_t kLongestWord = 4200;  // PATH_MAX and some more

/// The first bytes of a longer text, at most `most` of them, ending with a whole UTF-8 character.
std::string_view beginning(std::string_view text, std::size_t most) {
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

/// Returns how many bytes the UTF-8 character has that the text begins with; 0: it begins with none.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return text.empty() ? 0 : 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  // The second byte has a smaller range behind these four: overlong forms, surrogates, beyond U+10FFFF.
  const unsigned lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < lowest || byte(1) > highest) return 0;
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  for (std::size_t i = 2; i < bytes; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  }
  return bytes;
}

void append_escaped(std::string& line, std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    const auto c = static_cast<unsigned char>(text[0]);
    if (c == '\n') {
      line += "\\n";
    } else if (bytes == 0 || c < 0x20 || c == 0x7f) {
      line += fmt::format("\\x{:02x}", c);
    } else {
      line += text.substr(0, bytes);
    }
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (word.size() > kLongestWord) {
      append_escaped(line, beginning(word, kLongestValue));
      line += fmt::format("... ({} bytes)", word.size());
    } else {
      append_escaped(line, word);
    }
    text.remove_prefix(word.size());
    if (text.empty()) break;
    line += ' ';
    text.remove_prefix(1);
  }
  return line;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    if (bytes == 0) return false;
    text.remove_prefix(bytes);
  }
  return true;
}

bool is_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
}

std::string shown(std::string_view text) {
  return text.size() <= kLongestValue ? fmt::format("'{}'", text)
                                      : fmt::format("'{}...'", beginning(text, kLongestValue));
}

}  // namespace armtune
