#pragma once
// A text as YAML that reads back as the same text.

#include <string>

#include "core/common/utf8.hpp"

namespace armtune::yaml {

/// In double quotes, with quotes, backslashes, line ends and tabs escaped. For text without other control
/// characters. What is not UTF-8 is taken for Latin-1 (as_utf8): YAML can hold no other bytes.
inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : as_utf8(text)) {
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
