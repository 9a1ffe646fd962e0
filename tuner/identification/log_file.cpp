#include "tuner/identification/log_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/common/error.hpp"
#include "core/common/nearest.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune {
namespace {

/// Steps that the period is the mean of. Every further such stretch must have it, both halves of the first
/// one and what is left at the end, too.
constexpr long kStretch = 500;
/// Largest deviation of one step from the period, relative: time stamps jitter. A missing sample is 1.
constexpr double kJitter = 0.5;
/// Largest deviation of a stretch's mean step, relative, beside what the jitter of its two ends makes.
constexpr double kDrift = 0.01;
constexpr std::size_t kMaxLineBytes = 1U << 20;
/// In SI units: beyond every arm, within what the sums of squares hold.
constexpr double kLargest = 1e9;

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(line.substr(begin, comma == std::string_view::npos ? comma : comma - begin));
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\"");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\"") - begin + 1);
}

std::vector<LogColumn> read_columns(const yaml::Node& node, const std::vector<std::string>& joints) {
  yaml::MapReader map(node);
  const double scale = map.number("scale", 1.0);
  const yaml::Node& names = map.required("columns");
  std::vector<LogColumn> columns;
  columns.reserve(joints.size());
  if (names.kind() == yaml::Node::Kind::kSequence) {
    for (const std::string& name : names.as_strings()) columns.push_back({name, scale});
    if (columns.size() != joints.size()) {
      names.fail(fmt::format("{} columns; the arm has {} joints: {}", columns.size(), joints.size(),
                             fmt::join(joints, " ")));
    }
  } else {
    yaml::MapReader by_joint(names);
    for (const std::string& joint : joints) columns.push_back({by_joint.required(joint).as_string(), scale});
    by_joint.finish();
  }
  map.finish();
  return columns;
}

}  // namespace

LogColumns default_log_columns(const RobotModel& model) {
  LogColumns columns;
  columns.time.name = "time";
  columns.velocity_optional = true;
  for (const std::string& joint : joint_names(model)) {
    columns.position.push_back({"joint/" + joint + "/position"});
    columns.velocity.push_back({"joint/" + joint + "/velocity"});
    columns.torque.push_back({"joint/" + joint + "/torque"});
  }
  return columns;
}

LogColumns load_log_columns(const std::string& path, const RobotModel& model) {
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  const auto joints = joint_names(model);
  LogColumns columns;
  columns.time.name = map.string("time", "time");
  columns.time.scale = map.number("time_scale", 1.0);
  columns.position = read_columns(map.required("position"), joints);
  if (const yaml::Node* node = map.optional("velocity")) columns.velocity = read_columns(*node, joints);
  columns.torque = read_columns(map.required("torque"), joints);
  map.finish();
  return columns;
}

LogFile::LogFile(const std::string& path, const LogColumns& columns)
    : path_(path), columns_(columns), file_(path, std::ios::binary), buffer_(kMaxLineBytes) {
  if (!file_) throw InputError(fmt::format("{}: cannot be opened", path));
  if (!read_line()) throw InputError(fmt::format("{}: empty; a log begins with column names", path));
  std::vector<std::string> header;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line_.starts_with(kByteOrderMark)) line_.remove_prefix(kByteOrderMark.size());
  for (const std::string_view cell : split(line_)) header.emplace_back(trimmed(cell));
  width_ = header.size();
  const auto place = [&](const LogColumn& column) {
    const auto found = std::find(header.begin(), header.end(), column.name);
    if (found != header.end()) {
      if (std::find(found + 1, header.end(), column.name) == header.end())
        return static_cast<std::size_t>(found - header.begin());
      throw InputError(
          fmt::format("{}:1: two columns are called '{}'; remove or rename one", path, column.name));
    }
    throw InputError(fmt::format("{}:1: no column '{}'{}; --columns FILE says which columns hold what", path,
                                 column.name, suggestion(column.name, header)));
  };
  const auto places = [&](const std::vector<LogColumn>& list) {
    std::vector<std::size_t> found;
    found.reserve(list.size());
    for (const LogColumn& column : list) found.push_back(place(column));
    return found;
  };
  time_place_ = place(columns_.time);
  position_places_ = places(columns_.position);
  const auto has = [&](const LogColumn& column) {
    return std::find(header.begin(), header.end(), column.name) != header.end();
  };
  if (columns_.velocity_optional && std::none_of(columns_.velocity.begin(), columns_.velocity.end(), has)) {
    columns_.velocity.clear();
  }
  velocity_places_ = places(columns_.velocity);
  torque_places_ = places(columns_.torque);

  read_ahead();
}

