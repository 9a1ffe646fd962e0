#include "tuner/planning/yardstick/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tuner/planning/tasks/given_states.hpp"
#include "tuner/record/words.hpp"

namespace armtune::internal {
namespace {

/// The columns of a rollout's table from which the events are found.
struct EventColumns {
  std::vector<double> time, state, gaze;
  std::vector<std::vector<double>> position, velocity, tool;

  EventColumns(const CsvTable& table, const RobotModel& robot)
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
  /// Returns the first row at or after t [s], or rows() if there is none.
  std::size_t row_at(double t) const {
    return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t - 1e-9) - time.begin());
  }

  static JointVector at_row(const std::vector<std::vector<double>>& columns, std::size_t row) {
    JointVector values(static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) values[static_cast<Eigen::Index>(i)] = columns[i][row];
    return values;
  }

  Event begin(EventKind kind, std::size_t row) const {
    Event event;
    event.kind = kind;
    event.time = time[row];
    event.gaze = gaze[row];
    event.state = static_cast<ControlState>(static_cast<int>(state[row]));
    event.position = at_row(position, row);
    event.velocity = at_row(velocity, row);
    return event;
  }

  /// Returns the first row of [first, end) in which the controller is in another state, or `end` if none is.
  std::size_t leaves(ControlState state_then, std::size_t first, std::size_t end) const {
    while (first < end && in(first, state_then)) ++first;
    return first;
  }

  /// Returns the first row of [first, end) from which the gaze angle stays below the threshold up to `end`.
  /// Returns `end` if the angle is not below it in the last of these rows.
  std::size_t settles(double threshold, std::size_t first, std::size_t end) const {
    while (end > first && gaze[end - 1] < threshold) --end;
    return end;
  }

  double path_error(const Path& path, std::size_t first, std::size_t last) const {
    double worst = 0.0;
    for (std::size_t row = first; row < last; ++row) {
      const Vec3 wanted = path.at(time[row]).position;
      for (int axis = 0; axis < 3; ++axis)
        worst = std::max(worst, std::abs(tool[static_cast<std::size_t>(axis)][row] - wanted[axis]));
    }
    return worst;
  }

  double nearest(const Scenario& scenario, std::size_t first, std::size_t last) const {
    double least = std::numeric_limits<double>::infinity();
    if (scenario.obstacles.empty()) return least;
    const RobotModel robot = plant_model(scenario);
    for (std::size_t row = first; row < last; ++row)
      least = std::min(least, clearance_at(robot, at_row(position, row), time[row], scenario.obstacles));
    return least;
  }

  /// Stores the path error and the least distance from obstacles in these rows, because a plan need not do
  /// better than the rollout.
  void keep(const Scenario& scenario, std::size_t first, std::size_t last, Event& event) const {
    event.path_error = path_error(scenario.path, first, last);
    event.nearest = nearest(scenario, first, last);
  }
};

void add_switches(const EventColumns& columns, const Scenario& scenario, double threshold,
                  std::vector<Event>& events) {
  double after = scenario.next_switch(0.0);
  while (after < columns.time.back()) {
    const double at = after;
    after = scenario.next_switch(at);
    const std::size_t first = columns.row_at(at);
    const std::size_t next = columns.row_at(after);
    if (first >= next || columns.in(first, ControlState::kLeaveSingularity)) continue;
    const std::size_t last = columns.in(first, ControlState::kFollowTrajectory)
                                 ? columns.leaves(ControlState::kFollowTrajectory, first, next)
                                 : next;
    Event event = columns.begin(EventKind::kSwitch, first);
    event.end = columns.time[std::min(last, columns.rows() - 1)];
    const std::size_t outside = columns.settles(threshold, first, last);
    const std::size_t for_good = columns.settles(threshold, first, next);
    event.settled = columns.time[std::min(for_good, columns.rows() - 1)] - event.time;
    std::size_t judged = last;  // end of the rows that path_error and nearest refer to
    if (outside < last) {
      event.outcome = outside == first ? EventOutcome::kAlreadyThere : EventOutcome::kReached;
      event.reached = columns.time[outside] - event.time;
      judged = std::min(last, columns.row_at(columns.time[outside] + kSwitchHold) + 1);
    } else {
      event.reached = NAN;
      event.outcome = last < next              ? EventOutcome::kCutByState
                      : next == columns.rows() ? EventOutcome::kCutByEnd
                                               : EventOutcome::kNotReached;
    }
    columns.keep(scenario, first, judged, event);
    events.push_back(event);
  }
}

void add_returns(const EventColumns& columns, const Scenario& scenario, std::vector<Event>& events) {
  for (std::size_t row = 1; row < columns.rows(); ++row) {
    if (!columns.in(row, ControlState::kReturnToTrajectory) ||
        columns.in(row - 1, ControlState::kReturnToTrajectory))
      continue;
    const std::size_t last = columns.leaves(ControlState::kReturnToTrajectory, row, columns.rows());
    Event event = columns.begin(EventKind::kReturn, row);
    event.end = columns.time[std::min(last, columns.rows() - 1)];
    event.outcome = last == columns.rows()                              ? EventOutcome::kCutByEnd
                    : columns.in(last, ControlState::kFollowTrajectory) ? EventOutcome::kReached
                                                                        : EventOutcome::kCutByState;
    event.reached = event.outcome == EventOutcome::kReached ? event.end - event.time : NAN;
    columns.keep(scenario, row, last, event);
    events.push_back(event);
  }
}

void add_laps(const EventColumns& columns, const Scenario& scenario, std::vector<Event>& events) {
  const double turn = scenario.path.period();
  if (turn == 0.0) return;
  std::size_t first = 0;
  while (first < columns.rows()) {
    while (first < columns.rows() && !columns.in(first, ControlState::kFollowTrajectory)) ++first;
    const std::size_t last =
        first < columns.rows() ? columns.row_at(columns.time[first] + turn) : columns.rows();
    if (last >= columns.rows()) return;
    const std::size_t row = columns.leaves(ControlState::kFollowTrajectory, first, last);
    if (row == last) {
      Event event = columns.begin(EventKind::kLap, first);
      event.end = columns.time[last];
      double sum = 0.0;
      for (std::size_t i = first; i < last; ++i) sum += columns.gaze[i] * columns.gaze[i];
      event.reached = std::sqrt(sum / static_cast<double>(last - first));
      columns.keep(scenario, first, last, event);
      event.times.assign(columns.time.begin() + static_cast<std::ptrdiff_t>(first),
                         columns.time.begin() + static_cast<std::ptrdiff_t>(last));
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

std::string words(EventOutcome outcome) {
  switch (outcome) {
    case EventOutcome::kReached:
      return "reached";
    case EventOutcome::kAlreadyThere:
      return kept_words::kAlreadyThere;
    case EventOutcome::kNotReached:
      return "not before the next switch";
    case EventOutcome::kCutByEnd:
      return "cut off by the end of the rollout";
    case EventOutcome::kCutByState:
      return "cut off by an obstacle";
  }
  return {};
}

std::vector<Event> events_of(const CsvTable& rollout, const Scenario& scenario, double gaze_threshold) {
  std::vector<Event> events;
  if (rollout.rows() < 2) return events;
  const EventColumns columns(rollout, *scenario.robot);
  add_switches(columns, scenario, gaze_threshold, events);
  add_returns(columns, scenario, events);
  add_laps(columns, scenario, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  return events;
}

}  // namespace armtune::internal
