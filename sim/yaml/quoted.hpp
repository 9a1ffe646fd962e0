#pragma once
// A text as YAML that reads back as the same text.

#include <string>

namespace armtune::yaml {

/// In double quotes, with quotes, backslashes, line ends and tabs escaped. For text without other control
/// characters.
inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n' || c == '\t') {
      out += c == '\n' ? "\\n" : "\\t";
    } else {
      out += c;
    }
  }
  return out + "\"";
}

}  // namespace armtune::yaml
