#include "core/control/gaze_control.hpp"

#include "core/control/velocity_governor.hpp"

namespace armtune::internal {

GazeControl::Output GazeControl::update(const Gains& gains, const Mat3& R_0T, const Eigen::Quaterniond& Q_0T,
                                        const MotionPoint<Vec3>& tool, const ToolAim& aim, double time,
                                        const std::optional<SpeedBound>& speed) {
  Output output = next(gains, R_0T, Q_0T, tool, aim, time, speed);
  last_ = {output.desired.angular_velocity, output.desired.angular_acceleration};
  return output;
}

GazeControl::Output GazeControl::next(const Gains& gains, const Mat3& R_0T, const Eigen::Quaterniond& Q_0T,
                                      const MotionPoint<Vec3>& tool, const ToolAim& aim, double time,
                                      const std::optional<SpeedBound>& speed) {
  const Vec3 turn = aim.turn(R_0T, tool.position);
  if (slerping_ && time - start_time_ >= parameter_.duration()) slerping_ = false;
  if (!slerping_) {
    const double angle = turn.norm();
    const double start_angle =
        gains.slerp_start_angle > 0.0 ? gains.slerp_start_angle : gains.slerpAngularErrorThreshold;
    if (angle < start_angle) {
      const TurnRate rate = gains.gaze_feedforward ? aim.rate(tool) : TurnRate{};
      return {{rotation_exp(turn) * Q_0T, rate.velocity, rate.acceleration}, false, turn};
    }
    slerping_ = true;
    start_time_ = time;
    turn_ = turn;
    R_start_ = R_0T;
    Q_start_ = Q_0T;
    double duration = std::max(kShortestInterpolation, gains.slerpDurationErrorGain * angle);
    if (speed) {
      Vec6 displacement;
      displacement << Vec3::Zero(), (1.0 - gains.slerp_start) * turn;
      duration = std::max(duration, shortest_duration(speed->inverse(), displacement, speed->bound));
    }
    parameter_ = rest_to_rest(gains.slerp_start, 1.0, duration);
    onward_.reset();
    if (gains.gaze_feedforward && gains.slerp_reference == SlerpReference::kStart) {
      onward_.emplace(MotionPoint<Vec3>{Vec3::Zero(), last_.velocity, last_.acceleration},
                      MotionPoint<Vec3>{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, duration);
    }
  }
  if (gains.slerp_reference == SlerpReference::kCurrent) {
    return {interpolated(gains, R_0T, Q_0T, tool, aim, time), true, turn};
  }
  // The goal moves with target and tool. The turn is therefore updated, but always from the frozen start.
  return {interpolated(gains, R_start_, Q_start_, tool, aim, time), true, turn};
}

OrientationPoint GazeControl::interpolated(const Gains& gains, const Mat3& R_from,
                                           const Eigen::Quaterniond& Q_from, const MotionPoint<Vec3>& tool,
                                           const ToolAim& aim, double time) {
  const MotionPoint<double> s = parameter_.at(time - start_time_);
  if (gains.gaze_feedforward) {
    const MotionPoint<Vec3> motion = aim.turn_motion(R_from, tool, turn_);
    turn_ = motion.position;
    if (!onward_) return slerp(Q_from, motion, s);
    const OrientationPoint onward =
        slerp(Eigen::Quaterniond::Identity(), onward_->at(time - start_time_), {1.0, 0.0, 0.0});
    return composed(onward, slerp(Q_from, motion, s));
  }
  turn_ = aim.turn_on(R_from, tool.position, turn_);
  return slerp(Q_from, turn_, s);
}

}  // namespace armtune::internal
