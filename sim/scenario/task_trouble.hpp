#pragma once
// Explains in one sentence, with place and number, why an arm cannot do the task of a scenario. The reason is
// found before the first simulation, by inverse kinematics along the task (a walk, see path_walk.hpp).

#include <string>

#include "sim/scenario/path_walk.hpp"

namespace armtune::internal {

/// A problem with place and number, and what to change in a scenario to solve it. Both are parts of one
/// sentence, and both are empty if there is no problem.
struct WalkTrouble {
  std::string problem;
  std::string advice;

  /// Returns the whole sentence.
  std::string text() const { return advice.empty() ? problem : problem + "; " + advice; }
};

/// Returns the problem of a walk. It is empty if there is none (is_clear). The problem is one of these: the
/// tool passes too close to its target, the path leaves the workspace, the tool leaves the path, a joint
/// leaves its limits, the arm passes a singularity, or two bodies touch.
WalkTrouble trouble(const PathWalk& walk, const Scenario& scenario);

/// The problem of a task under given gains.
struct TaskTrouble {
  std::string text;  ///< one sentence; empty: there is no problem
  /// True if, whatever the gains are, a joint drifts along the path until it leaves its position limits.
  bool winds = false;
};

/// Walks along the task and returns the problem that trouble() finds. The walk begins on the path near the
/// joint_space_goal of the gains, at which the controller's state leaveSingularity ends. If there is no start
/// position on the path near this goal, the walk begins at best_start_of_task(). If that function throws, its
/// message is the problem. Returns no problem for a scenario with a planned motion. Throws InputError if
/// neither the gains nor the scenario have a goal.
TaskTrouble find_task_trouble(const Scenario& scenario, const Gains& gains);
inline std::string task_trouble(const Scenario& scenario, const Gains& gains) {
  return find_task_trouble(scenario, gains).text;
}

}  // namespace armtune::internal
