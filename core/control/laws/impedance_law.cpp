#include "core/control/laws/impedance_law.hpp"

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

constexpr double kStiffRate = 40.0;  // 1/s
/// Motion outside the task has no stiffness. There only the joints' damping resists errors of the model;
/// without it the arm would drift to its limits.
constexpr double kDampedRate = 20.0;  // 1/s

}  // namespace

ControllerKind impedance_controller() {
  constexpr auto kTask = GainShape::kTask;
  return {
      "impedance",
      "Cartesian impedance: Y theta - J^T (K dx + D (x' - xd')) along the desired motion",
      {},
      {bounded(own_gain(kTask, "impedance_k", "N/m, N m/rad", "stiffness of each axis of the task", 1000.0)),
       own_gain(kTask, "impedance_d", "N s/m, N m s/rad", "damping of each axis of the task", 100.0),
       own_gain(GainShape::kJoints, "impedance_joint_d", "N m s/rad", "damping of each joint", 1.0)},
      [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kImpedance, setup); },
      [](const RobotModel& robot, const JointVector& q, Gains& gains) {
        // Critically damped. The law has no integral, so stiffness alone resists errors of the model.
        const Vec6 inertia = task_inertia(robot, q);
        own(gains, "impedance_k") = kStiffRate * kStiffRate * inertia;
        own(gains, "impedance_d") = 2.0 * kStiffRate * inertia;
        own(gains, "impedance_joint_d") = kDampedRate * joint_inertia(robot, q);
      },
      false,
      ArmLawKind::kImpedance};
}

}  // namespace armtune::internal
