#include "sim/yaml/quoted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/common/message_text.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal::yaml {
namespace {

constexpr std::size_t kLongestKeyInLine = 1000;  // readers look 1024 characters ahead for the colon
/// The words that YAML 1.1, which most readers follow, takes for a boolean or for null.
constexpr std::array<std::string_view, 9> kReserved = {"true", "false", "yes", "no", "on",
                                                       "off",  "null",  "y",   "n"};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_reserved(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::find(kReserved.begin(), kReserved.end(), text) != kReserved.end();
}

std::string escape(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\t') return "\\t";
  if (code > 0xFFFF) return fmt::format("\\U{:08x}", code);
  return code > 0xFF ? fmt::format("\\u{:04x}", code) : fmt::format("\\x{:02x}", code);
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (std::string_view rest = text; !rest.empty();) {
    const Utf8Character character = first_character(rest);
    if (character.code && is_printable(*character.code)) {
      if (rest.front() == '"' || rest.front() == '\\') out += '\\';
      out += rest.substr(0, character.bytes);
    } else {
      out += escape(character.code ? static_cast<std::uint32_t>(*character.code)
                                   : static_cast<unsigned char>(rest.front()));
    }
    rest.remove_prefix(character.bytes);
  }
  return out + "\"";
}

std::string word(const std::string& text) {
  const auto goes_on = [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '/';
  };
  const bool plain = !text.empty() && is_letter(text.front()) &&
                     std::all_of(text.begin(), text.end(), goes_on) && !is_reserved(text);
  return plain ? text : quoted(text);
}

std::string entry(std::string_view indent, const std::string& key, std::string_view value) {
  const std::string written = word(key);
  return written.size() > kLongestKeyInLine ? fmt::format("{0}? {1}\n{0}: {2}\n", indent, written, value)
                                            : fmt::format("{}{}: {}\n", indent, written, value);
}

std::string comment(std::string_view text) {
  return fmt::format("# {}\n", one_line(text));
}

}  // namespace armtune::internal::yaml
