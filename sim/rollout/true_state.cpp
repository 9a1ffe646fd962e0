#include "sim/rollout/true_state.hpp"

#include "core/control/obstacle_distance.hpp"
#include "core/control/tracking_error.hpp"

namespace armtune::internal {

void TrueState::observe(const RunningRollout& running, const Controller& controller, Observation& o) {
  const bool exact = running.measures_exactly();
  const SlotineLi* motion = exact ? controller.references_motion() : nullptr;
  if (exact) {
    o.poses = &controller.arm().poses;
    o.twist = controller.arm().twist;
  } else {
    forward_kinematics(chain_, *o.q, poses_);
    tool_jacobian(chain_, poses_, J_);
    o.poses = &poses_;
    o.twist = times(J_, *o.qd);
  }
  const std::span<const Obstacle> obstacles = running.scene().obstacles;
  const double of_joints =
      exact ? o.control->obstacle_distance : obstacle_distance(chain_, *o.poses, obstacles);
  o.clearance = clearance<double>(chain_, *o.poses, obstacles, of_joints);
  if (motion == nullptr) {
    slotine_li_forward(chain_, *o.poses, *o.qd, o.control->reference.velocity,
                       o.control->reference.acceleration, motion_);
    motion = &motion_;
  }
  theta_error_ = *o.theta - theta_true_;
  slotine_li_torque(chain_, *o.poses, *motion, theta_error_, torque_error_);
  o.compensation_error = norm(torque_error_);
  see_errors(running.sees_exactly(), o);
}

void see_errors(bool exact, Observation& o) {
  const ControlOutput& control = *o.control;
  const Poses& poses = *o.poses;
  const Vec3 turn =
      exact && !tracks_joints(control.state) ? control.gaze_turn : o.aim().turn(poses.R_0T, poses.p_0T);
  o.gaze_angle = turn.norm();
  o.error.setZero();
  o.error_rate.setZero();
  if (tracks_joints(control.state)) return;
  const TrackingError error = tracking_error(poses.R_0T, poses.p_0T, o.twist, control, turn, o.mask);
  o.error = error.pose;
  o.error_rate = error.rate;
}

}  // namespace armtune::internal
