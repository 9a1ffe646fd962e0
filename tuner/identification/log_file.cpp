#include "tuner/identification/log_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "sim/csv/line_cells.hpp"

namespace armtune::internal {
namespace {

/// Number of steps in a stretch. The period is the mean step of the first stretch. Both halves of the first
/// stretch, every further stretch and the remainder at the end must have the same mean step.
constexpr long kStretch = 500;
/// Largest deviation of one step from the period, relative. It allows for jitter of the time stamps; a
/// missing sample deviates by 1.
constexpr double kJitter = 0.5;
/// Largest deviation of a stretch's mean step, relative, in addition to the effect of jitter at its two ends.
constexpr double kDrift = 0.01;
/// Largest accepted value, in SI units. No arm reaches it, and sums of its squares can be represented.
constexpr double kLargest = 1e9;
/// Largest number of column names that a message lists.
constexpr std::size_t kShownNames = 20;

/// Returns the cell as a number, or nothing if it is not a finite number.
std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t") == std::string_view::npos;
}

std::string listed(const std::vector<std::string>& names) {
  const std::size_t count = std::min(names.size(), kShownNames);
  return fmt::format("{}{}",
                     fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count), ", "),
                     count < names.size() ? fmt::format(" and {} more", names.size() - count) : "");
}

}  // namespace

LogFile::LogFile(const std::string& path, const LogColumns& columns)
    : path_(path), columns_(columns), lines_(path) {
  read_header();
  time_place_ = place_of(columns_.time);
  position_places_ = places_of(columns_.position);
  const auto has = [&](const LogColumn& column) {
    return std::find(header_.begin(), header_.end(), column.name) != header_.end();
  };
  if (columns_.velocity_optional && std::none_of(columns_.velocity.begin(), columns_.velocity.end(), has)) {
    columns_.velocity.clear();
  }
  velocity_places_ = places_of(columns_.velocity);
  torque_places_ = places_of(columns_.torque);
  read_ahead();
}

void LogFile::read_header() {
  do {
    if (!lines_.next())
      throw InputError(InputPlace{path_}, "is empty; a log begins with column names")
          .with_value({}, "a line of column names");
  } while (is_blank(lines_.text()));
  header_line_ = lines_.number();
  std::string_view line = lines_.text();
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  separator_ = find_separator(line);
  split_cells(line, separator_, cells_);
  has_names_ =
      !std::all_of(cells_.begin(), cells_.end(), [](auto cell) { return number_in(cell).has_value(); });
  for (std::size_t i = 0; i < cells_.size(); ++i)
    header_.push_back(has_names_ ? std::string(cells_[i]) : std::to_string(i + 1));
  if (!has_names_) lines_.repeat();
}

std::size_t LogFile::place_of(const LogColumn& column) const {
  const auto found = std::find(header_.begin(), header_.end(), column.name);
  if (found == header_.end()) {
    if (!has_names_) {
      throw InputError(
          at_line(path_, header_line_, column.name),
          fmt::format(
              "there is no column '{}', because the first line holds numbers and no names; add a line of "
              "names, or call the {} columns \"1\", \"2\" and so on in a column map (--columns FILE)",
              column.name, header_.size()))
          .with_value({}, fmt::format("a column '{}'", column.name));
    }
    throw InputError(
        at_line(path_, header_line_, column.name),
        fmt::format("there is no column '{}'{}; the columns, separated by {}, are: {}. Name the right "
                    "columns in a column map (--columns FILE)",
                    column.name, suggestion(column.name, header_), separator_name(separator_),
                    listed(header_)))
        .with_value({}, fmt::format("a column '{}'", column.name));
  }
  if (std::find(found + 1, header_.end(), column.name) == header_.end())
    return static_cast<std::size_t>(found - header_.begin());
  throw InputError(at_line(path_, header_line_, column.name),
                   fmt::format("two columns are called '{}'; remove or rename one", column.name))
      .with_value(column.name, "one column of each name");
}

std::vector<std::size_t> LogFile::places_of(const std::vector<LogColumn>& columns) const {
  std::vector<std::size_t> places;
  places.reserve(columns.size());
  for (const LogColumn& column : columns) places.push_back(place_of(column));
  return places;
}

void LogFile::read_ahead() {
  while (samples_ <= kStretch) {
    auto sample = read_sample();
    if (!sample) break;
    ahead_.push_back(std::move(*sample));
  }
  if (samples_ < 2) {
    throw InputError(InputPlace{path_},
                     fmt::format("has {} rows of data; a log needs at least two", samples_))
        .with_value(std::to_string(samples_), "at least 2 rows");
  }
  period_ = (ahead_.back().time - ahead_.front().time) / static_cast<double>(samples_ - 1);
  const std::size_t half = ahead_.size() / 2;
  check_rate(ahead_[half].time - ahead_.front().time, static_cast<long>(half));
  check_rate(ahead_.back().time - ahead_[half].time, samples_ - 1 - static_cast<long>(half));
  stretch_begin_ = ahead_.back().time;
  for (std::size_t k = 1; k < ahead_.size(); ++k) {
    check_step(ahead_[k].time - ahead_[k - 1].time,
               header_line_ + static_cast<long>(k) + (has_names_ ? 1 : 0));
  }
}

