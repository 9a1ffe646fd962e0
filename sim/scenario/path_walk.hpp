#pragma once
// A scenario's task gone along by inverse kinematics, without dynamics, gains or limits on velocity: what no
// controller could do better is known before the first simulation.

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

/// The tool is more than a millimetre off the path somewhere.
bool is_off_path(const PathWalk& walk);

/// The manipulability falls below a fiftieth of the walk's largest.
bool is_singular(const PathWalk& walk);

/// Where the arm touches itself or its cell; null: nowhere.
const LeastClearance* contact(const PathWalk& walk);

/// How deep the arm comes into itself or its cell [m].
double depth(const PathWalk& walk);

}  // namespace armtune::internal
