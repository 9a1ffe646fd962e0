#include "sim/logs/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "sim/csv/line_cells.hpp"
#include "sim/logs/joined_tables.hpp"
#include "sim/logs/log_number.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostColumns = 10'000;

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t") == std::string_view::npos;
}

/// Returns the number of characters that begin a comment; 0 if the line is none.
std::size_t comment_mark(std::string_view line) {
  if (line.starts_with("//")) return 2;
  return line.starts_with('#') || line.starts_with('%') ? 1 : 0;
}

/// True if every cell is a number, a date or a word for a missing number, and at least one is a number.
bool all_numbers(const std::vector<std::string_view>& cells, bool decimal_comma) {
  bool any = false;
  for (const std::string_view cell : cells) {
    const auto value = read_log_number(cell, decimal_comma);
    if (!value && !is_date(cell)) return false;
    any = any || !value || std::isfinite(*value);
  }
  return any;
}

std::vector<std::string> copied(const std::vector<std::string_view>& cells) {
  return {cells.begin(), cells.end()};
}

void refuse_other_encodings(const std::string& path, std::string_view line) {
  const bool utf16 = line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF");
  if (!utf16 && line.find('\0') == std::string_view::npos) return;
  throw InputError(at_line(path, 1),
                   utf16 ? "the text is UTF-16; save the log as UTF-8"
                         : "this is not a text table; a log is a CSV file, a .mcap file or a .db3 file")
      .with_value({}, "text in UTF-8");
}

}  // namespace

std::unique_ptr<TableRows> open_table(const std::vector<std::string>& paths) {
  if (paths.size() == 1) return std::make_unique<TextTable>(paths.front());
  return std::make_unique<JoinedTables>(paths);
}

TextTable::TextTable(const std::string& path) : path_(path), lines_(path) {
  read_header();
  name_columns();
}

bool TextTable::next_line() {
  while (lines_.next()) {
    if (!is_blank(lines_.text())) return true;
  }
  return false;
}

void TextTable::find_shape(std::string_view line) {
  separator_ = find_separator(line);
  for (const char separator : {separator_, ';', '\t', ' '}) {
    const bool comma = separator != ',';
    split_cells(line, separator, cells_);
    if (!all_numbers(cells_, comma)) continue;
    separator_ = separator;
    decimal_comma_ = comma && line.find(',') != std::string_view::npos;
    return;
  }
  split_cells(line, separator_, cells_);
}

bool TextTable::holds_numbers() const {
  return all_numbers(cells_, decimal_comma_);
}

void TextTable::read_header() {
  std::string comment;
  bool first = true;
  while (true) {
    if (!next_line()) {
      throw InputError(InputPlace{path_}, "holds no rows; a log has column names and rows of numbers")
          .with_value({}, "rows of numbers");
    }
    std::string_view line = lines_.text();
    if (first) refuse_other_encodings(path_, line);
    if (first && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);  // byte order mark
    first = false;
    const std::size_t mark = comment_mark(line);
    if (mark == 0) {
      find_shape(line);
      break;
    }
    comment = line.substr(mark);
  }
  line_ = lines_.number();
  if (cells_.size() > kMostColumns) {
    throw InputError(at_line(path_, line_), fmt::format("has {} columns", cells_.size()))
        .with_value(std::to_string(cells_.size()), fmt::format("at most {} columns", kMostColumns));
  }
  std::vector<std::string_view> cells;
  split_cells(comment, separator_, cells);
  if (cells.size() != cells_.size()) split_cells(comment, find_separator(comment), cells);
  take_names(copied(cells));
}

void TextTable::take_names(const std::vector<std::string>& comment) {
  units_.assign(cells_.size(), "");
  waiting_ = holds_numbers();
  if (waiting_) {
    has_names_ = comment.size() == cells_.size();
    if (has_names_) names_ = comment;
    return;
  }
  has_names_ = true;
  names_ = copied(cells_);
  while (names_.size() > 1 && names_.back().empty()) names_.pop_back();  // a separator at the end
  units_.resize(names_.size());
  read_units();
}

void TextTable::read_units() {
  if (!next_line()) return;
  std::string_view line = lines_.text();
  split_cells(line, separator_, cells_);
  line_ = lines_.number();
  decimal_comma_ = separator_ != ',' && line.find(',') != std::string_view::npos;
  const bool fit = fits();
  const bool any_number = std::any_of(cells_.begin(), cells_.end(), [this](std::string_view cell) {
    return is_date(cell) || std::isfinite(read_log_number(cell, decimal_comma_).value_or(NAN));
  });
  const bool any_text =
      std::any_of(cells_.begin(), cells_.end(), [](auto cell) { return !read_log_number(cell); });
  waiting_ = any_number || !any_text || !fit;
  if (!waiting_) units_ = copied(cells_);
}

void TextTable::name_columns() {
  if (!has_names_) {
    names_.clear();
    for (std::size_t i = 0; i < cells_.size(); ++i) names_.push_back(std::to_string(i + 1));
    return;
  }
  std::map<std::string, int> count;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i].empty()) names_[i] = fmt::format("column {}", i + 1);
    ++count[names_[i]];
  }
  std::map<std::string, int> used;
  for (std::string& name : names_) {
    if (count[name] > 1) name = fmt::format("{}[{}]", name, used[name]++);
  }
  std::set<std::string> seen;
  for (const std::string& name : names_) {
    if (seen.insert(name).second) continue;
    throw InputError(at_line(path_, line_, name),
                     fmt::format("two columns are called {}; rename one", shown(name)))
        .with_value(name, "one column of each name");
  }
}

bool TextTable::fits() {
  while (cells_.size() > names_.size() && cells_.back().empty()) cells_.pop_back();
  return cells_.size() == names_.size();
}

bool TextTable::next() {
  if (!waiting_) {
    do {
      if (!next_line()) return false;
    } while (comment_mark(lines_.text()) > 0);
    split_cells(lines_.text(), separator_, cells_);
    line_ = lines_.number();
    if (!decimal_comma_ && separator_ != ',' && lines_.text().find(',') != std::string_view::npos)
      decimal_comma_ = true;
  }
  waiting_ = false;
  if (fits()) return true;
  const std::size_t count = cells_.size();
  if (count < names_.size() && !next_line()) {
    ++cut_rows_;
    return false;
  }
  throw InputError(at_line(path_, line_),
                   fmt::format("has {} cells, but the table has {} columns, separated by {}; repair this "
                               "line, or remove it",
                               count, names_.size(), separator_name(separator_)))
      .with_value(std::to_string(count), fmt::format("{} cells", names_.size()));
}

std::string TextTable::description() const {
  return fmt::format("{} columns separated by {}{}, {}", names_.size(), separator_name(separator_),
                     decimal_comma_ ? ", decimal commas" : "", has_names_ ? "with a header" : "no header");
}

}  // namespace armtune::internal
