#pragma once
// The column map of `armtune identify --columns FILE`. It names the columns of a log that hold the time and
// each joint's position, velocity and torque, and gives their units.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// A column's name, and the factor that converts its numbers to SI units.
struct LogColumn {
  std::string name;
  double scale = 1.0;
};

/// The columns of a log, with joints in the model's order.
struct LogColumns {
  LogColumn time;
  std::vector<LogColumn> position;
  std::vector<LogColumn> velocity;  ///< n columns; empty if the log has no velocities
  std::vector<LogColumn> torque;
  bool velocity_optional = false;  ///< true: a log may lack all of the velocity columns
};

/// Returns the columns that armtune itself writes: `time`, `joint/NAME/position`, `joint/NAME/torque` and, as
/// optional columns, `joint/NAME/velocity`.
LogColumns default_log_columns(const RobotModel& model);

/// Reads the columns from a YAML file with `time`, `time_scale`, `position`, `velocity` (optional) and
/// `torque`. Each of the last three has `columns`, a list of n column names or a map from joint names to
/// column names, and may have `scale`: one number, a list of n numbers or a map from joint names to numbers.
/// `units` (file_units.hpp) gives the units of all columns at once; velocities are always per second. Throws
/// InputError if the file does not have this form.
LogColumns load_log_columns(const std::string& path, const RobotModel& model);

}  // namespace armtune::internal
