#pragma once
// Plans the motion of an arm through joint goals that have no times, so that the arm stops at each goal.

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>

#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal {

/// Returns a motion that begins at 0 s at rest at the first goal, goes to each next goal in the least time
/// that the limits below allow, and rests there for 0.5 s. Its acceleration is linear between the points of
/// its time grid. Limits:
///   - 80 % of the robot's limits of velocity, effort and, if it has any, acceleration;
///   - an acceleration with which a joint needs at least 0.5 s to reach its permitted velocity, and a jerk
///     with which it needs at least 0.1 s to reach its permitted acceleration;
///   - distances: links stay 2 cm away from the parts of the cell and the floor, and 5 mm from each other.
///     Like the torque, distances are checked at 61 times of each move, not between them.
///
/// progress: called with the number of finished moves and the number of all moves; may be empty. Returns
/// nothing if `stop` became true. Throws InputError naming the file and the goal, counted from 1, if a goal
/// violates these limits or if no motion to it is found. Throws InputError too if a part of the cell moves.
std::optional<TimedGoals> time_goals(const JointGoals& goals, const std::atomic<bool>& stop,
                                     const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace armtune::internal
