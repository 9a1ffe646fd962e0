#include "tuner/record/json_lines.hpp"

#include <algorithm>

namespace armtune::internal::record {
namespace {

/// Returns the index behind the text in quotes that begins at `begin`.
std::size_t end_of_text(std::string_view json, std::size_t begin) {
  std::size_t at = begin + 1;
  while (at < json.size() && json[at] != '"') at += json[at] == '\\' ? 2 : 1;
  return std::min(json.size(), at + 1);
}

}  // namespace

std::string in_lines(std::string_view json, int depth) {
  std::string lines;
  int level = 0;
  const auto break_line = [&] {
    if (level <= depth) lines.append(1, '\n').append(2 * static_cast<std::size_t>(level), ' ');
  };
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '"') {
      const std::size_t end = end_of_text(json, at);
      lines += json.substr(at, end - at);
      at = end - 1;
    } else if (c == '{' || c == '[') {
      lines += c;
      const bool empty = at + 1 < json.size() && (json[at + 1] == '}' || json[at + 1] == ']');
      if (empty) {
        lines += json[++at];
        continue;
      }
      ++level;
      break_line();
    } else if (c == '}' || c == ']') {
      if (level-- <= depth) lines.append(1, '\n').append(2 * static_cast<std::size_t>(level), ' ');
      lines += c;
    } else {
      lines += c;
      if (c == ':') lines += ' ';
      if (c != ',') continue;
      level <= depth ? break_line() : void(lines += ' ');
    }
  }
  return lines;
}

}  // namespace armtune::internal::record
