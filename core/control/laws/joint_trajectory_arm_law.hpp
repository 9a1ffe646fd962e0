#pragma once
// ROS's joint_trajectory_controller, as a template for one arm or several at once (arm_law.hpp). Its output
// is the command of jtc_command.hpp: the velocities that the drives follow, or torques. If the output is a
// torque and the robot itself compensates gravity, the torque that holds the arm's weight is added to it.
// joint_trajectory_law.hpp explains the law.

#include "core/control/laws/jtc_command.hpp"
#include "core/control/laws/model_arm_law.hpp"

namespace armtune::internal {

template <typename T>
class JointTrajectoryArmLawT final : public ModelArmLawT<T> {
 public:
  explicit JointTrajectoryArmLawT(int n) : ModelArmLawT<T>(n), command_(n) {}

  /// Uses LawNumbers::joint_trajectory.
  void start(int lane, const LawNumbers& numbers) override {
    ModelArmLawT<T>::start(lane, numbers);
    command_.start(lane, *numbers.joint_trajectory);
    this->mark(lane, numbers.joint_trajectory->held_by_robot, held_by_robot_);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) override {
    command_.compute(at, tau);
    if (!any(held_by_robot_)) return;
    this->weigh(at, weight_);
    for (Eigen::Index i = 0; i < tau.size(); ++i) {
      tau[i] = select(held_by_robot_, tau[i] + weight_[i], tau[i]);
    }
  }

 private:
  JtcCommandT<T> command_;
  MaskT<T> held_by_robot_{};
  JointVectorT<T> weight_;
};

}  // namespace armtune::internal
