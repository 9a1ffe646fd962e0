#include "core/common/message_text.hpp"

#include <fmt/format.h>

namespace armtune {
namespace {

constexpr std::size_t kLongestValue = 60;
constexpr std::size_t kLongestWord = 4200;  // PATH_MAX and some more

/// The first bytes of a longer text, at most `most` of them, ending with a whole UTF-8 character.
std::string_view beginning(std::string_view text, std::size_t most) {
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

void append_escaped(std::string& line, std::string_view text) {
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      line += c;
    }
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
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byte(i++);
    if (first < 0x80) continue;
    if (first < 0xC2 || first > 0xF4) return false;
    // The second byte has a smaller range behind these four: overlong forms, surrogates, beyond U+10FFFF.
    const unsigned lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (byte(i) < lowest || byte(i) > highest) return false;
    ++i;
    for (int more = first >= 0xF0 ? 2 : first >= 0xE0 ? 1 : 0; more > 0; --more, ++i) {
      if (byte(i) < 0x80 || byte(i) > 0xBF) return false;
    }
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
