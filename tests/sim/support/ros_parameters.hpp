#pragma once
// The parameter file of the published controller (mrcoliva/ur10-controller), as a robot loads it.

#include <string>

namespace armtune::test {

// Field for field the published ROS parameters, the circle included.
inline const std::string kRosParameters = R"(
simple_effort_ctrl:
  joint_space_gains_p: [5.0, 8.0, 8.0, 10.0, 1.0, 1.0]
  joint_space_gains_d: [100.0, 75.0, 75.0, 15.0, 15.0, 5.0]
  joint_space_goal: [20.0, -90.0, -90.0, -90.0, 90.0, 0.0]
  joint_trajectory_duration: 6.0
  task_space_gains_p: [80.0, 50.0, 50.0, 25.0, 15.0, 3.0]
  task_space_gains_i: [0.1, 0.025, 0.025, 1.0, 1.0, 0.0001]
  task_space_gains_d: [280.0, 200.0, 200.0, 25.0, 15.0, 5.0]
  circularTrajectoryAnchorPosition: [0.65, 0.08, 0.5]
  circularTrajectoryRadius: 0.12
  circularTrajectoryPeriod: 15
  trajectoryDurationErrorGain: 7
  slerpAngularErrorThreshold: 0.15
  slerpDurationErrorGain: 2.5
  obstacleInfluenceRadius: 0.325
  force_control_gains: [100, 4000, 100, 2000, 1500, 100]
)";

}  // namespace armtune::test
