#pragma once
// Computes the load of gravity on the joints of an arm that stands still. The load of a joint is the torque
// that holds the arm, divided by the joint's effort limit. Poses and tasks are chosen and checked by the
// largest of these loads.

#include "core/robot/kinematics.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// The joint with the largest load.
struct HoldingLoad {
  double share = 0.0;  ///< its load: holding torque divided by effort limit [1]
  int joint = 0;
};

/// Returns the joint with the largest load. poses: poses of the chain. efforts (n): effort limits [N m, N].
/// gravity (n): set to the torques that hold the arm [N m, N].
HoldingLoad holding_load(const Chain& chain, const Poses& poses, const JointVector& efforts,
                         JointVector& gravity);

/// Returns the joint with the largest load at the joint positions q (n).
HoldingLoad holding_load(const Chain& chain, const JointVector& q, const JointVector& efforts);

}  // namespace armtune::internal
