#pragma once
// Lets an arm follow the task of a scenario step by step by inverse kinematics. This is called a walk. It
// uses no dynamics, no gains and no velocity limits. It shows before the first simulation where the arm
// cannot do the task with any controller.

#include "sim/scenario/scenario.hpp"
#include "sim/scenario/walk_extremes.hpp"

namespace armtune::internal {

/// The end of a walk. kEnd: the end of the task, so that every problem on it is found. kLost: the place where
/// the arm leaves the path or its joint limits, and therefore cannot follow.
enum class WalkUntil { kEnd, kLost };

/// Follows the task from joint positions q (n) that have the tool on the path at scenario.start_time.
///
/// The walk covers the whole scenario. It covers only one lap of the path if all of this is true: a lap is
/// shorter than the scenario, the parts of the cell rest, the targets rest and do not switch, the tool does
/// not turn through waypoints, and the joints return to their start or drift so little that they stay within
/// their limits in all laps. Steps are 0.02 s long, and longer if the walk covers more than 400 s. It ends
/// after 1000 s at the latest.
///
/// The scenario needs only a robot, a path, targets or an orientation, and a mask. centering_gain, roll_gain:
/// the gains joint_centering_gain and roll_centering_gain of the controller [1/s].
PathWalk walk_path(const Scenario& scenario, const JointVector& q, double centering_gain,
                   double roll_gain = 0.0, WalkUntil until = WalkUntil::kEnd);

/// Returns true if the arm follows the path to a millimetre, within its joint limits and off singularities.
bool can_follow(const PathWalk& walk);

/// Returns true if the arm can follow the path and touches neither itself nor its cell.
bool is_clear(const PathWalk& walk);

/// Returns true if the tool is more than a millimetre off the path somewhere.
bool is_off_path(const PathWalk& walk);

/// Returns true if the manipulability falls below a fiftieth of the walk's largest.
bool is_singular(const PathWalk& walk);

/// Returns a place where the arm touches itself or its cell, or null if it touches nothing.
const LeastClearance* contact(const PathWalk& walk);

/// Returns how deep the arm penetrates itself or its cell [m].
double depth(const PathWalk& walk);

}  // namespace armtune::internal
