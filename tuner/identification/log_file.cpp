#include "tuner/identification/log_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/common/error.hpp"
#include "core/common/nearest.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune {
namespace {

/// Largest deviation of a step in time from the period, relative: clocks print milliseconds.
constexpr double kJitter = 0.02;

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
    : path_(path), columns_(columns), file_(path, std::ios::binary) {
  if (!file_) throw InputError(fmt::format("{}: cannot be opened", path));
  if (!std::getline(file_, line_))
    throw InputError(fmt::format("{}: empty; a log begins with column names", path));
  ++line_number_;
  std::vector<std::string> header;
  for (const std::string_view cell : split(line_)) header.emplace_back(trimmed(cell));
  width_ = header.size();
  const auto place = [&](const LogColumn& column) {
    for (std::size_t i = 0; i < header.size(); ++i) {
      if (header[i] == column.name) return i;
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
  velocity_places_ = places(columns_.velocity);
  torque_places_ = places(columns_.torque);

  for (int i = 0; i < 2; ++i) {
    auto sample = read_sample();
    if (!sample) throw InputError(fmt::format("{}: {} rows of data; a log needs at least two", path, i));
    first_.push_back(std::move(*sample));
  }
  std::swap(first_[0], first_[1]);  // handed out from the back
}

bool LogFile::read_row() {
  if (!std::getline(file_, line_)) return false;
  ++line_number_;
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
  if (samples_ == 1) period_ = time - last_time_;
  if (samples_ > 0) {
    const double step = time - last_time_;
    if (!(step > 0.0)) {
      throw InputError(
          fmt::format("{}:{}: time {} does not grow after {}", path_, line_number_, time, last_time_));
    }
    if (std::abs(step - period_) > kJitter * period_) {
      throw InputError(fmt::format(
          "{}:{}: a step of {:.6g} s among steps of {:.6g} s; filters need even ones (within {} %): "
          "resample the log, or cut it where samples are missing and give both parts",
          path_, line_number_, step, period_, 100.0 * kJitter));
    }
  }
  last_time_ = time;
  ++samples_;
}

std::optional<LogSample> LogFile::read_sample() {
  if (!read_row()) return std::nullopt;
  LogSample sample;
  sample.time = number(time_place_, columns_.time);
  check_time(sample.time);
  sample.q = numbers(position_places_, columns_.position);
  sample.qd = numbers(velocity_places_, columns_.velocity);
  sample.torque = numbers(torque_places_, columns_.torque);
  return sample;
}

std::optional<LogSample> LogFile::next() {
  if (first_.empty()) return read_sample();
  LogSample sample = std::move(first_.back());
  first_.pop_back();
  return sample;
}

}  // namespace armtune
