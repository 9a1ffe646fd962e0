#include "core/common/utf8.hpp"

namespace armtune::internal {

Utf8Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return {1, static_cast<char32_t>(first)};
  if (first < 0xC2 || first > 0xF4) return {};
  // After these four first bytes, the second byte has a smaller range.
  const unsigned lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < lowest || byte(1) > highest) return {};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  char32_t code = first & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return {};
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  return {bytes, code};
}

bool is_printable(char32_t code) {
  if (code < 0x20 || (code >= 0x7F && code < 0xA0)) return false;
  constexpr char32_t kLineSeparator = 0x2028;
  constexpr char32_t kParagraphSeparator = 0x2029;
  constexpr char32_t kByteOrderMark = 0xFEFF;
  if (code == kLineSeparator || code == kParagraphSeparator || code == kByteOrderMark) return false;
  // These change the direction of text, so that a name can look like another one (Unicode, report 36).
  const bool turns = code == 0x61C || code == 0x200E || code == 0x200F ||
                     (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  if (turns) return false;
  return (code & 0xFFFEU) != 0xFFFEU;  // the last two codes of each plane are not characters
}

bool is_printable(std::string_view text) {
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    if (!character.code || !is_printable(*character.code)) return false;
    text.remove_prefix(character.bytes);
  }
  return true;
}

std::string as_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    if (character.code) {
      out += text.substr(0, character.bytes);
    } else {  // read as Latin-1, where 0x80 .. 0xFF are U+0080 .. U+00FF
      const auto c = static_cast<unsigned char>(text[0]);
      out += static_cast<char>(0xC0 | (c >> 6));
      out += static_cast<char>(0x80 | (c & 0x3F));
    }
    text.remove_prefix(character.bytes);
  }
  return out;
}

}  // namespace armtune::internal
