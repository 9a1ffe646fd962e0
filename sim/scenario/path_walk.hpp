#pragma once
// Lets an arm follow the task of a scenario step by step by inverse kinematics. This is called a walk. A walk
// uses no dynamics and no velocity limits. Of all gains, it uses only those of joint centering and roll
// centering. It shows before the first simulation where no controller can make the arm do the task.

#include <vector>

#include "sim/scenario/scenario.hpp"
#include "sim/scenario/walk_extremes.hpp"

namespace armtune::internal {

/// The condition that ends a walk. kEnd: only the end of the task, so that every problem along it is found.
/// kLost: also that the arm leaves the path or its joint limits.
enum class WalkUntil { kEnd, kLost };

/// Follows the task from joint positions q (n), at which the tool is on the path at scenario.start_time.
///
/// The walk covers the whole scenario, but at most 1000 s. It covers only one lap of the path (at least 1 s)
/// if all of the following conditions are met:
///   - a lap is shorter than the scenario,
///   - the parts of the cell and the targets rest, and the gaze does not switch between targets,
///   - the tool does not turn through waypoints,
///   - the joints return to their start, or drift so little that they stay within their limits in all laps.
///
/// Steps are 0.02 s long, and longer if the walk covers more than 400 s.
///
/// The scenario needs only a robot, a path, targets or an orientation, and a mask. centering_gain, roll_gain:
/// the gains joint_centering_gain and roll_centering_gain of the controller [1/s]. required: for each pair of
/// bodies in scenario.clearance, the distance [m] below which the pair is listed in PathWalk::too_near;
/// empty: no pair is listed.
PathWalk walk_path(const Scenario& scenario, const JointVector& q, double centering_gain,
                   double roll_gain = 0.0, WalkUntil until = WalkUntil::kEnd,
                   const std::vector<double>& required = {});

/// The joint motion of a walk.
struct JointWalk {
  PathWalk walk;
  std::vector<double> time;                         ///< of each step [s]
  std::vector<MotionPoint<JointVector>> positions;  ///< of the joints at each step, with their derivatives
};

/// Follows the whole task, as walk_path does, and keeps the joint positions of every step.
JointWalk joints_along_path(const Scenario& scenario, const JointVector& q, double centering_gain);

/// Returns true if the arm stays within a millimetre of the path and within its joint limits, and passes no
/// singularity (is_singular).
bool can_follow(const PathWalk& walk);

/// Returns true if the arm can follow the path and touches neither itself nor its cell.
bool is_clear(const PathWalk& walk);

/// Returns true if the tool is more than a millimetre off the path somewhere.
bool is_off_path(const PathWalk& walk);

/// Returns true if the manipulability falls below a fiftieth of its largest value in the walk.
bool is_singular(const PathWalk& walk);

/// Returns a place where the arm touches itself or its cell, or null if it touches nothing.
const LeastClearance* contact(const PathWalk& walk);

/// Returns the largest depth to which the arm penetrates itself or its cell [m]; 0 if it touches nothing.
double depth(const PathWalk& walk);

}  // namespace armtune::internal
