#pragma once
// Searches for joint positions that are far from singularities and joint limits, and at which little torque
// holds the arm still. armtune places a first task for a new arm there (default_task.hpp).

#include <vector>

#include "core/control/task_mask.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Largest torque for holding the arm still in a first task, as a fraction of the joint's effort limit.
inline constexpr double kMostLoad = 0.85;
/// Distance from a joint limit, as a fraction of the joint's range. A larger distance does not improve the
/// score.
inline constexpr double kEnoughMargin = 0.2;

struct TaskPlace {
  JointVector q;  ///< (n) [rad, m]
  double score = 0.0;
  double manipulability = 0.0;  ///< for the components of the tool's motion that the mask selects
};

/// Returns the best 200 of a fixed series of joint positions, best first. A position has a high score if:
///   - the manipulability is high,
///   - the joints are far from their limits,
///   - the tool points down,
///   - the tool is higher than `lowest` [m], measured from the base frame's origin opposite to gravity,
///   - little torque holds the arm still.
///
/// thorough: true to try ten times as many positions and return up to 500. In this case, at every
/// returned position the tool is higher than `lowest` and the torque is below kMostLoad.
std::vector<TaskPlace> task_places(const RobotModel& robot, TaskMask mask, double lowest, bool thorough);

}  // namespace armtune::internal
