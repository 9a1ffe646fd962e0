#include "sim/yaml/source_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal::yaml {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

InputError error_at(const std::string& file, int line, std::string_view key_path, InputFault fault) {
  if (!key_path.empty()) fault.problem.insert(0, fmt::format("key '{}': ", key_path));
  return {at_line(file, line, std::string(key_path)), std::move(fault)};
}

void fail_at(const std::string& file, int line, std::string_view key_path, std::string what,
             std::string limit) {
  const InputError error = error_at(file, line, key_path, {.problem = std::move(what)});
  throw limit.empty() ? error : error.with_value({}, std::move(limit));
}

void check_characters(std::string_view text, const std::string& file) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError(InputPlace{file}, "the text is UTF-16; save it as UTF-8");
  }
  int line = 1;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (!is_utf8(text.substr(begin, end - begin))) {
      fail_at(file, line, {}, "not UTF-8, perhaps Latin-1; save the file as UTF-8");
    }
    begin = end + 1;
    ++line;
  }
  line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (!is_control(c) || c == '\n' || c == '\r' || c == '\t') continue;
    fail_at(file, line, {},
            fmt::format("this line contains the control character 0x{:02x}; remove it",
                        static_cast<unsigned>(c)));
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

}  // namespace armtune::internal::yaml
