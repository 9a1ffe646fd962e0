#pragma once
// Finds a first task for an arm that has none, such as a circle to follow, and gains with which the simulated
// arm completes it. `armtune robot --task` writes both to files, as a start for tuning.

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
  Metrics metrics;  ///< of the task with these gains, simulated in Simbody
  std::string
      robot_yaml;  ///< text of a robot file with estimated rotor inertia; empty: the given file has its own
  std::string robot_file;  ///< the robot's file or name as task.yaml gives it
};

/// Finds a task, and gains that pass all of these tests:
/// - The arm completes the task in Simbody inside its position limits, with at most kFirstTaskRatio of its
///   velocity and effort limits.
/// - If rotor inertia is estimated, it does so also with a third of the estimate and with three times it.
/// - In armtune's own dynamics the gains satisfy every constraint of the study that is written with them.
/// - Also in armtune's own dynamics, nearly all of 60 other random arms keep their limits, and the arm passes
///   the endurance check, a simulation for a long time.
/// The search begins with starting_gains, and varies Kp and Kd, the adaptation gain and the duration gains.
/// If none of them pass, it tries, in this order: other places and slower tasks, places among ten times as
/// many positions, a task of position alone, and, if no floor was given, all of that without a floor.
/// robot: a bundled name or a file. workers: threads (>= 1). progress: called with a description of the task
/// tried next. Throws InputError with the reason if it finds none.
FirstTask find_first_task(const std::string& robot, const TaskOptions& options, int workers = 1,
                          const std::function<void(const std::string&)>& progress = {});

/// Writes task.yaml, gains.yaml, study.yaml and, with estimated rotors, robot.yaml into a new folder. Throws
/// InputError if the folder holds anything.
void write_first_task(const FirstTask& found, const std::string& folder);

}  // namespace armtune::internal
