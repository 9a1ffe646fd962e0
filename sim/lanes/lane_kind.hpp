#pragma once
// The properties that arms and scenarios must have in common to be simulated at the same time in one SIMD
// register.

#include <array>
#include <cstddef>

#include "core/control/laws/arm_law.hpp"
#include "core/control/task_mask.hpp"
#include "core/robot/chain.hpp"
#include "sim/plant/stepper.hpp"

namespace armtune::internal {

struct LaneKind {
  int n = 0;                                     ///< joints
  std::array<JointMotion, kMaxJoints> motion{};  ///< of each joint
  TaskMask mask = TaskMask::kPose;
  std::size_t most_obstacles = 0;
  bool link_surfaces = false;   ///< obstacle distances are those of links, not of joint origins
  double control_period = 0.0;  ///< [s]
  int drive_steps = 1;          ///< periods of the robot's drives in a control period; 1 without drives
  int plant_steps = 1;          ///< steps of the simulated arm in a period of the drives
  Stepper stepper = Stepper::kMidpoint;
  ArmLawKind law = ArmLawKind::kAdaptive;

  bool operator==(const LaneKind&) const = default;
};

}  // namespace armtune::internal
