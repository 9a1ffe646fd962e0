#include "core/control/laws/cartesian_impedance_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "core/control/state_machine.hpp"
#include "core/robot/dynamics.hpp"
#include "core/trajectory/rotation.hpp"
#include "tests/core/support/law_period.hpp"
#include "tests/core/support/one_joint.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace cartesian_impedance_law_test {

using test::Period;
using test::WorstError;

/// Sets the law's options and starts it anew. The gains outlive the law.
void set_options(Period& p, double nullspace_k, double filter, double torque_rate) {
  own(p.gains, "cartesian_impedance_nullspace_k")[0] = nullspace_k;
  own(p.gains, "cartesian_impedance_filter")[0] = filter;
  own(p.gains, "cartesian_impedance_torque_rate")[0] = torque_rate;
  p.law = controller_kind("cartesian_impedance")
              .make({p.model, p.gains, theta_of(p.model.chain), Period::period, p.mask});
}

/// The inverse of J^T with singular values s / (s^2 + 0.2^2), as in the source.
Eigen::MatrixXd damped_inverse(const Eigen::MatrixXd& Jt) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(Jt, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& s = svd.singularValues();
  const Eigen::VectorXd inverse = s.array() / (s.array().square() + 0.04);
  return svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
}

/// C(q, q') q' + g(q) by the recursion of the arm's dynamics, without friction.
JointVector rigid(const RobotModel& model, const Poses& poses, const JointVector& qd) {
  Chain chain = model.chain;
  chain.viscous_friction.setZero();
  chain.coulomb_friction.setZero();
  JointVector tau;
  inverse_dynamics(chain, poses, qd, JointVector(JointVector::Zero(model.n())), tau);
  return tau;
}

TEST(CartesianImpedanceLaw, IsASpringAndADamperOfTheToolAndOfTheFreeMotion) {
  WorstError law("tau = g + C q' - J^T (K e + D J q') + N (k (q_N - q) - 2 sqrt(k) q')", 1e-10);
  constexpr double kFree = 7.0;
  for (const auto& [model, mask] : test::arms_and_tasks()) {
    Period p(model, "cartesian_impedance", 81, mask);
    own(p.gains, "cartesian_impedance_damping") << 3.0, 5.0, 7.0, 0.3, 0.5, 0.7;
    set_options(p, kFree, 0.0, 0.0);
    const Vec6 damping = own(p.gains, "cartesian_impedance_damping");
    const Vec6 K = own(p.gains, "cartesian_impedance_k");
    const Vec6 ratio = own(p.gains, "cartesian_impedance_damping_ratio");
    const JointVector posture = p.measured.q;
    for (int period = 0; period < 5; ++period, p.move()) {
      const Eigen::MatrixXd E = test::rows_of(mask, p.arm.poses.R_0T);
      const Eigen::MatrixXd P = E.transpose() * E, J = E * Eigen::MatrixXd(p.arm.J);
      Vec6 e = p.control.errors.pose;
      e.tail<3>() *= std::sin(0.5 * e.tail<3>().norm()) / e.tail<3>().norm();
      Vec6 D;
      for (int i = 0; i < 6; ++i) D[i] = damping[i] + 2.0 * ratio[i] * std::sqrt(K[i]);
      const Eigen::VectorXd force = P * (K.asDiagonal() * P * e + D.asDiagonal() * P * p.arm.twist);
      const Eigen::VectorXd free = kFree * (posture - p.measured.q) - 2.0 * std::sqrt(kFree) * p.measured.qd;
      const Eigen::VectorXd wanted = Eigen::VectorXd(rigid(model, p.arm.poses, p.measured.qd)) -
                                     p.arm.J.transpose() * force + free -
                                     J.transpose() * damped_inverse(J.transpose()) * free;
      law.compare(p.torque(), JointVector(wanted), p.where());
    }
  }
}