void LogFile::read_ahead() {
  while (samples_ <= kStretch) {
    auto sample = read_sample();
    if (!sample) break;
    ahead_.push_back(std::move(*sample));
  }
  if (samples_ < 2) {
    throw InputError(fmt::format("{}: {} rows of data; a log needs at least two", path_, samples_));
  }
  period_ = (ahead_.back().time - ahead_.front().time) / static_cast<double>(samples_ - 1);
  const std::size_t half = ahead_.size() / 2;
  check_rate(ahead_[half].time - ahead_.front().time, static_cast<long>(half));
  check_rate(ahead_.back().time - ahead_[half].time, samples_ - 1 - static_cast<long>(half));
  stretch_begin_ = ahead_.back().time;
  for (std::size_t k = 1; k < ahead_.size(); ++k) {
    check_step(ahead_[k].time - ahead_[k - 1].time, static_cast<long>(k) + 2);  // line 1 holds the names
  }
}

void LogFile::check_rate(double duration, long steps) const {
  if (steps < 1) return;
  const double mean = duration / static_cast<double>(steps);
  if (std::abs(mean - period_) <= (kDrift + 2.0 * kJitter / static_cast<double>(steps)) * period_) return;
  throw InputError(fmt::format(
      "{}:{}: {} steps take {:.6g} s each, the first ones {:.6g} s; filters need one rate (within {} %): "
      "resample the log",
      path_, line_number_, steps, mean, period_, 100.0 * kDrift));
}

void LogFile::check_step(double step, long line) const {
  if (std::abs(step - period_) < kJitter * period_) return;
  throw InputError(
      fmt::format("{}:{}: a step of {:.6g} s among steps of {:.6g} s; filters need even ones (within {} %): "
                  "resample the log, or cut it where samples are missing and give both parts",
                  path_, line, step, period_, 100.0 * kJitter));
}

bool LogFile::read_line() {
  file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  if (file_.eof() && file_.gcount() == 0) return false;
  ++line_number_;
  if (file_.fail()) {
    throw InputError(fmt::format(
        "{}:{}: {}", path_, line_number_,
        file_.bad() ? "cannot be read" : "a line of more than 1 MB; a log has a row of numbers a line"));
  }
  // What was read includes the line end, but for a last line without one.
  line_ = std::string_view(buffer_.data(), static_cast<std::size_t>(file_.gcount()) - (file_.eof() ? 0 : 1));
  return true;
}

bool LogFile::read_row() {
  if (!read_line()) return false;
  if (trimmed(line_).empty()) {
    // Only a line break at the very end may follow.
    if (file_.peek() == std::ifstream::traits_type::eof()) return false;
    throw InputError(fmt::format("{}:{}: empty line inside the log", path_, line_number_));
  }
  cells_ = split(line_);
  if (cells_.size() != width_) {
    throw InputError(fmt::format("{}:{}: {} cells, the header has {}; the log may have been cut off", path_,
                                 line_number_, cells_.size(), width_));
  }
  return true;
}

double LogFile::number(std::size_t column, const LogColumn& what) const {
  const std::string_view text = trimmed(cells_[column]);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw InputError(fmt::format("{}:{}: column '{}': '{}' is no finite number", path_, line_number_,
                                 what.name, text.substr(0, 40)));
  }
  if (!(std::abs(value * what.scale) <= kLargest)) {
    throw InputError(fmt::format(
        "{}:{}: column '{}': {} times its scale {} is beyond {:.0e}; take the row out, or mend the unit",
        path_, line_number_, what.name, value, what.scale, kLargest));
  }
  return value * what.scale;
}

JointVector LogFile::numbers(const std::vector<std::size_t>& places,
                             const std::vector<LogColumn>& columns) const {
  JointVector values(static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = number(places[i], columns[i]);
  }
  return values;
}

void LogFile::check_time(double time) {
  if (samples_ > 0 && !(time > last_time_)) {
    throw InputError(
        fmt::format("{}:{}: time {} does not grow after {}", path_, line_number_, time, last_time_));
  }
  if (samples_ > kStretch) {
    check_step(time - last_time_, line_number_);
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
  sample.time = number(time_place_, columns_.time);
  check_time(sample.time);
  sample.q = numbers(position_places_, columns_.position);
  sample.qd = numbers(velocity_places_, columns_.velocity);
  sample.torque = numbers(torque_places_, columns_.torque);
  return sample;
}

std::optional<LogSample> LogFile::next() {
  if (ahead_.empty()) return read_sample();
  LogSample sample = std::move(ahead_.front());
  ahead_.pop_front();
  return sample;
}

}  // namespace armtune
