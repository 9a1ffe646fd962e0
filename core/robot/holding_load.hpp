#pragma once
// What it takes to hold an arm still.

#include "core/robot/kinematics.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// The joint that holding the arm still burdens most, and the share of its effort limit that this takes [1].
struct HoldingLoad {
  double share = 0.0;
  int joint = 0;
};

/// poses: of the chain. efforts (n): limits [N m, N]. gravity (n): written, the torques that hold the arm.
HoldingLoad holding_load(const Chain& chain, const Poses& poses, const JointVector& efforts,
                         JointVector& gravity);

/// The same of one position q (n).
HoldingLoad holding_load(const Chain& chain, const JointVector& q, const JointVector& efforts);

}  // namespace armtune::internal
