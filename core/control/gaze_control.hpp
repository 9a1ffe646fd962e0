#pragma once
// Gaze orientation control (equation 7): below the angular threshold the goal orientation itself, above it a
// slerp whose parameter is a quintic over k_s times the angle. With gaze feed-forward the desired orientation
// turns as the line from tool to target does; without, as published, it stands still outside slerps.
// With feed-forward a slerp from its start also begins in the motion that the desired orientation had: from
// rest its velocity would jump, and Kd would make a torque of that jump.
// An orientation that is given in place of a target is turned to in the same way. The rates are exact for a
// slerp from its start; from the `current` orientation they leave out that this one moves.

#include <functional>
#include <optional>

#include "core/control/gains.hpp"
#include "core/control/task_inverse.hpp"
#include "core/control/tool_aim.hpp"
#include "core/robot/kinematics.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/quintic.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

class GazeControl {
 public:
  struct Output {
    OrientationPoint desired;  ///< Qd, wd, wd'
    bool slerping = false;
    Vec3 turn = Vec3::Zero();  ///< of the measured tool to its aim
  };

  /// Largest speed of the joints that a slerp's own turn may take: its duration is stretched for it. The
  /// motion in which it begins comes on top, and the velocity governor slows both.
  struct SpeedBound {
    std::function<const TaskInverse&()> inverse;  ///< of the Jacobian as it is; asked when a slerp starts
    const JointVector& bound;                     ///< (n) [rad/s, m/s]
  };

  /// Desired orientation at `time` [s] for the measured tool orientation and the motions of tool and aim
  /// (base frame). Only feed-forward looks at their velocities and accelerations.
  Output update(const Gains& gains, const Mat3& R_0T, const Eigen::Quaterniond& Q_0T,
                const MotionPoint<Vec3>& tool, const ToolAim& aim, double time,
                const std::optional<SpeedBound>& speed = {});

  /// To be called while joints are tracked: a slerp that comes next begins as the tool turns [rad/s].
  void tool_turns(const Vec3& angular_velocity) { last_ = {angular_velocity, Vec3::Zero()}; }

 private:
  Output next(const Gains& gains, const Mat3& R_0T, const Eigen::Quaterniond& Q_0T,
              const MotionPoint<Vec3>& tool, const ToolAim& aim, double time,
              const std::optional<SpeedBound>& speed);
  OrientationPoint interpolated(const Gains& gains, const Mat3& R_from, const Eigen::Quaterniond& Q_from,
                                const MotionPoint<Vec3>& tool, const ToolAim& aim, double time);

  bool slerping_ = false;
  double start_time_ = 0.0;
  Vec3 turn_ = Vec3::Zero();  ///< from the slerp's start to its goal, in the last period
  Mat3 R_start_ = Mat3::Identity();
  Eigen::Quaterniond Q_start_ = Eigen::Quaterniond::Identity();
  Quintic<double> parameter_ = rest_to_rest(0.0, 1.0, 1.0);
  TurnRate last_;                        ///< of the desired orientation in the last period
  std::optional<Quintic<Vec3>> onward_;  ///< the rotation vector by which a slerp goes on as it began
};

}  // namespace armtune::internal