void LogFile::check_rate(double duration, long steps) const {
  if (steps < 1) return;
  const double mean = duration / static_cast<double>(steps);
  if (std::abs(mean - period_) <= (kDrift + 2.0 * kJitter / static_cast<double>(steps)) * period_) return;
  throw InputError(
      at_line(path_, lines_.number(), columns_.time.name),
      fmt::format("up to this line the mean time step is {:.6g} s, but at the start of the log it is "
                  "{:.6g} s; the filters need one rate (within {} %), so resample the log",
                  mean, period_, 100.0 * kDrift))
      .with_value(fmt::format("{:.6g}", mean),
                  fmt::format("one rate: {:.6g} s within {} %", period_, 100.0 * kDrift));
}

void LogFile::check_step(double step, long line) const {
  if (std::abs(step - period_) < kJitter * period_) return;
  throw InputError(
      at_line(path_, line, columns_.time.name),
      fmt::format("a step of {:.6g} s, but the mean step is {:.6g} s; the filters need equal steps "
                  "(within {} %). Resample the log, or split it where samples are missing and give both "
                  "parts",
                  step, period_, 100.0 * kJitter))
      .with_value(fmt::format("{:.6g}", step),
                  fmt::format("equal steps: {:.6g} s within {} %", period_, 100.0 * kJitter));
}

bool LogFile::read_row() {
  if (!lines_.next()) return false;
  if (is_blank(lines_.text())) {
    const long empty = lines_.number();
    while (lines_.next()) {
      if (!is_blank(lines_.text()))
        throw InputError(at_line(path_, empty), "an empty line inside the log; remove it")
            .with_value({}, "a row of numbers");
    }
    return false;
  }
  split_cells(lines_.text(), separator_, cells_);
  if (cells_.size() != header_.size()) {
    const std::string_view line = lines_.text();
    if (std::count(line.begin(), line.end(), '"') % 2 != 0) {
      throw InputError(at_line(path_, lines_.number()),
                       "a quoted text spans several lines; remove its column, or the line breaks inside it")
          .with_value({}, "texts of one line");
    }
    throw InputError(at_line(path_, lines_.number()),
                     fmt::format("has {} cells, but the first line has {}; the log may have been cut off",
                                 cells_.size(), header_.size()))
        .with_value(std::to_string(cells_.size()), fmt::format("{} cells", header_.size()));
  }
  return true;
}

double LogFile::read_number(std::size_t column, const LogColumn& what) const {
  const std::string_view text = cells_[column];
  if (const auto value = number_in(text)) return *value;
  const bool decimal_comma = separator_ != ',' && text.find(',') != std::string_view::npos;
  throw InputError(at_line(path_, lines_.number(), what.name),
                   fmt::format("column '{}': {} is not a finite number{}", what.name, shown(text),
                               decimal_comma ? "; write decimal points, not commas" : ""))
      .with_value(std::string(text), "a finite number");
}

double LogFile::read_value(std::size_t column, const LogColumn& what) const {
  const double value = read_number(column, what);
  if (std::abs(value * what.scale) <= kLargest) return value * what.scale;
  throw InputError(
      at_line(path_, lines_.number(), what.name),
      fmt::format(
          "column '{}': the value {}, multiplied by its scale {}, exceeds {:.0e} in size; remove the row, "
          "or correct the scale",
          what.name, value, what.scale, kLargest))
      .with_value(std::string(cells_[column]), fmt::format("at most {:.0e} in size", kLargest));
}

JointVector LogFile::read_values(const std::vector<std::size_t>& places,
                                 const std::vector<LogColumn>& columns) const {
  JointVector values(static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = read_value(places[i], columns[i]);
  }
  return values;
}

double LogFile::read_time() {
  const double stamp = read_number(time_place_, columns_.time);
  // The first time stamp is subtracted before scaling, so that Unix time stamps keep their digits.
  if (samples_ == 0) first_time_ = stamp;
  const double time = (stamp - first_time_) * columns_.time.scale;
  check_time(time);
  return time;
}

void LogFile::check_time(double time) {
  if (samples_ > 0 && !(time > last_time_)) {
    throw InputError(
        at_line(path_, lines_.number(), columns_.time.name),
        fmt::format("column '{}': {} is not above the value of the row before; sort the rows by time, "
                    "or remove this row",
                    columns_.time.name, shown(cells_[time_place_])))
        .with_value(std::string(cells_[time_place_]), "above the value of the row before");
  }
  if (samples_ > kStretch) {
    check_step(time - last_time_, lines_.number());
    if (++stretch_steps_ == kStretch) {
      check_rate(time - stretch_begin_, stretch_steps_);
      stretch_begin_ = time;
      stretch_steps_ = 0;
    }
  }
  last_time_ = time;
  ++samples_;
}

std::optional<LogSample> LogFile::read_sample() {
  if (!read_row()) {
    check_rate(last_time_ - stretch_begin_, stretch_steps_);
    return std::nullopt;
  }
  LogSample sample;
  sample.time = read_time();
  sample.q = read_values(position_places_, columns_.position);
  sample.qd = read_values(velocity_places_, columns_.velocity);
  sample.torque = read_values(torque_places_, columns_.torque);
  return sample;
}

std::optional<LogSample> LogFile::next() {
  if (ahead_.empty()) return read_sample();
  LogSample sample = std::move(ahead_.front());
  ahead_.pop_front();
  return sample;
}

}  // namespace armtune::internal
