#include "tuner/planning/tasks/controller_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/control/state_machine.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/data_files.hpp"

namespace armtune::internal {
namespace {

constexpr double kApart = 0.05;  // largest distance in time between the nearest row and the task's start [s]

std::size_t nearest_row(const std::vector<double>& time, const PlanTask& task) {
  std::size_t row = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (std::abs(time[i] - task.at) < std::abs(time[row] - task.at)) row = i;
  }
  if (time.empty() || !(std::abs(time[row] - task.at) <= kApart))
    throw InputError(
        InputPlace{shown_path(task.start.rollout), 0, "time"},
        fmt::format("no row lies within {} s of {} s, where the task {} begins; give a rollout that "
                    "covers this time, or change 'at' in the task",
                    kApart, task.at, task.name))
        .with_value({}, fmt::format("a row within {} s of {} s", kApart, task.at));
  return row;
}

/// Returns the time derivatives of `values`, from differences of neighbouring columns.
Eigen::MatrixXd slopes(const Eigen::MatrixXd& values, const std::vector<double>& time) {
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  const Eigen::Index last = values.cols() - 1;
  for (Eigen::Index k = 0; k <= last && last > 0; ++k) {
    const Eigen::Index before = std::max<Eigen::Index>(k - 1, 0);
    const Eigen::Index after = std::min(k + 1, last);
    found.col(k) = (values.col(after) - values.col(before)) /
                   (time[static_cast<std::size_t>(after)] - time[static_cast<std::size_t>(before)]);
  }
  return found;
}

/// Returns the time [s] after which the gaze stays within its threshold up to the next switch (kSwitch), or
/// after which the path is followed again (kReturn). Returns nothing if there is no such time.
std::optional<double> time_to_end(const PlanTask& task, const CsvTable& table,
                                  const std::vector<double>& time, std::size_t first) {
  if (task.kind == PlanKind::kSwitch) {
    const std::vector<double> gaze = table.numbers(table.column("gaze/angle"));
    const double until = task.scenario.next_switch(task.at + task.scenario.control_period);
    std::optional<double> reached = 0.0;
    for (std::size_t i = first; i < time.size() && time[i] < until; ++i) {
      if (gaze[i] > task.gaze_threshold)
        reached = i + 1 < time.size() && time[i + 1] < until ? std::optional(time[i + 1] - time[first])
                                                             : std::nullopt;
    }
    return reached;
  }
  if (task.kind == PlanKind::kReturn) {
    const std::vector<double> state = table.numbers(table.column("state"));
    for (std::size_t i = first; i < time.size(); ++i) {
      if (state[i] == static_cast<double>(ControlState::kFollowTrajectory)) return time[i] - time[first];
    }
  }
  return {};
}

}  // namespace

ControllerMotion controller_motion(const PlanTask& task, const RobotModel& robot) {
  const auto table = CsvTable::read(task.start.rollout, CsvOrigin::kUser);
  const std::vector<double> time = table.numbers(table.column("time"));
  const std::size_t first = nearest_row(time, task);
  ControllerMotion found;
  Trajectory& motion = found.motion;
  motion.time.assign(time.begin() + static_cast<std::ptrdiff_t>(first), time.end());
  motion.durations = {motion.time.back() - motion.time.front()};
  const auto rows = static_cast<Eigen::Index>(motion.time.size());
  motion.position.resize(robot.n(), rows);
  motion.velocity.resize(robot.n(), rows);
  const auto read = [&](int joint, const char* what, Eigen::MatrixXd& into) {
    const std::string column = "joint/" + robot.joints[static_cast<std::size_t>(joint)].name + "/" + what;
    const std::vector<double> values = table.numbers(table.column(column));
    for (Eigen::Index k = 0; k < rows; ++k) {
      const std::size_t row = first + static_cast<std::size_t>(k);
      if (!std::isfinite(values[row]))
        throw InputError(at_line(shown_path(task.start.rollout), row + 2, column),
                         fmt::format("the row at {} s has no finite value of {}; give a complete rollout, or "
                                     "another 'start'",
                                     time[row], column))
            .with_value({}, "a finite number");
      into(joint, k) = values[row];
    }
  };
  for (int i = 0; i < robot.n(); ++i) {
    read(i, "position", motion.position);
    read(i, "velocity", motion.velocity);
  }
  motion.acceleration = slopes(motion.velocity, motion.time);
  found.reached = time_to_end(task, table, time, first);
  return found;
}

}  // namespace armtune::internal