TEST(CartesianImpedanceLaw, GivesTheTorquesThatFollowFromTheSourceOfFrankasExample) {
  std::ifstream file(test::source_dir() + "/tests/core/control/laws/data/cartesian_impedance.txt");
  ASSERT_TRUE(file);
  Period p(test::seven_joint_arm(), "cartesian_impedance", 82);
  const ParameterVector weightless = ParameterVector::Zero(13 * 7);
  Vec3 target = Vec3::Zero();
  Eigen::Quaterniond wanted = Eigen::Quaterniond::Identity();
  const auto read = [](std::istringstream& words, auto&& to) {
    for (Eigen::Index i = 0; i < to.size(); ++i) words >> to[i];
  };
  const auto read_pose = [&](std::istringstream& words, Vec3& position, Eigen::Quaterniond& turn) {
    read(words, position);
    read(words, turn.coeffs());
  };
  /// A period towards the target of the last period, as the source has it.
  const auto torque = [&](const Vec3& position, const Eigen::Quaterniond& turn) {
    p.arm.twist = p.arm.J * p.measured.qd;
    p.arm.poses.p_0T = position;
    p.arm.poses.R_0T = turn.toRotationMatrix();
    p.arm.inverse.compute(p.arm.J, {0.0, 0.05, 0.0}, TaskMask::kPose, p.arm.poses.R_0T);
    p.control.errors.pose.head<3>() = position - target;
    p.control.errors.pose.tail<3>() = -rotation_log(wanted * turn.conjugate());
    return p.torque();
  };
  std::string line, word, name;
  double largest_step = 0.0;
  JointVector last = JointVector::Zero(7);
  int cases = 0, periods = 0, limited = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    Vec3 position;
    Eigen::Quaterniond turn;
    words >> word;
    if (word == "case") {
      double share = 0.0, translational = 0.0, rotational = 0.0, free = 0.0;
      words >> name >> share >> largest_step >> translational >> rotational >> free;
      own(p.gains, "cartesian_impedance_k").head<3>().setConstant(translational);
      own(p.gains, "cartesian_impedance_k").tail<3>().setConstant(rotational);
      own(p.gains, "cartesian_impedance_damping_ratio").setOnes();
      own(p.gains, "cartesian_impedance_damping").setZero();
      own(p.gains, "cartesian_impedance_nullspace_k")[0] = free;
      own(p.gains, "cartesian_impedance_filter")[0] = 1.0 - share;
      own(p.gains, "cartesian_impedance_torque_rate")[0] = largest_step / Period::period;
      p.law = controller_kind("cartesian_impedance")
                  .make({p.model, p.gains, weightless, Period::period, TaskMask::kPose});
      ++cases;
    } else if (word == "start") {
      read(words, p.measured.q);
      read_pose(words, target, wanted);
      p.measured.qd.setZero();
      last = torque(target, wanted);
      EXPECT_LT(last.norm(), 1e-12);
    } else {
      for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 7; ++column) words >> p.arm.J(row, column);
      }
      read(words, p.measured.q);
      read(words, p.measured.qd);
      read_pose(words, position, turn);
      const JointVector tau = torque(position, turn);
      read_pose(words, target, wanted);
      JointVector expected = JointVector::Zero(7);
      read(words, expected);
      ASSERT_TRUE(words) << name;
      EXPECT_LT((tau - expected).cwiseAbs().maxCoeff(), 1e-9) << name << ", period " << periods;
      for (int i = 0; i < 7; ++i) {
        if (std::abs(expected[i] - last[i]) > largest_step * (1.0 - 1e-9)) ++limited;
      }
      last = expected;
      ++periods;
    }
  }
  EXPECT_EQ(cases, 4);
  EXPECT_EQ(periods, 24);
  EXPECT_GT(limited, 7);
}

