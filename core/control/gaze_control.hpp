#pragma once
// Computes the reference orientation of a tool that points at a target. This pointing is called the gaze
// (equation 7 in NOTATION.md). While the angle to the goal orientation is below a threshold, the reference is
// the goal orientation itself. At a larger angle a spherical linear interpolation (slerp) to the goal starts.
// Its parameter is a quintic polynomial in time, whose duration is k_s (the gain slerpDurationErrorGain)
// times the angle.
//
// Without gaze feed-forward, as published, the desired angular velocity is zero outside slerps. With gaze
// feed-forward, it is the angular velocity of the line from tool to target. A slerp with
// SlerpReference::kStart then starts with the angular velocity that the desired orientation had before. If it
// started at rest, the desired velocity would jump, and Kd would turn that jump into a torque.
//
// An orientation that is given in place of a target is tracked in the same way. The angular velocity and
// acceleration of a slerp are exact with SlerpReference::kStart. With kCurrent they ignore that the current
// orientation moves.

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

  /// Bounds on the joint velocities during a slerp. The slerp is made long enough for its interpolation to
  /// keep within them. The velocity that the tool already has when the slerp starts is not counted here; the
  /// velocity governor limits the sum of both.
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
  TurnRate last_;                        ///< turn rate of the desired orientation in the last period
  std::optional<Quintic<Vec3>> onward_;  ///< rotation vector that continues the motion before the slerp
};

}  // namespace armtune::internal
