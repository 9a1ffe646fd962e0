#include "core/robot/holding_load.hpp"

#include "core/robot/dynamics.hpp"

namespace armtune::internal {

HoldingLoad holding_load(const Chain& chain, const Poses& poses, const JointVector& efforts,
                         JointVector& gravity) {
  gravity_torque(chain, poses, gravity);
  HoldingLoad load;
  load.share = (gravity.array().abs() / efforts.array()).maxCoeff(&load.joint);
  return load;
}

HoldingLoad holding_load(const Chain& chain, const JointVector& q, const JointVector& efforts) {
  Poses poses;
  forward_kinematics(chain, q, poses);
  JointVector gravity;
  return holding_load(chain, poses, efforts, gravity);
}

}  // namespace armtune::internal
