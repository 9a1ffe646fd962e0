#pragma once
// A text as YAML that reads back as the same text.

#include <string>

namespace armtune::yaml {

/// In double quotes, with quotes and backslashes escaped. For text without control characters.
inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

}  // namespace armtune::yaml
