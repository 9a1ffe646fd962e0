#include "core/control/gaze_control.hpp"

#include "core/trajectory/gaze.hpp"

namespace armtune {

GazeControl::Output GazeControl::update(const Gains& gains, const Poses& poses,
                                        const Eigen::Quaterniond& Q_0T, const Vec3& p_0G, double time) {
  const Vec3 turn = gaze_turn(poses.R_0T, poses.p_0T, p_0G);
  if (slerping_ && time - start_time_ >= parameter_.duration()) slerping_ = false;
  if (!slerping_) {
    const double angle = turn.norm();
    if (angle < gains.slerpAngularErrorThreshold) {
      return {{rotation_exp(turn) * Q_0T, Vec3::Zero(), Vec3::Zero()}, false};
    }
    slerping_ = true;
    start_time_ = time;
    R_start_ = poses.R_0T;
    Q_start_ = Q_0T;
    parameter_ = rest_to_rest(gains.slerp_start, 1.0,
                              std::max(kShortestInterpolation, gains.slerpDurationErrorGain * angle));
  }
  const MotionPoint<double> s = parameter_.at(time - start_time_);
  if (gains.slerp_reference == SlerpReference::kCurrent) return {slerp(Q_0T, turn, s), true};
  // The goal moves with target and tool: the turn is computed anew, but always from the frozen start.
  return {slerp(Q_start_, gaze_turn(R_start_, poses.p_0T, p_0G), s), true};
}

}  // namespace armtune
