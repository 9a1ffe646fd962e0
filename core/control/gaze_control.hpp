#pragma once
// Computes the reference orientation of a tool that points at a target, the gaze (equation 7 in NOTATION.md).
// If the angle to the goal orientation is below a threshold, the reference is the goal orientation itself.
// Otherwise it is a slerp, whose parameter is a quintic with a duration of k_s times the angle.
//
// With gaze feed-forward the desired orientation turns like the line from tool to target. Without it, as
// published, the desired orientation is at rest outside slerps. With feed-forward, a slerp from its start
// also begins with the motion that the desired orientation had. If it began at rest, its velocity would
// jump, and Kd would turn that jump into a torque.
//
// An orientation that is given in place of a target is tracked in the same way. The rates are exact for a
// slerp from its start. For one from the `current` orientation they ignore that this orientation moves.

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
    Vec3 turn = Vec3::Zero();  ///< from the measured tool to its aim
  };

  /// The largest joint speeds for a slerp's own turn. The duration of the slerp is extended to keep them. The
  /// motion with which the slerp begins is added to its own turn, and the velocity governor slows both.
  struct SpeedBound {
    std::function<const TaskInverse&()> inverse;  ///< of the present Jacobian; called when a slerp starts
    const JointVector& bound;                     ///< (n) [rad/s, m/s]
  };

  /// Returns the desired orientation at `time` [s], from the measured tool orientation and the motions of
  /// tool and aim (base frame). Only feed-forward uses their velocities and accelerations.
  Output update(const Gains& gains, const Mat3& R_0T, const Eigen::Quaterniond& Q_0T,
                const MotionPoint<Vec3>& tool, const ToolAim& aim, double time,
                const std::optional<SpeedBound>& speed = {});

  /// Sets the tool's angular velocity [rad/s], with which the next slerp begins. Call it while joints are
  /// tracked.
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
  std::optional<Quintic<Vec3>> onward_;  ///< rotation vector that continues the motion before the slerp
};

}  // namespace armtune::internal
