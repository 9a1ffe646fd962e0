#include "core/control/gaze_control.hpp"

#include "core/control/velocity_governor.hpp"
#include "core/trajectory/gaze_motion.hpp"

namespace armtune {

GazeControl::Output GazeControl::update(const Gains& gains, const Mat3& R_0T, const Eigen::Quaterniond& Q_0T,
                                        const MotionPoint<Vec3>& tool, const MotionPoint<Vec3>& target,
                                        double time, const std::optional<SpeedBound>& speed) {
  const Vec3 turn = gaze_turn(R_0T, tool.position, target.position);
  if (slerping_ && time - start_time_ >= parameter_.duration()) slerping_ = false;
  if (!slerping_) {
    const double angle = turn.norm();
    const double start_angle =
        gains.slerp_start_angle > 0.0 ? gains.slerp_start_angle : gains.slerpAngularErrorThreshold;
    if (angle < start_angle) {
      const TurnRate rate =
          gains.gaze_feedforward ? direction_rate(gaze_direction(tool, target)) : TurnRate{};
      return {{rotation_exp(turn) * Q_0T, rate.velocity, rate.acceleration}, false, turn};
    }
    slerping_ = true;
    start_time_ = time;
    R_start_ = R_0T;
    Q_start_ = Q_0T;
    double duration = std::max(kShortestInterpolation, gains.slerpDurationErrorGain * angle);
    if (speed) {
      Vec6 displacement;
      displacement << Vec3::Zero(), (1.0 - gains.slerp_start) * turn;
      duration = std::max(duration, shortest_duration(speed->inverse(), displacement, speed->bound));
    }
    parameter_ = rest_to_rest(gains.slerp_start, 1.0, duration);
  }
  if (gains.slerp_reference == SlerpReference::kCurrent) {
    return {interpolated(gains, R_0T, Q_0T, tool, target, time), true, turn};
  }
  // The goal moves with target and tool: the turn is computed anew, but always from the frozen start.
  return {interpolated(gains, R_start_, Q_start_, tool, target, time), true, turn};
}

OrientationPoint GazeControl::interpolated(const Gains& gains, const Mat3& R_from,
                                           const Eigen::Quaterniond& Q_from, const MotionPoint<Vec3>& tool,
                                           const MotionPoint<Vec3>& target, double time) const {
  const MotionPoint<double> s = parameter_.at(time - start_time_);
  if (gains.gaze_feedforward) return slerp(Q_from, gaze_turn_motion(R_from, gaze_direction(tool, target)), s);
  return slerp(Q_from, gaze_turn(R_from, tool.position, target.position), s);
}

}  // namespace armtune
