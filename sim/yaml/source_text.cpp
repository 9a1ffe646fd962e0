#include "sim/yaml/source_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/common/error.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::yaml {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
    } else if (is_control(c)) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return fmt::format("'{}'", text);
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return fmt::format("'{}...'", text.substr(0, end));
}

void fail_at(const std::string& file, int line, std::string_view key_path, std::string_view what) {
  const std::string key = key_path.empty() ? std::string() : fmt::format("key '{}': ", key_path);
  throw InputError(one_line(fmt::format("{}:{}: {}{}", file, line, key, what)));
}

void check_characters(std::string_view text, const std::string& file) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError(one_line(file + ": the text is UTF-16; save it as UTF-8"));
  }
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (!is_control(c) || c == '\n' || c == '\r' || c == '\t') continue;
    fail_at(file, line, {},
            fmt::format("control character 0x{:02x}; expected text in UTF-8", static_cast<unsigned>(c)));
  }
}

bool closes_quote(std::string_view text) {
  if (text.empty() || (text[0] != '"' && text[0] != '\'')) return true;
  const char quote = text[0];
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == quote) {
      if (quote == '"' || i + 1 == text.size() || text[i + 1] != quote) return true;
      ++i;
    }
  }
  return false;
}

std::string read_text(const std::string& path, std::size_t max_bytes) {
  const auto fail = [&](const std::string& what) { throw InputError(one_line(path + ": " + what)); };
  std::error_code status_error;
  const std::filesystem::file_status status = std::filesystem::status(path, status_error);
  if (status.type() == std::filesystem::file_type::not_found) fail("no such file");
  if (status.type() == std::filesystem::file_type::directory) fail("is a directory; expected a YAML file");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("cannot be opened: " + std::generic_category().message(errno));
  // One byte more than allowed is enough to know, also for a pipe or a device that has no size.
  std::string text(max_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) fail("cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace armtune::yaml
