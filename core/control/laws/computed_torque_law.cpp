#include "core/control/laws/computed_torque_law.hpp"

#include "core/control/laws/first_gains.hpp"
#include "core/control/task_resolution.hpp"

namespace armtune::internal {
namespace {

/// No part of this law learns the errors of the model: the feedback alone corrects what they do.
constexpr double kStiffRate = 60.0;  // 1/s

class ComputedTorqueLaw final : public TorqueLaw {
 public:
  explicit ComputedTorqueLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        D_(own(setup.gains, "computed_torque_d")),
        d_(own(setup.gains, "computed_torque_joint_d")[0]) {}

  void torque(const LawInput& in, JointVector& tau) override {
    const JointVector& S = in.control.S;
    acceleration_ = in.control.reference.acceleration - d_ * S;
    if (!tracks_joints(in.control.state)) {
      const TaskInverse& inverse = in.arm.inverse;
      const Vec6 s = times(in.arm.J, S);
      Vec6 wanted = D_.cwiseProduct(inverse.of_task(s)) + times(in.arm.J_dot, S);
      wanted -= d_ * s;
      if (inverse.mask() == TaskMask::kPositionAndAxis) wanted -= turning(Vec3(in.arm.twist.tail<3>()), s);
      inverse.apply(wanted, correction_);
      acceleration_ -= correction_;
    }
    model_torque(in.arm, in.measured.qd, in.measured.qd, acceleration_, tau);
  }

 private:
  Vec6 D_;
  double d_;
  JointVector acceleration_, correction_;
};

}  // namespace

ControllerKind computed_torque_controller() {
  return {"computed_torque",
          "computed torque in Cartesian space: the model inverted along J+ (xr'' - D (x' - xr') - J' q')",
          {"task_space_gains_p", "task_space_gains_i", "interpolation_gain_scale"},
          {own_gain(GainShape::kTask, "computed_torque_d", "1/s",
                    "D of each axis of the task on its velocity error", kStiffRate),
           own_gain(GainShape::kScalar, "computed_torque_joint_d", "1/s",
                    "damping of joint motion outside the task, and in states that track joints", kStiffRate)},
          [](const LawSetup& setup) { return std::make_unique<ComputedTorqueLaw>(setup); },
          {}};
}

}  // namespace armtune::internal
