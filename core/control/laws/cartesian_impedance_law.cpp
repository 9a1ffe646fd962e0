#include "core/control/laws/cartesian_impedance_law.hpp"

#include <cmath>

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

/// The law has no integral, so the stiffness alone resists errors of the model.
constexpr double kFirstStiffRate = 40.0;  // 1/s

/// Sets critically damped gains for each axis of the task, with both poles at kFirstStiffRate. The rotational
/// stiffness acts with half of its value.
void first_impedance(const RobotModel& robot, const JointVector& q, Gains& gains) {
  const Vec6 inertia = task_inertia(robot, q);
  JointVector& K = own(gains, "cartesian_impedance_k");
  JointVector& ratio = own(gains, "cartesian_impedance_damping_ratio");
  for (int axis = 0; axis < 6; ++axis) {
    const double share = axis < 3 ? 1.0 : 0.5;
    K[axis] = kFirstStiffRate * kFirstStiffRate * inertia[axis] / share;
    ratio[axis] = std::sqrt(share * inertia[axis]);
  }
  // With up to six joints no motion is free, but the damped projector would let part of the torque through.
  if (robot.n() <= 6) own(gains, "cartesian_impedance_nullspace_k")[0] = 0.0;
  without_velocity_limits(gains);
}

}  // namespace

ControllerKind cartesian_impedance_controller() {
  constexpr auto kTask = GainShape::kTask;
  constexpr auto kScalar = GainShape::kScalar;
  GainField filter =
      not_tuned(own_gain(kScalar, "cartesian_impedance_filter", "",
                         "low-pass filter of the desired pose: weight of the previous filtered "
                         "pose in the new one; 0: no filter",
                         0.0));
  filter.below = 1.0;
  GainField damping =
      own_gain(kTask, "cartesian_impedance_damping", "N s/m, N m s",
               "damping d of each axis of the task, in addition to 2 r sqrt(K); to set the damping by d "
               "alone, set the damping ratio r to 0",
               0.0);
  damping.search = SearchRange::kNone;  // most controllers have none
  return {kCartesianImpedance,
          "Cartesian impedance without feed-forward: g(q) + C q' - J^T (K e + D x') and a null space, as in "
          "the examples for Franka's arms",
          {},
          {bounded(own_gain(kTask, "cartesian_impedance_k", "N/m, N m",
                            "stiffness K of each axis of the task; rotations act on sin(angle / 2)", 200.0)),
           root_in_loop(own_gain(kTask, "cartesian_impedance_damping_ratio", "",
                                 "damping ratio r of each axis of the task, D = d + 2 r sqrt(K)", 1.0)),
           damping,
           not_tuned(own_gain(kScalar, "cartesian_impedance_nullspace_k", "N m/rad",
                              "stiffness k of the joint motion that the task leaves free, towards the joint "
                              "positions at the start; its damping is 2 sqrt(k)",
                              10.0)),
           filter,
           not_tuned(own_gain(kScalar, "cartesian_impedance_torque_rate", "N m/s",
                              "largest change of each commanded torque per second; 0: no limit", 0.0))},
          [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kCartesianImpedance, setup); },
          first_impedance,
          false,
          ArmLawKind::kCartesianImpedance};
}

}  // namespace armtune::internal
