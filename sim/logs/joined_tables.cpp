#include "sim/logs/joined_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

constexpr long kMostLinesOfRow = 100;  ///< of a file that holds the values of one row on several lines

long count_rows(const std::string& path) {
  TextTable table(path);
  long rows = 0;
  while (table.next()) ++rows;
  return rows;
}

}  // namespace

JoinedTables::JoinedTables(const std::vector<std::string>& paths) {
  if (paths.empty()) throw InputError(InputPlace{.key = "FILE"}, "no log file is given");
  std::vector<long> rows;
  rows.reserve(paths.size());
  for (const std::string& path : paths) {
    rows.push_back(count_rows(path));
    if (rows.back() == 0) throw InputError(InputPlace{path}, "holds no rows").with_value("0", "rows");
  }
  const long least = *std::min_element(rows.begin(), rows.end());
  for (std::size_t i = 0; i < paths.size(); ++i) add(paths[i], rows[i], least);
  std::set<std::string> seen;
  for (const std::string& name : names_) {
    if (seen.insert(name).second) continue;
    throw InputError(InputPlace{.key = name},
                     fmt::format("two files have a column {}; rename one", shown(name)))
        .with_value(name, "one column of each name");
  }
  cells_.resize(names_.size());
}

void JoinedTables::add(const std::string& path, long rows, long least) {
  Part part{std::make_unique<TextTable>(path), 1};
  const TextTable& table = *part.table;
  if (rows != least) {
    if (rows % least != 0 || table.names().size() != 1 || rows / least > kMostLinesOfRow) {
      throw InputError(
          InputPlace{path},
          fmt::format("has {} rows, but another of the files has {}. Files that are read side by "
                      "side must have equally many rows; only a file with one column may have a "
                      "multiple of them",
                      rows, least))
          .with_value(std::to_string(rows), fmt::format("{} rows", least));
    }
    part.lines_of_row = static_cast<std::size_t>(rows / least);
  }
  const std::string stem = std::filesystem::path(path).stem().string();
  const std::size_t columns = table.names().size() * part.lines_of_row;
  for (std::size_t k = 0; k < columns; ++k) {
    const bool own = table.has_names() && part.lines_of_row == 1;
    const std::string name = table.has_names() && !own ? table.names()[0] : stem;
    names_.push_back(own ? table.names()[k] : columns == 1 ? name : fmt::format("{}[{}]", name, k));
    units_.push_back(table.units()[k / part.lines_of_row]);
  }
  decimal_comma_ = decimal_comma_ || table.decimal_comma();
  parts_.push_back(std::move(part));
}

bool JoinedTables::next() {
  std::size_t column = 0;
  for (Part& part : parts_) {
    for (std::size_t k = 0; k < part.lines_of_row; ++k) {
      if (!part.table->next()) return false;
      for (const std::string_view cell : part.table->cells()) cells_[column++] = cell;
    }
    decimal_comma_ = decimal_comma_ || part.table->decimal_comma();
  }
  views_.assign(cells_.begin(), cells_.end());
  return true;
}

long JoinedTables::cut_rows() const {
  long rows = 0;
  for (const Part& part : parts_) rows = std::max(rows, part.table->cut_rows());
  return rows;
}

std::string JoinedTables::description() const {
  return fmt::format("{} columns from {} files side by side", names_.size(), parts_.size());
}

}  // namespace armtune::internal
