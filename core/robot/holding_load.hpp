#pragma once
// The load on the joints that holding an arm still causes.

#include "core/robot/kinematics.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// The joint with the largest load while the arm is held still, and the share of its effort limit [1].
struct HoldingLoad {
  double share = 0.0;
  int joint = 0;
};

/// Returns that joint. poses: of the chain. efforts (n): limits [N m, N]. gravity (n): set to the torques
/// that hold the arm.
HoldingLoad holding_load(const Chain& chain, const Poses& poses, const JointVector& efforts,
                         JointVector& gravity);

/// Returns the same for the position q (n).
HoldingLoad holding_load(const Chain& chain, const JointVector& q, const JointVector& efforts);

}  // namespace armtune::internal
