#pragma once
// Diagnosis of tasks that an arm cannot do with any gains, as one sentence with place and figure.

#include <string>

#include "sim/scenario/path_walk.hpp"

namespace armtune::internal {

/// Returns the problem of a walk as one sentence with place and figure; empty if the walk is clear. The
/// problem is one of these: the tool passes its own target, the path leaves the workspace, the walk leaves
/// the path or a joint its limits, a singularity is passed, or two bodies touch.
std::string trouble(const PathWalk& walk, const Scenario& scenario);

/// The problem of a task under given gains.
struct TaskTrouble {
  std::string text;  ///< one sentence; empty: there is no problem
  /// True if the path itself winds a joint up until it leaves its position limits, whatever the gains.
  bool winds = false;
};

/// Returns the `trouble` of the walk that begins closest to the joint_space_goal of the gains, to which
/// leaveSingularity leads, or from the best start if none is found there. If there is no start at all, it
/// returns that. A scenario that follows a plan has no trouble. Throws InputError if neither gains nor
/// scenario have a goal.
TaskTrouble find_task_trouble(const Scenario& scenario, const Gains& gains);
inline std::string task_trouble(const Scenario& scenario, const Gains& gains) {
  return find_task_trouble(scenario, gains).text;
}

}  // namespace armtune::internal
