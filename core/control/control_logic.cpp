#include "core/control/control_logic.hpp"

#include <cmath>
#include <functional>

#include "core/control/obstacle_impedance.hpp"
#include "core/control/tracking_error.hpp"
#include "core/control/velocity_barrier.hpp"
#include "core/control/velocity_governor.hpp"

namespace armtune::internal {
namespace {

/// The wrist consists of the last three joints. Their Kd is scaled during a slerp.
constexpr int kWristJoints = 3;

MotionPoint<Vec3> path_now(const Scene& scene, double time) {
  return scene.on_path != nullptr ? *scene.on_path : scene.path->at(time);
}

}  // namespace

ControlLogic::ControlLogic(std::shared_ptr<const RobotModel> model, const Gains& gains, double period,
                           TaskMask mask)
    : model_(std::move(model)),
      gains_(gains),
      goal_(in_si(*model_, gains.joint_space_goal)),
      effort_limits_(model_->effort_limits()),
      velocity_limits_(model_->velocity_limits()),
      velocity_bound_(gains.velocity_margin * velocity_limits_),
      damping_(inverse_damping(gains)),
      mask_(mask),
      centering_(joint_centering(*model_, gains.joint_centering_gain)),
      roll_(*model_, gains.roll_centering_gain, mask),
      period_(period) {
  if (gains_.release_radius == 0.0) gains_.release_radius = gains_.obstacleInfluenceRadius;
}

ToolAim ControlLogic::aim(const Scene& scene) const {
  return {scene.target, scene.orientation, mask_ == TaskMask::kPositionAndAxis};
}

const MeasuredArm& ControlLogic::whole(const JointState& measured, const ArmView& arm) {
  if (arm.whole != nullptr) return *arm.whole;
  if (!spare_is_now_) spare_.measure(model_->chain, measured.q, measured.qd, damping_, mask_);
  spare_is_now_ = true;
  return spare_;
}

bool ControlLogic::decide(const JointState& measured, const ArmView& arm, const Scene& scene, double time) {
  spare_is_now_ = false;
  if (!started_) {
    started_ = true;
    out_.state = first_state(scene.plan != nullptr);
    q_start_ = measured.q;
    task_goal_.start(goal_);
  }
  out_.manipulability = arm.manipulability;
  out_.damped = arm.damped;
  out_.obstacle_distance = arm.obstacle_distance;

  const ControlState state = next_state(
      out_.state,
      {.joint_trajectory_finished = time - lag_ >= gains_.joint_trajectory_duration,
       .return_finished = time - lag_ - return_start_ >= return_.duration(),
       .obstacle_distance = out_.obstacle_distance,
       .influence_radius = gains_.obstacleInfluenceRadius,
       .release_radius = gains_.release_radius,
       .plan_finished = scene.plan == nullptr || (!scene.holds_plan && time >= scene.plan->end())});
  if (state != out_.state) {
    out_.state = state;
    enter_state(measured, arm, scene, time);
  }
  if (state == ControlState::kLeaveSingularity) {
    follow_joint_trajectory(measured, arm, scene, time);
    return false;
  }
  if (state == ControlState::kFollowPlan) {
    follow_plan(measured, arm, scene, time);
    return false;
  }
  follow_task(measured, arm, scene, time);
  return true;
}

void ControlLogic::enter_state(const JointState& measured, const ArmView& arm, const Scene& scene,
                               double time) {
  integral_.setZero();
  if (out_.state != ControlState::kReturnToTrajectory) return;
  // The return starts from the measured position and velocity, and from the acceleration of the last
  // reference. That is zero after avoidObstacles and after leaveSingularity, the path's acceleration after
  // leaveSingularity with a joint goal that follows the task, and the plan's acceleration after followPlan.
  const MotionPoint<Vec3> start{arm.p_0T, arm.twist.head<3>(), out_.desired.acceleration};
  return_ = return_trajectory(start, *scene.path, time, gains_.trajectoryDurationErrorGain);
  if (gains_.velocity_margin > 0.0) {
    Vec6 displacement;
    displacement << scene.path->at(time + return_.duration()).position - arm.p_0T, Vec3::Zero();
    const double shortest = shortest_duration(whole(measured, arm).inverse, displacement, velocity_bound_);
    if (shortest > return_.duration()) return_ = {start, scene.path->at(time + shortest), shortest};
  }
  return_start_ = time - lag_;
}

void ControlLogic::follow_joint_trajectory(const JointState& measured, const ArmView& arm, const Scene& scene,
                                           double time) {
  out_.desired = {arm.p_0T, arm.twist.head<3>(), Vec3::Zero()};
  const MotionPoint<double> s = rest_to_rest(0.0, 1.0, gains_.joint_trajectory_duration).at(time - lag_);
  MotionPoint<JointVector> goal{goal_, JointVector::Zero(goal_.size()), JointVector::Zero(goal_.size())};
  if (gains_.joint_goal_follows_task) {
    const MotionPoint<Vec3> path = path_now(scene, time);
    // The goal moves from joint_space_goal, which the user chose, to the moving goal. The first half of the
    // motion is therefore nearly the same as to a goal at rest.
    goal = towards(goal_,
                   task_goal_.step(model_->chain, path, aim(scene), damping_, mask_, centering_, period_), s);
    out_.desired.acceleration = path.acceleration;
  }
  joint_space_references(towards(q_start_, goal, s), gains_.joint_space_gains_p, measured.q, measured.qd,
                         out_.reference);
  Kd_ = gains_.joint_space_gains_d;
  gaze_.tool_turns(arm.twist.tail<3>());
  out_.slerping = false;
  out_.errors = {};
}

void ControlLogic::follow_plan(const JointState& measured, const ArmView& arm, const Scene& scene,
                               double time) {
  out_.planned = scene.plan->at(time);
  // The torque is constant over the period, so it needs the mean acceleration, not that at the start.
  out_.planned.acceleration = scene.plan->mean_acceleration(time, period_);
  if (time >= scene.plan->end()) {
    out_.planned.velocity.setZero();
    out_.planned.acceleration.setZero();
  }
  joint_space_references(out_.planned, gains_.joint_space_gains_p, measured.q, measured.qd, out_.reference);
  Kd_ = gains_.joint_space_gains_d;
  // A return to the path that follows the plan starts with the tool's acceleration on the plan.
  const MeasuredArm& at = whole(measured, arm);
  Jacobian J_dot;
  tool_jacobian_derivative(model_->chain, at.poses, at.twist, measured.qd, J_dot);
  const Vec6 tool_acceleration = times(at.J, out_.planned.acceleration) + times(J_dot, measured.qd);
  out_.desired = {arm.p_0T, arm.twist.head<3>(), tool_acceleration.head<3>()};
  gaze_.tool_turns(arm.twist.tail<3>());
  out_.slerping = false;
  out_.errors = {};
}

MotionPoint<Vec3> ControlLogic::desired_motion(const ArmView& arm, const Scene& scene, double time) const {
  switch (out_.state) {
    case ControlState::kReturnToTrajectory:
      return return_.at(time - lag_ - return_start_);
    case ControlState::kFollowTrajectory:
      return path_now(scene, time);
    default:
      return {arm.p_0T, Vec3::Zero(), Vec3::Zero()};
  }
}

void ControlLogic::follow_task(const JointState& measured, const ArmView& arm, const Scene& scene,
                               double time) {
  const bool avoiding = out_.state == ControlState::kAvoidObstacles;
  const Eigen::Quaterniond Q_0T(arm.R_0T);
  out_.desired = desired_motion(arm, scene, time);
  // The line to the target starts at the tool's measured position. It moves with the desired velocity, which
  // has no sensor noise. During avoidance there is no desired velocity, so the measured one is used.
  const MotionPoint<Vec3> tool{arm.p_0T, avoiding ? Vec3(arm.twist.head<3>()) : out_.desired.velocity,
                               out_.desired.acceleration};
  // Passed by reference below, so that the std::function allocates nothing.
  const auto inverse = [&]() -> const TaskInverse& { return whole(measured, arm).inverse; };
  std::optional<GazeControl::SpeedBound> speed;
  if (gains_.velocity_margin > 0.0)
    speed.emplace(GazeControl::SpeedBound{std::ref(inverse), velocity_bound_});
  GazeControl::Output gaze =
      tracks_orientation(mask_)
          ? gaze_.update(gains_, arm.R_0T, Q_0T, tool, aim(scene), time - lag_, speed)
          : GazeControl::Output{
                {Q_0T, Vec3::Zero(), Vec3::Zero()}, false, aim(scene).turn(arm.R_0T, arm.p_0T)};
  const bool rolls = scene.orientation == nullptr && roll_.is_on();
  if (rolls) {
    // A slerp from a frozen start would keep the roll at its start. A slerp from the current orientation
    // restarts in every period, so it follows the roll by itself.
    const bool frozen_start = gaze.slerping && gains_.slerp_reference == SlerpReference::kStart;
    roll_.step(measured.q, period_, frozen_start);
    roll_.add_to(gaze.desired);
  }
  out_.slerping = gaze.slerping;
  out_.desired_gaze = gaze.desired;
  out_.gaze_turn = gaze.turn;

  // The integral stays zero during a slerp, because it would wind up on an error that is intended.
  if (gaze.slerping) integral_.setZero();
  CartesianErrors& x = out_.errors;
  const TrackingError error = tracking_error(arm.R_0T, arm.p_0T, arm.twist, out_, gaze.turn, mask_);
  x.pose = error.pose;
  x.desired_rate << out_.desired.velocity, gaze.desired.angular_velocity;
  x.desired_accel << out_.desired.acceleration, gaze.desired.angular_acceleration;
  // During avoidance there is no position control: the position errors are zero, and only damping resists
  // the repulsion.
  x.rate = error.rate;
  x.integral = integral_;

  Vec6 Kp = gains_.task_space_gains_p;
  // A law without task_space_gains_d gets Kd of the joint space law: the barrier is a multiple of Kd.
  Kd_ = gains_.task_space_gains_d.size() > 0 ? gains_.task_space_gains_d : gains_.joint_space_gains_d;
  if (gaze.slerping) {
    Kp.tail<3>() *= gains_.interpolation_gain_scale;
    Kd_.tail(std::min<Eigen::Index>(kWristJoints, Kd_.size())) *= gains_.interpolation_gain_scale;
  }
  task_reference_ = armtune::internal::task_reference(x, Kp, gains_.task_space_gains_i);
  if (rolls && !gaze.slerping) without_roll_feedback(x, arm.R_0T.col(2), task_reference_);
}

// A plan keeps the velocity limits by itself, and the moving path or target that it meets does not wait.
bool ControlLogic::keeps_pace() const {
  return gains_.velocity_margin > 0.0 && out_.state != ControlState::kFollowPlan;
}

void ControlLogic::keep_pace(const Scene& scene, double time) {
  if (!keeps_pace()) return;
  out_.pace = govern(velocity_bound_, out_.reference);
  const bool returning = out_.state == ControlState::kReturnToTrajectory;
  const bool interpolating = out_.slerping || returning || out_.state == ControlState::kLeaveSingularity;
  if (out_.pace == 1.0 || !interpolating) return;
  const double delay = (1.0 - out_.pace) * period_;
  if (returning) {
    // The path does not wait, so the rest of the return is replanned to where the path will be at its end.
    const double done = time - lag_ - return_start_;
    const double rest = return_.duration() - done;
    if (rest > kShortestInterpolation) {
      return_ = {return_.at(done), scene.path->at(time + rest), rest};
      return_start_ = time - lag_;
    }
  }
  lag_ += delay;
}

void ControlLogic::limit_torque(const JointState& measured, const ArmView& arm, const Scene& scene) {
  const bool avoiding = out_.state == ControlState::kAvoidObstacles;
  if (avoiding) {
    obstacle_torque(model_->chain, whole(measured, arm).poses, scene.obstacles,
                    gains_.obstacleInfluenceRadius, gains_.force_control_gains, bypassing_);
  } else {
    bypassing_.setZero(model_->n());
  }
  // The barrier is for motion that no planner has limited. It would brake a plan near its velocity limits.
  const bool barred = gains_.velocity_barrier_gain > 0.0 && out_.state != ControlState::kFollowPlan;
  if (avoiding || barred) {
    add_behind_barrier(measured.qd, velocity_limits_, gains_.velocity_barrier_start,
                       gains_.velocity_barrier_gain, Kd_, bypassing_, out_.commanded);
  }
  out_.torque = out_.commanded.cwiseMax(-effort_limits_).cwiseMin(effort_limits_);
  out_.saturated = !(out_.torque.array() == out_.commanded.array()).all();
}

bool ControlLogic::conclude() {
  // Integral and theta are frozen while a torque is saturated, because the law did not cause that error.
  if (out_.saturated) return false;
  if (!out_.slerping) integral_ += period_ * out_.errors.pose;
  return out_.state != ControlState::kAvoidObstacles || gains_.adapt_while_avoiding;
}

}  // namespace armtune::internal
