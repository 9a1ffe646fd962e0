#include "core/common/message_text.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "core/common/utf8.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kLongestValue = 60;
constexpr std::size_t kLongestWord = 4200;  // slightly above PATH_MAX (4096)

/// Returns at most the first `most` bytes of a longer text, without a cut inside a UTF-8 character.
std::string_view beginning(std::string_view text, std::size_t most) {
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

void append_escaped(std::string& line, std::string_view text) {
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    if (text.front() == '\n') {
      line += "\\n";
    } else if (character.code && is_printable(*character.code)) {
      line += text.substr(0, character.bytes);
    } else {
      const auto code = static_cast<std::uint32_t>(
          character.code.value_or(static_cast<char32_t>(static_cast<unsigned char>(text.front()))));
      line += code > 0xFFFF ? fmt::format("\\U{:08x}", code)
              : code > 0xFF ? fmt::format("\\u{:04x}", code)
                            : fmt::format("\\x{:02x}", code);
    }
    text.remove_prefix(character.bytes);
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
    const Utf8Character character = first_character(text);
    if (!character.code) return false;
    text.remove_prefix(character.bytes);
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

}  // namespace armtune::internal
