#include "core/control/laws/joint_pd_law.hpp"

#include <Eigen/Eigenvalues>

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

constexpr double kOuterShare = 0.25;  // largest task gain over the slowest joint motion's rate

/// Returns the smallest eigenvalue of M^-1 D [1/s], the rate at which the slowest joint motion decays.
double slowest_rate(const RobotModel& robot, const JointVector& q, const JointVector& D) {
  const JointVector scale = D.cwiseSqrt().cwiseInverse();
  const JointMatrix slowness = scale.asDiagonal() * mass_with_rotors(robot, q) * scale.asDiagonal();
  return 1.0 / Eigen::SelfAdjointEigenSolver<JointMatrix>(slowness).eigenvalues().maxCoeff();
}

}  // namespace

ControllerKind joint_pd_controller() {
  constexpr auto kJoints = GainShape::kJoints;
  return {"joint_pd",
          "joint PD with gravity: g(q) + P (q_ref - q) + D (qr' - q'), where q_ref is the integral of qr'",
          {"task_space_gains_p", "task_space_gains_i", "interpolation_gain_scale"},
          {own_gain(kJoints, "joint_pd_p", "N m/rad", "P on the position error of each joint", 100.0),
           own_gain(kJoints, "joint_pd_d", "N m s/rad", "D on the velocity error of each joint", 20.0)},
          [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kJointPd, setup); },
          [](const RobotModel& robot, const JointVector& q, Gains& gains) {
            JointVector& D = own(gains, "joint_pd_d");
            critically_damped(robot, q, own(gains, "joint_pd_p"), D);
            // Coupling between joints slows the joint loops. The task's loop around them must be slower
            // still.
            const Vec6 Kp = gains.task_space_gains_p.cwiseMin(kOuterShare * slowest_rate(robot, q, D));
            gains.task_space_gains_p = Kp;
            gains.task_space_gains_i = kFirstIntegralShare * Kp.cwiseAbs2();
          },
          false,
          ArmLawKind::kJointPd};
}

}  // namespace armtune::internal
