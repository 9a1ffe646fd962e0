#pragma once
// What keeps an arm from its task, whatever the gains: in one sentence, with place and figure.

#include <string>

#include "sim/scenario/path_walk.hpp"

namespace armtune::internal {

/// What is wrong with it in one sentence, with place and figure: it passes its own target, the path leaves
/// the workspace, a joint its limits, or a singularity is passed. Empty: nothing, it is clear.
std::string trouble(const PathWalk& walk, const Scenario& scenario);

/// What is wrong with a task under given gains.
struct TaskTrouble {
  std::string text;  ///< one sentence; empty: nothing is wrong
  /// The path itself winds a joint up until it leaves its position limits, and no gain prevents it.
  bool winds = false;
};

/// Returns the `trouble` on the way that begins closest to the joint_space_goal of `gains`, where there is
/// one, as leaveSingularity leads there; or that there is no such way. A scenario that follows a plan has no
/// trouble.
TaskTrouble find_task_trouble(const Scenario& scenario, const Gains& gains);
inline std::string task_trouble(const Scenario& scenario, const Gains& gains) {
  return find_task_trouble(scenario, gains).text;
}

}  // namespace armtune::internal
