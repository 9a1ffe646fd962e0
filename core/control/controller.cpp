#include "core/control/controller.hpp"

#include <cmath>

#include "core/control/obstacle_impedance.hpp"

namespace armtune {
namespace {

/// The wrist: a slerp lowers Kd of the last three joints.
constexpr int kWristJoints = 3;

JointVector goal_in_si(const RobotModel& model, const Gains& gains) {
  JointVector goal = gains.joint_space_goal;
  for (int i = 0; i < model.n(); ++i) {
    if (model.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kRevolute) goal[i] *= M_PI / 180.0;
  }
  return goal;
}

}  // namespace

Controller::Controller(std::shared_ptr<const RobotModel> model, const Gains& gains,
                       const ParameterVector& theta, double period)
    : model_(std::move(model)),
      gains_(gains),
      goal_(goal_in_si(*model_, gains)),
      effort_limits_(model_->effort_limits()),
      period_(period),
      adaptation_(theta) {
  if (gains_.release_radius == 0.0) gains_.release_radius = gains_.obstacleInfluenceRadius;
}

const ControlOutput& Controller::update(const JointState& measured, const Scene& scene, double time) {
  const Chain& chain = model_->chain;
  if (!started_) {
    started_ = true;
    q_start_ = measured.q;
  }
  forward_kinematics(chain, measured.q, poses_);
  tool_jacobian(chain, poses_, J_);
  twist_.noalias() = J_ * measured.qd;
  inverse_.compute(J_, gains_.manipulability_threshold, gains_.manipulability_damping);
  out_.manipulability = inverse_.manipulability();
  out_.damped = inverse_.damped();
  out_.obstacle_distance = obstacle_distance(poses_, scene.obstacles);

  const ControlState state =
      next_state(out_.state, {.joint_trajectory_finished = time >= gains_.joint_trajectory_duration,
                              .return_finished = time - return_start_ >= return_.duration(),
                              .obstacle_distance = out_.obstacle_distance,
                              .influence_radius = gains_.obstacleInfluenceRadius,
                              .release_radius = gains_.release_radius});
  if (state != out_.state) {
    out_.state = state;
    enter_state(scene, time);
  }
  if (state == ControlState::kLeaveSingularity) {
    follow_joint_trajectory(measured, time);
  } else {
    follow_task(measured, scene, time);
  }

  out_.S = measured.qd - out_.reference.velocity;
  slotine_li_forward(chain, poses_, measured.qd, out_.reference.velocity, out_.reference.acceleration,
                     motion_);
  slotine_li_torque(chain, poses_, motion_, adaptation_.theta(), out_.commanded);
  out_.commanded -= Kd_.cwiseProduct(out_.S);
  if (state == ControlState::kAvoidObstacles) {
    obstacle_torque(chain, poses_, scene.obstacles, gains_.obstacleInfluenceRadius,
                    gains_.force_control_gains, scratch_);
    out_.commanded += scratch_;
  }
  out_.torque = out_.commanded.cwiseMax(-effort_limits_).cwiseMin(effort_limits_);
  out_.saturated = !(out_.torque.array() == out_.commanded.array()).all();

  // Integral and theta stand still while a joint is saturated: its error is not the law's doing.
  if (!out_.saturated) {
    if (!out_.slerping) integral_ += period_ * out_.errors.pose;
    if (state != ControlState::kAvoidObstacles || gains_.adapt_while_avoiding) {
      adaptation_.step(motion_, gains_.adaptation_gain, period_);
    }
  }
  return out_;
}

void Controller::enter_state(const Scene& scene, double time) {
  integral_.setZero();
  if (out_.state != ControlState::kReturnToTrajectory) return;
  // Start from the measured position and velocity and the last reference's acceleration, which is zero at
  // the end of leaveSingularity's quintic and in avoidObstacles.
  return_ = return_trajectory({poses_.p_0T, twist_.head<3>(), out_.desired.acceleration}, *scene.path, time,
                              gains_.trajectoryDurationErrorGain);
  return_start_ = time;
}

void Controller::follow_joint_trajectory(const JointState& measured, double time) {
  const MotionPoint<JointVector> desired =
      joint_trajectory(q_start_, goal_, gains_.joint_trajectory_duration, time);
  joint_space_references(desired, gains_.joint_space_gains_p, measured.q, measured.qd, out_.reference);
  Kd_ = gains_.joint_space_gains_d;
  out_.slerping = false;
  out_.desired = {poses_.p_0T, twist_.head<3>(), Vec3::Zero()};
  out_.errors = {};
}

void Controller::follow_task(const JointState& measured, const Scene& scene, double time) {
  const Eigen::Quaterniond Q_0T(poses_.R_0T);
  const GazeControl::Output gaze = gaze_.update(gains_, poses_, Q_0T, scene.p_0G, time);
  out_.slerping = gaze.slerping;
  out_.desired_gaze = gaze.desired;
  switch (out_.state) {
    case ControlState::kReturnToTrajectory:
      out_.desired = return_.at(time - return_start_);
      break;
    case ControlState::kFollowTrajectory:
      out_.desired = scene.path->at(time);
      break;
    default:
      out_.desired = {poses_.p_0T, Vec3::Zero(), Vec3::Zero()};
      break;
  }

  // The integral stays empty while a slerp runs: it would wind up on an error that is meant to be there.
  if (gaze.slerping) integral_.setZero();
  CartesianErrors& x = out_.errors;
  x.pose << poses_.p_0T - out_.desired.position, -rotation_log(gaze.desired.orientation * Q_0T.conjugate());
  x.desired_rate << out_.desired.velocity, gaze.desired.angular_velocity;
  x.desired_accel << out_.desired.acceleration, gaze.desired.angular_acceleration;
  x.rate = twist_ - x.desired_rate;
  x.integral = integral_;
  // No position control while avoiding, so that the repulsion meets damping only.
  if (out_.state == ControlState::kAvoidObstacles) x.rate.head<3>().setZero();

  Vec6 Kp = gains_.task_space_gains_p;
  Kd_ = gains_.task_space_gains_d;
  if (gaze.slerping) {
    Kp.tail<3>() *= gains_.interpolation_gain_scale;
    Kd_.tail(std::min<Eigen::Index>(kWristJoints, Kd_.size())) *= gains_.interpolation_gain_scale;
  }
  tool_jacobian_derivative(model_->chain, poses_, J_, measured.qd, J_dot_);
  cartesian_references(x, Kp, gains_.task_space_gains_i, inverse_, J_dot_, out_.reference);
}

}  // namespace armtune
