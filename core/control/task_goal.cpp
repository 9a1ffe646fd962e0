#include "core/control/task_goal.hpp"

namespace armtune {
namespace {

/// K [1/s]: an error at the start is 2e-8 of itself after the 6 s of leaveSingularity.
constexpr double kTaskGoalGain = 3.0;

}  // namespace

const MotionPoint<JointVector>& TaskGoal::step(const Chain& chain, const MotionPoint<Vec3>& path,
                                               const MotionPoint<Vec3>& target, const InverseDamping& damping,
                                               double dt) {
  motion_.position += step_;
  forward_kinematics(chain, motion_.position, poses_);
  tool_jacobian(chain, poses_, J_);
  inverse_.compute(J_, damping);
  const TurnRate gaze =
      direction_rate(gaze_direction({poses_.p_0T, path.velocity, path.acceleration}, target));
  Vec6 rate;
  rate << path.velocity - kTaskGoalGain * (poses_.p_0T - path.position),
      gaze.velocity + kTaskGoalGain * gaze_turn(poses_.R_0T, poses_.p_0T, target.position);
  inverse_.apply(rate, motion_.velocity);
  const Vec6 twist = times(J_, motion_.velocity);
  tool_jacobian_derivative(chain, poses_, twist, motion_.velocity, J_dot_);
  Vec6 accel;
  accel << path.acceleration, gaze.acceleration;
  Vec6 desired;
  desired << path.velocity, gaze.velocity;
  accel -= kTaskGoalGain * (twist - desired) + J_dot_ * motion_.velocity;
  inverse_.apply(accel, motion_.acceleration);
  step_ = dt * motion_.velocity + (0.5 * dt * dt) * motion_.acceleration;
  return motion_;
}

MotionPoint<JointVector> towards(const JointVector& start, const MotionPoint<JointVector>& goal,
                                 const MotionPoint<double>& s) {
  const JointVector way = goal.position - start;
  return {start + s.position * way, s.velocity * way + s.position * goal.velocity,
          s.acceleration * way + 2.0 * s.velocity * goal.velocity + s.position * goal.acceleration};
}

}  // namespace armtune
