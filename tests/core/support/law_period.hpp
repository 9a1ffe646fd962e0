#pragma once
// One control period of a law, away from states and rollouts: everything a law may look at, at random.

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/task_resolution.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal::test {

/// An arm at a random state with random errors and references, and a law with random gains that knows the
/// arm.
class Period {
 public:
  Period(const RobotModel& robot, const std::string& kind, unsigned seed,
         TaskMask task_mask = TaskMask::kPose)
      : model(robot), mask(task_mask), generator_(seed), theta_(theta_of(robot.chain)) {
    const int n = model.n();
    change_controller(gains, kind, n);
    const std::vector<GainField>& fields = controller_kind(kind).own;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      JointVector& own = gains.own[i];
      own = random_vector(generator_, static_cast<int>(own.size()), 50.0).cwiseAbs();
      if (std::isfinite(fields[i].below)) own.setConstant(fields[i].otherwise);  // shares and choices
    }
    Kd = random_vector(generator_, n, 50.0).cwiseAbs();
    law = controller_kind(kind).make({model, gains, theta_, period, mask});
    move();
  }

  /// Another state, other errors and references, of a state that tracks the tool.
  void move() {
    const int n = model.n();
    measured = {random_configuration(generator_, model), random_vector(generator_, n, 1.0)};
    arm.measure(model.chain, measured.q, measured.qd, {0.0, 0.05, 0.0}, mask);
    arm.differentiate(model.chain, measured.qd);
    control.state = ControlState::kFollowTrajectory;
    control.errors.pose = random_vector(generator_, 6, 0.1);
    task = {random_vector(generator_, 6, 1.0), random_vector(generator_, 6, 2.0)};
    const JointCentering centering{random_vector(generator_, n, 1.0),
                                   random_vector(generator_, n, 1.0).cwiseAbs()};
    resolve(task, arm, centering, measured.q, measured.qd, control.reference);
    control.S = measured.qd - control.reference.velocity;
  }

  JointVector torque() {
    JointVector tau;
    law->torque({measured, arm, control, Kd, scene, 0.0}, tau);
    return tau;
  }
  /// q'' (n) that the torque gives the arm.
  JointVector acceleration(const JointVector& tau) {
    ForwardDynamics work;
    JointVector qdd;
    forward_dynamics(model.chain, arm.poses, measured.qd, tau, work, qdd);
    return qdd;
  }
  /// M(q) + D.
  JointMatrix mass() const {
    JointMatrix M = mass_matrix_at(model.chain, measured.q);
    M.diagonal() += model.chain.rotor_inertia;
    return M;
  }
  /// Away from singularities, where an identity of the exact inverse can be held to rounding.
  bool is_regular() const { return arm.inverse.manipulability() > 1e-2; }
  std::string where() const { return model.name + " under " + gains.controller; }

  static constexpr double period = 0.002;
  RobotModel model;
  TaskMask mask;
  Gains gains;
  JointVector Kd;
  JointState measured;
  MeasuredArm arm;
  TaskReference task;
  ControlOutput control;
  Scene scene;
  std::unique_ptr<TorqueLaw> law;

 private:
  std::mt19937 generator_;
  ParameterVector theta_;
};

/// Arms with a task that they have joints for.
struct ArmAndTask {
  RobotModel arm;
  TaskMask mask;
};
inline std::vector<ArmAndTask> arms_and_tasks() {
  std::vector<ArmAndTask> all;
  std::vector<RobotModel> arms = all_arms();
  arms.push_back(random_arm(5, 45, false));
  for (const RobotModel& arm : arms) {
    for (const TaskMask mask : {TaskMask::kPose, TaskMask::kPositionAndAxis, TaskMask::kPosition}) {
      if (components(mask) <= arm.n()) all.push_back({arm, mask});
    }
  }
  return all;
}

/// E: rows of the task among the six, written out.
inline Eigen::MatrixXd rows_of(TaskMask mask, const Mat3& R_0T) {
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(components(mask), 6);
  E.leftCols(3).topRows(3).setIdentity();
  if (mask == TaskMask::kPose) E.bottomRightCorner(3, 3).setIdentity();
  if (mask == TaskMask::kPositionAndAxis) E.bottomRightCorner(2, 3) = R_0T.leftCols(2).transpose();
  return E;
}

}  // namespace armtune::internal::test
