#pragma once
// Prepares a path of the tool for a study of a controller that tracks the tool itself, such as Cartesian
// impedance control. Such a controller needs no joint motion along the path, only a place to start.

#include <string>

#include "sim/scenario/path_walk.hpp"
#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal {

/// Returns the task of following the waypoints, from the time of the first to that of the last. Throws
/// InputError as load_waypoints does.
Scenario task_along(const ToolWaypoints& waypoints);

/// Throws InputError naming the file of the waypoints if the arm cannot follow the task (see trouble() in
/// task_trouble.hpp).
void require_passable(const PathWalk& walk, const Scenario& task);

/// A path of the tool, in the form in which the files of a scenario give it.
struct ToolPath {
  std::string waypoints;  ///< text of a CSV file: the user's path after a rest, at the chosen speed
  std::string start;      ///< text of a CSV file: a joint motion that rests at the start of the path
  JointVector position;   ///< joint positions (n) at the start of the path [rad, m]
  double duration = 0.0;  ///< of the scenario [s]
  bool turns = false;     ///< true: the file gives the tool's orientation; false: the orientation is free
};

/// The time for which the tool rests before it moves along the path [s]. Metrics count errors from 1 s after
/// the start of a scenario (sim/metrics/metric.cpp), so no error on the path is left out.
inline constexpr double kRestBeforePath = 1.2;

/// Reads the waypoints. The arm starts at the joint positions from which it follows them best
/// (best_start_of_task). period: control period [s]. Throws InputError if the file cannot be read or if the
/// arm cannot follow the path.
ToolPath tool_path(const ToolWaypoints& waypoints, double period);

}  // namespace armtune::internal
