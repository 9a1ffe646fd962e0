#include "sim/csv/line_cells.hpp"

#include <algorithm>
#include <string>

namespace armtune::internal {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\"");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\"") - begin + 1);
}

long count_outside_quotes(std::string_view line, char what) {
  long count = 0;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == what && !quoted) ++count;
  }
  return count;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  constexpr std::string_view kBlanks = " \t";
  for (std::size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = line.find_first_not_of(kBlanks, end);
  }
}

}  // namespace

char find_separator(std::string_view first_line) {
  char most = ' ';
  long count = 0;
  for (const char separator : {',', ';', '\t'}) {
    const long here = count_outside_quotes(first_line, separator);
    if (here <= count) continue;
    count = here;
    most = separator;
  }
  return most;
}

std::string_view separator_name(char separator) {
  switch (separator) {
    case ',':
      return "commas";
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    default:
      return "blanks";
  }
}

void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  if (separator == ' ') return split_at_blanks(line, cells);
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != separator || quoted) continue;
    cells.push_back(trimmed(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  cells.push_back(trimmed(line.substr(begin)));
}

}  // namespace armtune::internal
