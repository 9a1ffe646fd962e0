#include "core/control/laws/first_gains.hpp"

#include <Eigen/LU>

#include "core/robot/dynamics.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {
namespace {

constexpr double kFirstTaskIntegral = 0.1;  // 1/s^2
constexpr double kMoves = 1e-9;             // share of the most mobile axis, below which an axis is fixed

}  // namespace

JointMatrix mass_with_rotors(const RobotModel& robot, const JointVector& q) {
  Poses poses;
  forward_kinematics(robot.chain, q, poses);
  JointMatrix M;
  mass_matrix(robot.chain, poses, M);
  M.diagonal() += robot.chain.rotor_inertia;
  return M;
}

JointVector joint_inertia(const RobotModel& robot, const JointVector& q) {
  return JointMatrix(mass_with_rotors(robot, q).inverse()).diagonal().cwiseInverse();
}

void critically_damped(const RobotModel& robot, const JointVector& q, JointVector& stiffness,
                       JointVector& damping) {
  damping = kFirstRate * joint_inertia(robot, q);
  stiffness = 0.25 * kFirstRate * damping;
}

Vec6 task_inertia(const RobotModel& robot, const JointVector& q) {
  Poses poses;
  forward_kinematics(robot.chain, q, poses);
  const JointMatrix mobility = mass_with_rotors(robot, q).inverse();
  Jacobian J;
  tool_jacobian(robot.chain, poses, J);
  const Vec6 moved = (J * mobility * J.transpose()).diagonal();
  Vec6 inertia = Vec6::Zero();
  for (int first : {0, 3}) {
    const double most = moved.segment<3>(first).maxCoeff();
    for (int axis = first; axis < first + 3; ++axis) {
      if (moved[axis] > kMoves * most) inertia[axis] = 1.0 / moved[axis];
    }
  }
  return inertia;
}

void first_references(Gains& gains) {
  if (!gains.task_space_gains_p.isZero(0.0)) return;
  gains.task_space_gains_p.setConstant(kFirstTaskRate);
  gains.task_space_gains_i.setConstant(kFirstTaskIntegral);
}

void without_velocity_limits(Gains& gains) {
  gains.velocity_margin = 0.0;
  gains.velocity_barrier_gain = 0.0;
}

}  // namespace armtune::internal
