#pragma once
// Computes which share of its joints' effort limits an arm needs to stand still under gravity. Poses and
// tasks are chosen and checked with it.

#include "core/robot/kinematics.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// The joint that needs the largest share of its effort limit while the arm is held still.
struct HoldingLoad {
  double share = 0.0;  ///< holding torque / effort limit [1]
  int joint = 0;
};

/// Returns the joint with the largest load. poses: poses of the chain. efforts (n): effort limits [N m, N].
/// gravity (n): set to the torques that hold the arm.
HoldingLoad holding_load(const Chain& chain, const Poses& poses, const JointVector& efforts,
                         JointVector& gravity);

/// Returns the same for the position q (n).
HoldingLoad holding_load(const Chain& chain, const JointVector& q, const JointVector& efforts);

}  // namespace armtune::internal
