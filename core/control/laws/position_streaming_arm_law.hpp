#pragma once
// Streamed joint positions, as a template for one arm or several at once (arm_law.hpp). The command is the
// desired position of each joint. The robot's servo and drives follow it (joint_drives.hpp).

#include "core/control/laws/desired_joints.hpp"
#include "core/control/laws/model_arm_law.hpp"

namespace armtune::internal {

template <typename T>
class PositionStreamingArmLawT final : public ModelArmLawT<T> {
 public:
  explicit PositionStreamingArmLawT(int n) : ModelArmLawT<T>(n), desired_(n) {}

  void start(int lane, const LawNumbers& numbers) override {
    ModelArmLawT<T>::start(lane, numbers);
    desired_.start(lane);
  }

  void torque(const LawPeriodT<T>& at, JointVectorT<T>& command) override {
    desired_.compute(at);
    command = desired_.position();
  }

 private:
  DesiredJointsT<T> desired_;
};

}  // namespace armtune::internal
