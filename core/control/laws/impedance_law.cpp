#include "core/control/laws/impedance_law.hpp"

#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

constexpr double kStiffRate = 40.0;  // 1/s
/// Outside the task nothing is stiff: there the joints' dampers alone hold an arm on its references against
/// what the model has wrong, or it drifts to its limits.
constexpr double kDampedRate = 20.0;  // 1/s

class ImpedanceLaw final : public TorqueLaw {
 public:
  explicit ImpedanceLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        K_(own(setup.gains, "impedance_k")),
        D_(own(setup.gains, "impedance_d")),
        B_(own(setup.gains, "impedance_joint_d")) {}

  void torque(const LawInput& in, JointVector& tau) override {
    const ControlOutput& control = in.control;
    model_torque(in.arm, in.measured.qd, control.reference.velocity, control.reference.acceleration, tau);
    if (tracks_joints(control.state)) {
      tau -= in.Kd.cwiseProduct(control.S);
      return;
    }
    // Only what is the task: a free turn of the tool is nobody's error.
    const TaskInverse& inverse = in.arm.inverse;
    const Vec6 dx = inverse.of_task(control.errors.pose);
    const Vec6 dx_dot = inverse.of_task(times(in.arm.J, control.S));
    const Vec6 force = inverse.of_task(K_.cwiseProduct(dx) + D_.cwiseProduct(dx_dot));
    transposed_times(in.arm.J, force, back_);
    tau -= back_ + B_.cwiseProduct(control.S);
  }

  const SlotineLi* references_motion() const override { return &motion_; }

 private:
  Vec6 K_, D_;
  JointVector B_, back_;
};

}  // namespace

ControllerKind impedance_controller() {
  constexpr auto kTask = GainShape::kTask;
  return {"impedance",
          "Cartesian impedance: Y theta - J^T (K dx + D (x' - xd')) along the desired motion",
          {},
          {own_gain(kTask, "impedance_k", "N/m, N m/rad", "stiffness of each axis of the task", 1000.0),
           own_gain(kTask, "impedance_d", "N s/m, N m s/rad", "damping of each axis of the task", 100.0),
           own_gain(GainShape::kJoints, "impedance_joint_d", "N m s/rad", "damping of each joint", 1.0)},
          [](const LawSetup& setup) { return std::make_unique<ImpedanceLaw>(setup); },
          [](const RobotModel& robot, const JointVector& q, Gains& gains) {
            // Critically damped. Nothing integrates, so what the model has wrong is held by stiffness alone.
            const Vec6 inertia = task_inertia(robot, q);
            own(gains, "impedance_k") = kStiffRate * kStiffRate * inertia;
            own(gains, "impedance_d") = 2.0 * kStiffRate * inertia;
            own(gains, "impedance_joint_d") = kDampedRate * joint_inertia(robot, q);
          }};
}

}  // namespace armtune::internal
