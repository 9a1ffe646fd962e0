#pragma once
// Computes the error with which a tool tracks its desired motion. The controller uses it for the measured
// tool. The simulation uses it for the true tool, for metrics and recordings.

#include "core/control/axis_error.hpp"
#include "core/control/control_output.hpp"
#include "core/control/task_mask.hpp"

namespace armtune::internal {

/// The errors of the tool: three of position [m], then three of orientation [rad], and their rates
/// [m/s, rad/s], in the base frame.
struct TrackingError {
  Vec6 pose = Vec6::Zero();
  Vec6 rate = Vec6::Zero();
};

/// Returns the error of a tool at R_0T and p_0T [m] with this twist [m/s, rad/s]. The position part is 0
/// while the arm avoids obstacles, because no position is desired then.
///   desired: the controller's state and desired motions; the state must be one that tracks the tool
///   turn: turn from the tool's orientation to its aim [rad]. Its negative is the orientation error, except
///         during a slerp: the error is then relative to the slerp's desired orientation.
inline TrackingError tracking_error(const Mat3& R_0T, const Vec3& p_0T, const Vec6& twist,
                                    const ControlOutput& desired, const Vec3& turn, TaskMask mask) {
  const bool turns_freely = mask == TaskMask::kPositionAndAxis;
  TrackingError error;
  if (desired.state != ControlState::kAvoidObstacles) {
    error.pose.head<3>() = p_0T - desired.desired.position;
    error.rate.head<3>() = twist.head<3>() - desired.desired.velocity;
  }
  error.pose.tail<3>() = -turn;
  if (desired.slerping) {
    const Eigen::Quaterniond& Q = desired.desired_gaze.orientation;
    error.pose.tail<3>() =
        turns_freely ? axis_error(R_0T, Q) : Vec3(-rotation_log(Q * Eigen::Quaterniond(R_0T).conjugate()));
  }
  const Vec3 rate = twist.tail<3>() - desired.desired_gaze.angular_velocity;
  error.rate.tail<3>() = turns_freely ? axis_rate(R_0T, rate) : rate;
  return error;
}

}  // namespace armtune::internal
