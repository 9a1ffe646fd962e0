#pragma once
// The command of ROS's joint_trajectory_controller (joint_trajectory_law.hpp), an effort or a velocity of
// each joint, as a template for one arm or several at once (arm_law.hpp):
//   c_i = ff_velocity_scale * qd_i' + PID(e_i, e_i'),   e = qd - q,   qd: desired positions.

#include <array>
#include <cmath>

#include "core/control/laws/desired_joints.hpp"
#include "core/control/laws/ros_pid.hpp"

namespace armtune::internal {

/// The numbers of such a controller that do not change. They are made from the gains by jtc_numbers
/// (joint_trajectory_law.hpp).
struct JtcNumbers {
  std::array<RosPidGains, kMaxJoints> pid{};
  std::array<double, kMaxJoints> feed_forward{};  ///< ff_velocity_scale
  std::array<bool, kMaxJoints> wraps{};  ///< true: the position error of the joint is wrapped to -pi .. pi
  /// True if the command is an effort to which the robot itself adds the torque that holds its weight.
  bool held_by_robot = false;
};

template <typename T>
class JtcCommandT : LaneAccessT<T> {
 public:
  /// n: number of joints.
  explicit JtcCommandT(int n) : desired_(n) { feed_forward_.setZero(n); }

  void start(int lane, const JtcNumbers& numbers) {
    desired_.start(lane);
    for (Eigen::Index i = 0; i < feed_forward_.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      pids_[k].start(lane, numbers.pid[k]);
      this->put(lane, numbers.feed_forward[k], feed_forward_[i]);
      this->mark(lane, numbers.wraps[k], wraps_[k]);
    }
  }

  /// Computes the command (n) of this period. Allocates nothing.
  void compute(const LawPeriodT<T>& at, JointVectorT<T>& command) {
    desired_.compute(at);
    command.resize(feed_forward_.size());
    for (Eigen::Index i = 0; i < command.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const T error = wrapped(wraps_[k], desired_.position()[i] - at.q[i]);
      const T fed_velocity = select(at.planned.active, at.planned.fed_velocity[i], desired_.velocity()[i]);
      command[i] =
          feed_forward_[i] * fed_velocity + pids_[k].output(error, desired_.velocity()[i] - at.qd[i], at.dt);
    }
  }

 private:
  /// Returns the angle [rad], wrapped to -pi .. pi where the mask is set.
  static T wrapped(const MaskT<T>& where, const T& angle) {
    using std::abs;
    T result = angle;
    const MaskT<T> far = LaneAccessT<T>::both(where, abs(angle) > T(M_PI));
    if (!any(far)) return result;
    for (int lane = 0; lane < LaneAccessT<T>::kLanes; ++lane) {
      if (!LaneAccessT<T>::is_marked(lane, far)) continue;
      LaneAccessT<T>::put(lane, std::remainder(LaneAccessT<T>::get(lane, angle), 2.0 * M_PI), result);
    }
    return result;
  }

  DesiredJointsT<T> desired_;
  std::array<RosPidT<T>, kMaxJoints> pids_;
  MaskT<T> wraps_[kMaxJoints] = {};
  JointVectorT<T> feed_forward_;
};

}  // namespace armtune::internal
