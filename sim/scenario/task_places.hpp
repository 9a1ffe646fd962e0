#pragma once
// Searches for joint positions at which an arm moves well and holds its own weight easily. armtune places a
// first task for a new arm there (default_task.hpp).

#include <vector>

#include "core/control/task_mask.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Largest fraction of an effort limit that holding the arm still may take.
inline constexpr double kMostLoad = 0.85;
/// Distance from a joint limit, as a fraction of the joint's range, above which the score does not rise.
inline constexpr double kEnoughMargin = 0.2;

struct TaskPlace {
  JointVector q;  ///< (n) [rad, m]
  double score = 0.0;
  double manipulability = 0.0;  ///< for the components of the tool's motion that the mask selects
};

/// Returns the best 200 of a fixed series of joint positions, best first. A position scores high if the arm
/// has a high manipulability, its joints are far from their limits, the tool points down and is higher than
/// `lowest` [m] against gravity, and holding the arm still takes little torque. thorough: tries ten times as
/// many positions, keeps only those that are high enough and take at most kMostLoad, and returns up to 500.
std::vector<TaskPlace> task_places(const RobotModel& robot, TaskMask mask, double lowest, bool thorough);

}  // namespace armtune::internal