TEST(CartesianImpedanceLaw, TracksJointsWithTheJointSpaceLaw) {
  Period p(test::ur10(), "cartesian_impedance", 83);
  set_options(p, 5.0, 0.9, 0.0);
  p.control.state = ControlState::kLeaveSingularity;
  const JointVector with = p.torque();
  const JointVector Kd = p.Kd;
  p.Kd.setZero();
  EXPECT_LT((with - p.torque() + Kd.cwiseProduct(p.control.S)).norm(), 1e-9 * with.norm());
  p.control.errors.pose *= 2.0;
  const JointVector without = p.torque();
  p.control.errors.pose.setZero();
  EXPECT_EQ(p.torque(), without);
}

TEST(CartesianImpedanceLaw, ItsTorqueContinuesThatOfTheStateBefore) {
  Period p(test::seven_joint_arm(), "cartesian_impedance", 84);
  constexpr double kRate = 500.0;
  set_options(p, 5.0, 0.0, kRate);
  p.control.state = ControlState::kLeaveSingularity;
  const JointVector weight = test::gravity_torque_at(p.model.chain, p.measured.q);
  const JointVector before = p.torque();
  p.control.state = ControlState::kFollowTrajectory;
  const JointVector after = p.torque();
  const double largest = (after - before).cwiseAbs().maxCoeff();
  EXPECT_NEAR(largest, kRate * Period::period, 1e-9);
  EXPECT_GT((before - weight).norm(), 10.0 * largest);
}

// A factor on the loop's gain is one on everything that the tool's spring and damper give.
TEST(CartesianImpedanceLaw, TheGainMarginMultipliesSpringAndDamper) {
  Period p(test::seven_joint_arm(), "cartesian_impedance", 85);
  set_options(p, 0.0, 0.0, 0.0);
  const JointVector base = rigid(p.model, p.arm.poses, p.measured.qd);
  const JointVector once = p.torque() - base;
  scale_loop_gains(p.gains, 3.0);
  set_options(p, 0.0, 0.0, 0.0);
  const JointVector thrice = p.torque() - base;
  EXPECT_GT(once.norm(), 1.0);
  EXPECT_LT((thrice - 3.0 * once).norm(), 1e-10 * thrice.norm());
}

// The first gains: along each axis e'' + 2 w e' + w^2 e = 0 for the inertia that a force at the tool moves.
TEST(CartesianImpedanceLaw, BeginsCriticallyDamped) {
  for (const RobotModel& model : {test::seven_joint_arm(), test::ur10()}) {
    const JointVector q = JointVector::Constant(model.n(), 0.4);
    Gains gains;
    change_controller(gains, "cartesian_impedance", model.n());
    controller_kind("cartesian_impedance").start(model, q, gains);
    Poses poses;
    forward_kinematics(model.chain, q, poses);
    Jacobian J;
    tool_jacobian(model.chain, poses, J);
    JointMatrix M = test::mass_matrix_at(model.chain, q);
    M.diagonal() += model.chain.rotor_inertia;
    const Vec6 mobility = (J * M.inverse() * J.transpose()).diagonal();
    for (int axis = 0; axis < 6; ++axis) {
      const double acts = axis < 3 ? 1.0 : 0.5;  // sin(angle / 2) is half of a small angle
      const double K = own(gains, "cartesian_impedance_k")[axis];
      const double D = 2.0 * own(gains, "cartesian_impedance_damping_ratio")[axis] * std::sqrt(K);
      EXPECT_NEAR(acts * K * mobility[axis], 40.0 * 40.0, 1e-6);
      EXPECT_NEAR(D * mobility[axis], 2.0 * 40.0, 1e-7);
    }
    EXPECT_EQ(own(gains, "cartesian_impedance_nullspace_k")[0] == 0.0, model.n() <= 6);
  }
}

