#pragma once
// Which columns of a log hold what, and in which units: the column map of `armtune identify --columns`.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// A column's name, and the factor that makes its numbers SI.
struct LogColumn {
  std::string name;
  double scale = 1.0;
};

/// Columns of a log, joints in the model's order.
struct LogColumns {
  LogColumn time;
  std::vector<LogColumn> position;
  std::vector<LogColumn> velocity;  ///< n, or empty: the log has none and needs none
  std::vector<LogColumn> torque;
  bool velocity_optional = false;  ///< a log without any of their columns has no velocities
};

/// As armtune writes them: `time`, `joint/NAME/position`, `joint/NAME/torque`; `joint/NAME/velocity` if
/// there.
LogColumns default_log_columns(const RobotModel& model);

/// From a YAML file: `time`, `time_scale`, and `position`, `velocity` (optional) and `torque`. Each of the
/// last three has `columns`, a list of n column names or a map from joint names to column names, and may have
/// `scale`: one number, a list of n numbers or a map from joint names to numbers. `units` (file_units.hpp)
/// says the same of all columns; velocities are per second. Throws InputError.
LogColumns load_log_columns(const std::string& path, const RobotModel& model);

}  // namespace armtune::internal
