#pragma once
// Computes the smooth motion into which a robot turns streamed joint positions before its drives follow it.
// UR's servoj command works like this: it smooths the stream by a gain and a look-ahead time.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

struct ServoGains {
  double gain;            ///< g, above zero [1/s^2]
  double lookahead_time;  ///< T, above zero [s]
};

/// Moves a position q_s of each joint towards its commanded position q_c:
///   q_s'' = g (q_c - (q_s + T q_s')),
/// within the velocity limits. q_s + T q_s' is the position projected ahead with the present velocity, as the
/// manual of servoj describes it (universal-robots.com, "ServoJ command", 2021). UR publishes no equation;
/// this is the linear one that fits that description. Behind a q_c that moves at a constant velocity, q_s
/// lags by T. The equation has the damping ratio T sqrt(g) / 2.
class PositionServo {
 public:
  /// period: time h between two calls of step() [s].
  PositionServo(const RobotModel& model, const ServoGains& gains, double period);

  /// Begins at rest at q (n) [rad, m].
  void start(const JointVector& q);
  /// Advances by a time h in which the commanded positions (n) stay constant. The solution of the equation is
  /// exact unless a limit acts. Joints without position limits take the shorter way. Allocates nothing.
  void step(const JointVector& commanded);

  /// q_s (n) [rad, m].
  const JointVector& position() const { return position_; }
  /// q_s' (n) [rad/s, m/s].
  const JointVector& velocity() const { return velocity_; }

 private:
  double period_;
  Eigen::Matrix2d transition_;  ///< of (q_s - q_c, q_s') over a period
  JointVector most_;            ///< velocity limits
  std::array<bool, kMaxJoints> turns_{};
  JointVector position_, velocity_;
};

}  // namespace armtune::internal
