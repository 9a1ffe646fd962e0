#pragma once
// Finds a first task, such as a circle to follow, for an arm that has no task yet. It also finds gains with
// which the simulated arm completes this task. `armtune robot --task` writes task and gains to files, as a
// start for tuning.

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
  Metrics metrics;  ///< metrics of this task with these gains, simulated in Simbody
  /// Text of a robot file with estimated rotor inertia; empty if the given file has its own rotor inertia.
  std::string robot_yaml;
  std::string robot_file;  ///< the robot's file or name, as task.yaml gives it
};

/// Finds a task, and gains that pass all of these tests:
/// - The arm completes the task in Simbody inside its position limits, with at most kFirstTaskRatio of its
///   velocity and effort limits.
/// - If rotor inertia is estimated, the arm also does so with a third and with three times the estimate.
/// - In armtune's own dynamics the gains satisfy every constraint of the study that write_first_task writes.
/// - Also in armtune's own dynamics, nearly all of 60 random arms keep their limits (other_arms.hpp), and the
///   arm passes the endurance check, a simulation for a long time.
/// The search begins with starting_gains. It varies Kp, Kd, the adaptation gain, and the gains that set the
/// durations of returns to the path and of turns to a target.
/// If no such gains pass, it tries these alternatives in this order:
/// - other places for the task, and slower tasks;
/// - places that are searched among ten times as many joint positions;
/// - a task that prescribes only the tool's position;
/// - if no floor was given, all of these without a floor.
/// robot: a bundled name or a file. workers: number of threads (>= 1). progress: called with a description of
/// the task that is tried next. Throws InputError with the reason if it finds no task.
FirstTask find_first_task(const std::string& robot, const TaskOptions& options, int workers = 1,
                          const std::function<void(const std::string&)>& progress = {});

/// Writes task.yaml, gains.yaml, study.yaml and, with estimated rotors, robot.yaml into a new folder. Throws
/// InputError if the folder is not empty.
void write_first_task(const FirstTask& found, const std::string& folder);

}  // namespace armtune::internal
