#pragma once
// The parameter file of the published controller, as a robot loads it.

#include <string>

namespace armtune::internal::test {

/// Key for key and number for number, in their order and spelling, launch/configs/simpleEffortCtrl.yaml of
/// mrcoliva/ur10-controller (commit 0149d2b), the circle included; its comments are replaced by shorter ones.
inline const std::string kRosParameters = R"(# Parameters
simple_effort_ctrl: 
  
  # joint space
  joint_space_gains_p: [5, 8, 8, 10, 1, 1]
  joint_space_gains_d: [100, 75, 75, 15, 15, 5]
 
  # task space
  task_space_gains_p: [80, 50, 50, 25, 15, 3]
  task_space_gains_i: [0.1, 0.025, 0.025, 1, 1, 0.0001]
  task_space_gains_d: [280, 200, 200, 25, 15, 5]

  # obstacles
  obstacleInfluenceRadius: 0.325
  force_control_gains: [100, 4000, 100, 2000, 1500, 100]

  # start
  joint_space_goal: [20.0, -90.0, -90.0, -90.0, 90.0, 0.0]
  joint_trajectory_duration: 6.0

  # durations
  trajectoryDurationErrorGain: 7
  slerpAngularErrorThreshold: 0.15
  slerpDurationErrorGain: 2.5

  # circle
  circularTrajectoryAnchorPosition: [0.65, 0.08, 0.5] # x, y, z
  circularTrajectoryRadius: 0.12
  circularTrajectoryPeriod: 15)";

}  // namespace armtune::internal::test