// A pendulum whose end is pulled to a point, once more in a few lines.
TEST(CartesianImpedanceLaw, TheClosedLoopOfOneJointIsThatOfAnIndependentIntegration) {
  const RobotModel arm = test::pendulum();
  Gains gains = test::one_joint_gains("cartesian_impedance");
  own(gains, "cartesian_impedance_k") << 300.0, 1.0, 500.0, 1.0, 1.0, 1.0;
  own(gains, "cartesian_impedance_damping_ratio") << 0.6, 1.0, 0.9, 1.0, 1.0, 1.0;
  own(gains, "cartesian_impedance_nullspace_k")[0] = 4.0;
  own(gains, "cartesian_impedance_filter")[0] = 0.9;
  own(gains, "cartesian_impedance_torque_rate")[0] = 150.0;
  constexpr double kPeriod = 0.002;
  const auto law = controller_kind("cartesian_impedance")
                       .make({arm, gains, theta_of(arm.chain), kPeriod, TaskMask::kPosition});
  MeasuredArm measured;
  ControlOutput control;
  control.state = ControlState::kFollowTrajectory;
  const JointVector Kd = JointVector::Zero(1);
  const Scene scene;

  const JointVector start = JointVector::Constant(1, 0.3);
  Poses poses;
  forward_kinematics(arm.chain, start, poses);
  const double length = std::hypot(poses.p_0T.x(), poses.p_0T.z());
  const double offset =
      std::atan2(poses.p_0T.z(), poses.p_0T.x()) - 0.3;  // of the tool from the joint's angle
  const auto tool = [&](double q) {
    return Vec3(length * std::cos(q + offset), poses.p_0T.y(), length * std::sin(q + offset));
  };
  const Vec3 target = tool(0.9) + Vec3(0.02, 0.05, -0.03);
  JointState state{start, JointVector::Zero(1)};
  double q = 0.3, qd = 0.0, command = 0.0;
  Vec3 desired = tool(q);
  int bound = 0;
  for (int k = 0; k < 900; ++k) {
    measured.measure(arm.chain, state.q, state.qd, {0.0, 0.05, 0.0}, TaskMask::kPosition);
    control.errors.pose.head<3>() = measured.poses.p_0T - target;
    control.errors.pose.tail<3>().setConstant(0.2);  // not of the task
    JointVector tau;
    law->torque({state, measured, control, Kd, scene, 0.0}, tau);

    desired = 0.9 * desired + 0.1 * target;
    const Vec3 J(-length * std::sin(q + offset), 0.0, length * std::cos(q + offset));
    const Vec3 e = tool(q) - desired, rate = J * qd;
    const double force_x = 300.0 * e.x() + 2.0 * 0.6 * std::sqrt(300.0) * rate.x();
    const double force_z = 500.0 * e.z() + 2.0 * 0.9 * std::sqrt(500.0) * rate.z();
    const double free = 4.0 * (0.3 - q) - 2.0 * 2.0 * qd;
    const double wanted =
        -(J.x() * force_x + J.z() * force_z) + free * (1.0 - length * length / (length * length + 0.04));
    if (std::abs(wanted - command) > 150.0 * kPeriod) ++bound;
    command += std::min(std::max(wanted - command, -150.0 * kPeriod), 150.0 * kPeriod);
    const double own_tau = command + 3.0 * 9.81 * 0.4 * std::cos(q);
    ASSERT_NEAR(tau[0], own_tau, 1e-9 * (1.0 + std::abs(own_tau))) << k;

    test::integrate([&](double x, double v) { return test::pendulum_acceleration(own_tau, x, v); }, kPeriod,
                    q, qd);
    test::integrate([&](double x, double v) { return test::joint_acceleration(arm, tau[0], x, v); }, kPeriod,
                    state.q[0], state.qd[0]);
    ASSERT_NEAR(state.q[0], q, 1e-9) << k;
    ASSERT_NEAR(state.qd[0], qd, 1e-8) << k;
  }
  EXPECT_GT(bound, 5);
  EXPECT_LT(bound, 800);
}

}  // namespace cartesian_impedance_law_test
}  // namespace armtune::internal
