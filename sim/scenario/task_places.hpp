#pragma once
// Places for a first task of an arm: joint positions where it moves well and carries itself easily.

#include <vector>

#include "core/control/task_mask.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

inline constexpr double kMostLoad = 0.85;     ///< share of an effort limit, to hold the arm still
inline constexpr double kEnoughMargin = 0.2;  ///< share of a joint's range; more does not raise the score

struct TaskPlace {
  JointVector q;  ///< (n) [rad, m]
  double score = 0.0;
  double manipulability = 0.0;  ///< of the components of the mask
};

/// Returns the best 200 of a fixed series of joint positions, best first. A position scores high if the arm
/// moves well, its joints are far from their limits, the tool looks down, it is higher than `lowest` [m]
/// against gravity, and holding the arm still takes little. thorough: tries ten times as many positions,
/// keeps only those that are high enough and light enough, and returns up to 500.
std::vector<TaskPlace> task_places(const RobotModel& robot, TaskMask mask, double lowest, bool thorough);

}  // namespace armtune::internal
