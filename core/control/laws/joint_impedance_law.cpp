#include "core/control/laws/joint_impedance_law.hpp"

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {

ControllerKind joint_impedance_controller() {
  constexpr auto kJoints = GainShape::kJoints;
  constexpr auto kScalar = GainShape::kScalar;
  GainField filter = not_tuned(own_gain(kScalar, "joint_impedance_filter", "",
                                        "low-pass filter of the joint velocity: weight of the previous "
                                        "filtered velocity in the new one; 0: no filter",
                                        0.01));
  filter.below = 1.0;
  GainField ratio =
      root_in_loop(own_gain(kJoints, "joint_impedance_damping_ratio", "",
                            "damping ratio r of each joint: adds 2 r sqrt(k) to its damping d", 0.0));
  ratio.search = SearchRange::kNone;  // most controllers have none
  return {
      kJointImpedance,
      "joint impedance: g(q) + k (qd - q) + d (qd' - q') for each joint along a joint trajectory, as in the "
      "examples for Franka's arms",
      {},
      {bounded(own_gain(kJoints, "joint_impedance_k", "N m/rad", "stiffness k of each joint", 100.0)),
       own_gain(kJoints, "joint_impedance_d", "N m s/rad", "damping d of each joint", 10.0), ratio,
       not_tuned(own_gain(
           kScalar, "joint_impedance_velocity_factor", "",
           "share c of the desired velocity in the damping torque d (c qd' - q'); 1: damps the velocity "
           "error, 0: the whole velocity",
           1.0)),
       not_tuned(own_gain(kScalar, "joint_impedance_coriolis_factor", "",
                          "factor of the Coriolis and centrifugal torques that the controller adds", 1.0)),
       filter,
       not_tuned(own_gain(kScalar, "joint_impedance_torque_rate", "N m/s",
                          "largest change of each commanded torque per second; 0: no limit", 0.0))},
      [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kJointImpedance, setup); },
      [](const RobotModel& robot, const JointVector& q, Gains& gains) {
        critically_damped(robot, q, own(gains, "joint_impedance_k"), own(gains, "joint_impedance_d"));
        without_velocity_limits(gains);
      },
      false,
      ArmLawKind::kJointImpedance};
}

}  // namespace armtune::internal
