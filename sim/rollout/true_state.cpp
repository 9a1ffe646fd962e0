#include "sim/rollout/true_state.hpp"

#include "core/control/obstacle_impedance.hpp"
#include "core/trajectory/gaze.hpp"

namespace armtune {

void TrueState::observe(std::span<const Vec3> centers, Observation& o) {
  forward_kinematics(chain_, *o.q, poses_);
  tool_jacobian(chain_, poses_, J_);
  o.poses = &poses_;
  o.twist.noalias() = J_ * *o.qd;
  o.obstacle_distance = obstacle_distance(poses_, centers);
  track_errors(o);
  o.compensation_error = compensation_error(o);
}

void TrueState::track_errors(Observation& o) const {
  const ControlOutput& control = *o.control;
  const Vec3 turn = gaze_turn(poses_.R_0T, poses_.p_0T, o.target_motion.position);
  o.gaze_angle = turn.norm();
  o.error.setZero();
  o.error_rate.setZero();
  if (tracks_joints(control.state)) return;
  if (control.state != ControlState::kAvoidObstacles) {
    o.error.head<3>() = poses_.p_0T - control.desired.position;
    o.error_rate.head<3>() = o.twist.head<3>() - control.desired.velocity;
  }
  // Outside a slerp the desired orientation is where the true tool should look; inside, the slerp's.
  o.error.tail<3>() = control.slerping ? Vec3(-rotation_log(control.desired_gaze.orientation *
                                                            Eigen::Quaterniond(poses_.R_0T).conjugate()))
                                       : Vec3(-turn);
  o.error_rate.tail<3>() = o.twist.tail<3>() - control.desired_gaze.angular_velocity;
}

double TrueState::compensation_error(const Observation& o) {
  theta_error_ = *o.theta - theta_true_;
  slotine_li_forward(chain_, poses_, *o.qd, o.control->reference.velocity, o.control->reference.acceleration,
                     motion_);
  slotine_li_torque(chain_, poses_, motion_, theta_error_, torque_error_);
  return torque_error_.norm();
}

}  // namespace armtune
