#include "core/control/task_goal.hpp"

namespace armtune::internal {
namespace {

/// Gain K [1/s]: after the 6 s of leaveSingularity, an initial error has decayed to 2e-8 of its value.
constexpr double kTaskGoalGain = 3.0;

}  // namespace

const MotionPoint<JointVector>& TaskGoal::step(const Chain& chain, const MotionPoint<Vec3>& path,
                                               const ToolAim& aim, const InverseDamping& damping,
                                               TaskMask mask, const JointCentering& centering, double dt,
                                               RollCentering* roll) {
  motion_.position += step_;
  // Not measure(), because the velocity, which determines the twist, is not known yet.
  Poses& poses = arm_.poses;
  forward_kinematics(chain, motion_.position, poses);
  tool_jacobian(chain, poses, arm_.J);
  arm_.inverse.compute(arm_.J, damping, mask, poses.R_0T);
  TurnRate gaze = aim.rate({poses.p_0T, path.velocity, path.acceleration});
  if (roll != nullptr && roll->is_on()) {
    roll->step(motion_.position, dt, false);
    OrientationPoint turned{Eigen::Quaterniond(poses.R_0T), gaze.velocity, gaze.acceleration};
    roll->add_to(turned);
    gaze = {turned.angular_velocity, turned.angular_acceleration};
  }
  TaskReference wanted;
  wanted.rate << path.velocity - kTaskGoalGain * (poses.p_0T - path.position),
      gaze.velocity + kTaskGoalGain * aim.turn(poses.R_0T, poses.p_0T);
  const Vec6 L = resolve_velocity(wanted.rate, arm_, centering, motion_.position, reference_.velocity);
  arm_.twist = times(arm_.J, reference_.velocity);
  arm_.differentiate(chain, reference_.velocity);
  wanted.acceleration << path.acceleration, gaze.acceleration;
  Vec6 desired;
  desired << path.velocity, gaze.velocity;
  wanted.acceleration -= kTaskGoalGain * (arm_.twist - desired);
  resolve_acceleration(wanted, arm_, centering, reference_.velocity, L, reference_);
  motion_.velocity = reference_.velocity;
  motion_.acceleration = reference_.acceleration;
  step_ = dt * motion_.velocity + (0.5 * dt * dt) * motion_.acceleration;
  return motion_;
}

MotionPoint<JointVector> towards(const JointVector& start, const MotionPoint<JointVector>& goal,
                                 const MotionPoint<double>& s) {
  const JointVector way = goal.position - start;
  return {start + s.position * way, s.velocity * way + s.position * goal.velocity,
          s.acceleration * way + 2.0 * s.velocity * goal.velocity + s.position * goal.acceleration};
}

}  // namespace armtune::internal
