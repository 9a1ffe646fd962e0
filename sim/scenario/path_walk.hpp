#pragma once
// A walk along a scenario's task by inverse kinematics, without dynamics, gains or velocity limits. It shows
// before the first simulation where the arm cannot do the task with any controller.

#include "sim/scenario/scenario.hpp"
#include "sim/scenario/walk_extremes.hpp"

namespace armtune::internal {

/// The end of a walk: that of the task, so that everything on it is found, or the place where the arm leaves
/// the path or a joint limit and therefore cannot follow.
enum class WalkUntil { kEnd, kLost };

/// Walks the task from joint positions q (n) that have the tool on the path at scenario.start_time.
///
/// The walk covers the whole scenario. One lap of the path is enough if it is shorter, the cell rests, the
/// targets rest without switching, the tool does not turn through waypoints, and the joints return to their
/// start or drift without leaving their limits in the other laps. Steps are 0.02 s long, and longer for more
/// than 400 s. Of more than 1000 s the first 1000 are walked.
///
/// The scenario needs only a robot, a path, targets or an orientation, and a mask.
/// centering_gain: joint_centering_gain, roll_gain: roll_centering_gain [1/s].
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
