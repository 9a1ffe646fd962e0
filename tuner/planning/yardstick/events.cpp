#include "tuner/planning/yardstick/events.hpp"

#include <algorithm>
#include <cmath>

#include "core/control/state_machine.hpp"

namespace armtune {
namespace {

/// The columns of a rollout that events are read from.
struct Columns {
  std::vector<double> time, state, gaze;
  std::vector<std::vector<double>> position, velocity, tool;

  Columns(const report::CsvTable& table, const RobotModel& robot)
      : time(table.numbers(table.column("time"))),
        state(table.numbers(table.column("state"))),
        gaze(table.numbers(table.column("gaze/angle"))) {
    for (const std::string& joint : joint_names(robot)) {
      position.push_back(table.numbers(table.column("joint/" + joint + "/position")));
      velocity.push_back(table.numbers(table.column("joint/" + joint + "/velocity")));
    }
    for (const char* axis : {"x", "y", "z"})
      tool.push_back(table.numbers(table.column(std::string("tool/position/") + axis)));
  }

  std::size_t rows() const { return time.size(); }
  bool in(std::size_t row, ControlState wanted) const { return state[row] == static_cast<double>(wanted); }
  /// First row at or after t; rows() if there is none.
  std::size_t row_at(double t) const {
    return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t - 1e-9) - time.begin());
  }

  Event begin(EventKind kind, std::size_t row) const {
    Event event;
    event.kind = kind;
    event.time = time[row];
    event.position.resize(static_cast<Eigen::Index>(position.size()));
    event.velocity.resize(static_cast<Eigen::Index>(position.size()));
    for (std::size_t i = 0; i < position.size(); ++i) {
      event.position[static_cast<Eigen::Index>(i)] = position[i][row];
      event.velocity[static_cast<Eigen::Index>(i)] = velocity[i][row];
    }
    return event;
  }

  double path_error(const HarmonicPath& path, std::size_t first, std::size_t last) const {
    double worst = 0.0;
    for (std::size_t row = first; row < last; ++row) {
      const Vec3 wanted = path.at(time[row]).position;
      for (int axis = 0; axis < 3; ++axis)
        worst = std::max(worst, std::abs(tool[static_cast<std::size_t>(axis)][row] - wanted[axis]));
    }
    return worst;
  }
};

void add_switches(const Columns& columns, const Scenario& scenario, double threshold,
                  std::vector<Event>& events) {
  if (!(scenario.switch_every > 0.0) || scenario.targets.size() < 2) return;
  for (int turn = 1; turn * scenario.switch_every < columns.time.back(); ++turn) {
    const double at = turn * scenario.switch_every;
    const std::size_t first = columns.row_at(at);
    const std::size_t last = std::min(columns.row_at(at + scenario.switch_every), columns.rows());
    if (first >= last || !columns.in(first, ControlState::kFollowTrajectory)) continue;
    Event event = columns.begin(EventKind::kSwitch, first);
    event.end = columns.time[last - 1];
    std::size_t outside = first;  // one behind the last row outside
    for (std::size_t row = first; row < last; ++row) {
      if (columns.gaze[row] >= threshold) outside = row + 1;
    }
    event.reached = outside == last ? NAN : columns.time[outside] - event.time;
    event.path_error = columns.path_error(scenario.path, first, last);
    events.push_back(event);
  }
}

void add_returns(const Columns& columns, const Scenario& scenario, std::vector<Event>& events) {
  for (std::size_t row = 1; row < columns.rows(); ++row) {
    if (!columns.in(row, ControlState::kReturnToTrajectory) ||
        columns.in(row - 1, ControlState::kReturnToTrajectory))
      continue;
    std::size_t last = row;
    while (last < columns.rows() && columns.in(last, ControlState::kReturnToTrajectory)) ++last;
    Event event = columns.begin(EventKind::kReturn, row);
    event.end = columns.time[std::min(last, columns.rows() - 1)];
    const bool arrived = last < columns.rows() && columns.in(last, ControlState::kFollowTrajectory);
    event.reached = arrived ? columns.time[last] - event.time : NAN;
    event.path_error = columns.path_error(scenario.path, row, last);
    events.push_back(event);
  }
}

void add_laps(const Columns& columns, const Scenario& scenario, std::vector<Event>& events) {
  if (scenario.path.frequency == 0.0) return;
  const double turn = 2.0 * M_PI / std::abs(scenario.path.frequency);
  std::size_t first = 0;
  while (first < columns.rows()) {
    while (first < columns.rows() && !columns.in(first, ControlState::kFollowTrajectory)) ++first;
    const std::size_t last =
        first < columns.rows() ? columns.row_at(columns.time[first] + turn) : columns.rows();
    if (last >= columns.rows()) return;
    std::size_t row = first;
    while (row < last && columns.in(row, ControlState::kFollowTrajectory)) ++row;
    if (row == last) {
      Event event = columns.begin(EventKind::kLap, first);
      event.end = columns.time[last];
      double sum = 0.0;
      for (std::size_t i = first; i < last; ++i) sum += columns.gaze[i] * columns.gaze[i];
      event.reached = std::sqrt(sum / static_cast<double>(last - first));
      event.path_error = columns.path_error(scenario.path, first, last);
      events.push_back(event);
    }
    first = row;
  }
}

}  // namespace

std::string name(EventKind kind) {
  switch (kind) {
    case EventKind::kSwitch:
      return "switch";
    case EventKind::kReturn:
      return "return";
    case EventKind::kLap:
      return "lap";
  }
  return {};
}

std::string unit(EventKind kind) {
  return kind == EventKind::kLap ? "rad" : "s";
}

std::vector<Event> events_of(const report::CsvTable& rollout, const Scenario& scenario,
                             double gaze_threshold) {
  std::vector<Event> events;
  if (rollout.rows() < 2) return events;
  const Columns columns(rollout, *scenario.robot);
  add_switches(columns, scenario, gaze_threshold, events);
  add_returns(columns, scenario, events);
  add_laps(columns, scenario, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  return events;
}

}  // namespace armtune
