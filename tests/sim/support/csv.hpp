#pragma once
// CSV read back, quoted cells included; none of them holds a line break.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/sim/support/files.hpp"

namespace armtune::internal::test {

inline std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        out.back() += line[i++];
      else
        quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      out.emplace_back();
    } else {
      out.back() += line[i];
    }
  }
  return out;
}

/// A table with a header row.
struct Csv {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  explicit Csv(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    header = cells(line);
    while (std::getline(lines, line)) rows.push_back(cells(line));
  }
  std::string at(std::size_t row, const std::string& column) const {
    const auto found = std::find(header.begin(), header.end(), column);
    if (found == header.end()) return "no column " + column;
    const auto index = static_cast<std::size_t>(found - header.begin());
    if (row >= rows.size() || index >= rows[row].size()) return "no cell in " + column;
    return rows[row][index];
  }
};

inline Csv read_csv(const std::string& path) {
  return Csv(read_text(path));
}

/// The text of a CSV file without its last column, which holds the wall time in files of a search.
inline std::string without_time(const std::string& path) {
  std::string text;
  std::istringstream lines(read_text(path));
  for (std::string line; std::getline(lines, line);) text += line.substr(0, line.rfind(',')) + '\n';
  return text;
}

}  // namespace armtune::internal::test
