#pragma once
// A first task for an arm, and gains under which the arm was seen to complete it: what `armtune robot --task`
// writes.

#include <string>

#include "core/control/gains.hpp"
#include "sim/metrics/metric.hpp"
#include "sim/scenario/default_task.hpp"

namespace armtune::internal {

/// The most of a joint's velocity and effort limits that a first task takes: what its study demands.
inline constexpr double kFirstTaskRatio = 0.9;

struct FirstTask {
  DefaultTask task;
  Gains gains;
  Metrics metrics;  ///< of the task under these gains, simulated in Simbody
  std::string
      robot_yaml;  ///< text of a robot file with estimated rotor inertia; empty: the given file has its own
  std::string robot_file;  ///< how task.yaml names the robot
};

/// Finds a task, and gains with which the arm completes it in Simbody within its limits: positions whole,
/// velocities and efforts to kFirstTaskRatio. Where rotor inertia is estimated, the arm completes it as well
/// with a third of the estimate and with three times the estimate. Gains begin with starting_gains; Kp and
/// Kd, the adaptation and the task's pace are lowered until the task is completed. `robot`: a bundled name or
/// a file. Throws InputError that says what stands in the way.
FirstTask find_first_task(const std::string& robot, const TaskOptions& options);

/// Writes task.yaml, gains.yaml, study.yaml and, with estimated rotors, robot.yaml into a new folder. Throws
/// InputError if the folder holds anything.
void write_first_task(const FirstTask& found, const std::string& folder);

}  // namespace armtune::internal
