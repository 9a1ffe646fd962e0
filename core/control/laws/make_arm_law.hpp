#pragma once
// Defines make_arm_law (arm_law.hpp), which needs the code of every law that is a template. Include this file
// only where the laws are compiled for a scalar type T.

#include "core/control/laws/adaptive_arm_law.hpp"
#include "core/control/laws/cartesian_impedance_arm_law.hpp"
#include "core/control/laws/computed_torque_arm_law.hpp"
#include "core/control/laws/impedance_arm_law.hpp"
#include "core/control/laws/joint_impedance_arm_law.hpp"
#include "core/control/laws/joint_pd_arm_law.hpp"
#include "core/control/laws/joint_trajectory_arm_law.hpp"
#include "core/control/laws/position_streaming_arm_law.hpp"

namespace armtune::internal {

template <typename T>
std::unique_ptr<ArmLawT<T>> make_arm_law(ArmLawKind kind, int n) {
  switch (kind) {
    case ArmLawKind::kAdaptive:
      return std::make_unique<AdaptiveArmLawT<T>>(n);
    case ArmLawKind::kComputedTorque:
      return std::make_unique<ComputedTorqueArmLawT<T>>(n);
    case ArmLawKind::kJointPd:
      return std::make_unique<JointPdArmLawT<T>>(n);
    case ArmLawKind::kImpedance:
      return std::make_unique<ImpedanceArmLawT<T>>(n);
    case ArmLawKind::kJointTrajectory:
    case ArmLawKind::kJointTrajectoryVelocity:
      return std::make_unique<JointTrajectoryArmLawT<T>>(n);
    case ArmLawKind::kJointImpedance:
      return std::make_unique<JointImpedanceArmLawT<T>>(n);
    case ArmLawKind::kCartesianImpedance:
      return std::make_unique<CartesianImpedanceArmLawT<T>>(n);
    case ArmLawKind::kPositionStreaming:
      return std::make_unique<PositionStreamingArmLawT<T>>(n);
  }
  return nullptr;
}

}  // namespace armtune::internal
