#include "sim/logs/csv_log.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "sim/logs/log_number.hpp"

namespace armtune::internal {
namespace {

/// Number of rows in which a column must have a number to be a channel.
constexpr long kSearchedRows = 1000;

std::unique_ptr<TableRows> open_rows(const std::vector<std::string>& paths) {
  return open_table(paths);
}

TimeColumns time_of(const std::vector<std::string>& paths, const TimeOptions& options) {
  const auto rows = open_rows(paths);
  return find_time_columns(*rows, options);
}

std::string time_name(const TableRows& rows, const TimeColumns& time) {
  return time.column ? rows.names()[*time.column] : std::string();
}

}  // namespace

CsvLog::CsvLog(const std::vector<std::string>& paths, const TimeOptions& options)
    : rows_(open_rows(paths)),
      time_(time_of(paths, options)),
      order_(rows_->file(), time_name(*rows_, time_)) {
  find_channels(paths);
}

void CsvLog::find_channels(const std::vector<std::string>& paths) {
  const auto rows = open_rows(paths);
  const std::size_t columns = rows->names().size();
  std::vector<bool> number(columns, false);
  std::vector<bool> text(columns, false);
  long searched = 0;
  for (; searched < kSearchedRows && rows->next(); ++searched) {
    for (std::size_t c = 0; c < columns; ++c) {
      const auto value = read_log_number(rows->cells()[c], rows->decimal_comma());
      if (!value) text[c] = true;
      if (value && std::isfinite(*value)) number[c] = true;
    }
  }
  if (searched == 0)
    throw InputError(InputPlace{rows->file()}, "holds no rows below its header")
        .with_value("0", "rows of numbers");
  for (std::size_t c = 0; c < columns; ++c) {
    if (time_.is_time(c)) continue;
    if (text[c] && !number[c]) {
      skipped_.push_back(rows->names()[c]);
      continue;
    }
    places_.push_back(c);
    channels_.push_back(rows->names()[c]);
    units_.push_back(rows->units()[c]);
  }
  if (channels_.empty())
    throw InputError(InputPlace{rows->file()}, "has no column of numbers beside the time")
        .with_value({}, "a column of numbers");
}

std::string CsvLog::description() const {
  return fmt::format("{}\n{}", rows_->description(), time_.reason);
}

bool CsvLog::read_time(LogRow& row) {
  row.line = rows_->line();
  if (!time_.column) {
    row.time = static_cast<double>(read_++) * time_.scale;
    return true;
  }
  const std::string_view cell = rows_->cells()[*time_.column];
  const auto stamp = time_.stamp(rows_->cells(), rows_->decimal_comma());
  if (!stamp) {
    const auto missing = read_log_number(cell, rows_->decimal_comma());
    if (missing && std::isnan(*missing)) {
      order_.count_row_without_time();
      return false;
    }
    const std::string name = time_name(*rows_, time_);
    throw InputError(
        at_line(rows_->file(), row.line, name),
        fmt::format("column {}: {} is not a time stamp{}", shown(name), shown(cell),
                    cell == name ? "; the header is repeated, so the recording was restarted here: "
                                   "split the log here and give both parts"
                                 : "; correct it, or remove the row"))
        .with_value(std::string(cell), "a number or a date and time");
  }
  if (read_++ == 0) {
    first_ = *stamp;
    start_ = (static_cast<double>(first_.whole) + first_.fraction) * time_.scale;
  }
  row.time = (*stamp - first_) * time_.scale;
  return true;
}

double CsvLog::read_value(std::size_t column) const {
  const std::string_view cell = rows_->cells()[column];
  if (const auto value = read_log_number(cell, rows_->decimal_comma())) return *value;
  const std::string& name = rows_->names()[column];
  throw InputError(
      at_line(rows_->file(), rows_->line(), name),
      fmt::format("column {}: {} is not a number; correct it, or leave the cell empty if the value "
                  "is missing",
                  shown(name), shown(cell)))
      .with_value(std::string(cell), "a number");
}

bool CsvLog::read_row() {
  while (rows_->next()) {
    if (!read_time(row_)) continue;
    row_.value.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) row_.value[i] = read_value(places_[i]);
    return true;
  }
  return false;
}

bool CsvLog::next(LogRow& row) {
  while (!order_.pop(row, at_end_)) {
    if (at_end_) return false;
    if (read_row()) {
      order_.push(row_);
      continue;
    }
    at_end_ = true;
    order_.count_cut_rows(rows_->cut_rows());
    order_.check_bounds();
  }
  return true;
}

}  // namespace armtune::internal
