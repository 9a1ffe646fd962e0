#pragma once
// A first task for an arm, and gains under which the arm was seen to complete it: what `armtune robot --task`
// writes.

#include <functional>
#include <string>

#include "core/control/gains.hpp"
#include "sim/metrics/metric.hpp"
#include "sim/scenario/default_task.hpp"
#include "tuner/first_task/kept_limits.hpp"

namespace armtune::internal {

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
/// with a third of the estimate and with three times the estimate. In armtune's own dynamics the gains keep
/// every demand of the study that is written with them, nearly all of 60 other arms at random keep their
/// limits, and the arm passes the endurance check of a verdict. Gains begin with
/// starting_gains; Kp and Kd, the adaptation and the duration gains are changed, then other places and slower
/// tasks are tried, then places among ten times as many positions, then a task of position alone, and last,
/// where no floor was given, all of that without a floor. `robot`: a bundled name or a
/// file. workers: threads (>= 1). progress: told which task is tried next. Throws InputError that says what
/// stands in the way.
FirstTask find_first_task(const std::string& robot, const TaskOptions& options, int workers = 1,
                          const std::function<void(const std::string&)>& progress = {});

/// Writes task.yaml, gains.yaml, study.yaml and, with estimated rotors, robot.yaml into a new folder. Throws
/// InputError if the folder holds anything.
void write_first_task(const FirstTask& found, const std::string& folder);

}  // namespace armtune::internal
