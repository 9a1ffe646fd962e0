#pragma once
// Writes the motion of an arm as an MCAP file, which Foxglove, PlotJuggler, Rerun and rosbag2 open. The
// motion is a table, such as the recording of a rollout (one simulated scenario) or a planned motion.
// docs/logs.md lists the topics of the file.
//
//     write_motion_bag("run.mcap", {*scenario.robot, column_names(recorder.columns()), recorder.rows()});

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "sim/metrics/metric.hpp"

namespace armtune::internal {

/// A motion as a table.
struct MotionTable {
  const RobotModel& robot;
  /// Names of the columns as in rollout_columns(): `time`, and `joint/NAME/position`, `.../velocity` and
  /// `.../torque` of every joint. All others are optional.
  std::vector<std::string> columns;
  std::vector<double> values;  ///< row by row; NaN where a row has no value
};

/// Writes the file. Messages have the time of their row, in ns, as time of recording and as stamp. Poses are
/// computed from the joint positions by forward kinematics. Where a value is not finite, the topic that needs
/// it has no message. metrics: of the whole motion, written at the time of the last row; null: none.
/// Throws InputError with the missing column as key, or with path and reason if the file cannot be written.
void write_motion_bag(const std::string& path, const MotionTable& motion, const Metrics* metrics = nullptr);

}  // namespace armtune::internal
