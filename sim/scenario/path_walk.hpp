#pragma once
// Whether an arm can do a scenario's task at all: its path and its gaze gone along by inverse kinematics,
// without dynamics, gains or limits on velocity. What no controller could do better is known before the first
// simulation.

#include <string>

#include "sim/scenario/scenario.hpp"
#include "sim/scenario/walk_extremes.hpp"

namespace armtune::internal {

/// How far a walk is gone: to its end, for what is found on it, or until it is known that the arm cannot
/// follow.
enum class WalkUntil { kEnd, kLost };

/// From joint positions q (n) that have the tool on the path at scenario.start_time; over the whole scenario,
/// or a turn of the path where that is shorter, targets rest, and the joints come round with it, or stay
/// within their limits as they drift. In steps of 0.02 s, longer where it takes more than 400 s; of what
/// takes more than 1000 s the first 1000. Needs a robot, path, targets and a mask; nothing else.
/// centering_gain: joint_centering_gain, roll_gain: roll_centering_gain [1/s].
PathWalk walk_path(const Scenario& scenario, const JointVector& q, double centering_gain,
                   double roll_gain = 0.0, WalkUntil until = WalkUntil::kEnd);

/// The path is followed to a millimetre, within the joints' limits, and off singularities.
bool can_follow(const PathWalk& walk);

/// The same, and the arm touches neither itself nor its cell.
bool is_clear(const PathWalk& walk);

/// What is wrong with it in one sentence, with place and figure: it passes its own target, the path leaves
/// the workspace, a joint its limits, or a singularity is passed. Empty: nothing, it is clear.
std::string trouble(const PathWalk& walk, const Scenario& scenario);

/// The joint positions (n) to begin the task at: the tool on the path at scenario.start_time, looking at the
/// target that is active then, from where the smallest manipulability of the walk is the largest, away from
/// the limits. Throws InputError if there are none, naming the place.
JointVector best_start_of_task(const Scenario& scenario);

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

/// A position (n) to begin a simulation with when none is given: off `goal` by 20 degrees or 0.1 m, a tenth
/// of the joint's range at most, towards the middle of each joint's limits.
JointVector off_goal(const RobotModel& robot, const JointVector& goal);

}  // namespace armtune::internal
