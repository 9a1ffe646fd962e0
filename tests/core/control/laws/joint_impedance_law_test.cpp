#include "core/control/laws/joint_impedance_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/control/laws/controller.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/law_period.hpp"
#include "tests/core/support/one_joint.hpp"

namespace armtune::internal {
namespace joint_impedance_law_test {

using test::Period;

constexpr double kFactor = 0.7, kFilter = 0.3, kVelocity = 0.8;

/// A period of the law with these numbers for its options. The gains outlive the law.
void set_options(Period& p, double torque_rate) {
  own(p.gains, "joint_impedance_coriolis_factor")[0] = kFactor;
  own(p.gains, "joint_impedance_filter")[0] = kFilter;
  own(p.gains, "joint_impedance_velocity_factor")[0] = kVelocity;
  own(p.gains, "joint_impedance_torque_rate")[0] = torque_rate;
  p.law = controller_kind("joint_impedance")
              .make({p.model, p.gains, theta_of(p.model.chain), Period::period, p.mask});
}

/// C(q, q') q' by the recursion of the arm's dynamics, without gravity and friction.
JointVector coriolis(const RobotModel& model, const Poses& poses, const JointVector& qd) {
  Chain chain = model.chain;
  chain.gravity.setZero();
  chain.viscous_friction.setZero();
  chain.coulomb_friction.setZero();
  JointVector tau;
  inverse_dynamics(chain, poses, qd, JointVector(JointVector::Zero(model.n())), tau);
  return tau;
}

TEST(JointImpedanceLaw, IsASpringAndADamperOfEachJointOnTopOfTheWeight) {
  for (const RobotModel& model : test::all_arms()) {
    Period p(model, "joint_impedance", 71);
    constexpr double kRatio = 0.6;
    own(p.gains, "joint_impedance_damping_ratio").setConstant(kRatio);
    set_options(p, 0.0);
    const JointVector k = own(p.gains, "joint_impedance_k"), d = own(p.gains, "joint_impedance_d");
    JointVector reference = p.measured.q, velocity = JointVector::Zero(model.n());
    for (int period = 0; period < 5; ++period) {
      const JointVector tau = p.torque();
      velocity = kFilter * velocity + (1.0 - kFilter) * p.measured.qd;
      JointVector weight;
      gravity_torque(model.chain, p.arm.poses, weight);
      const JointVector turning = coriolis(model, p.arm.poses, p.measured.qd);
      EXPECT_GT(turning.norm(), 1e-6);
      for (int i = 0; i < model.n(); ++i) {
        EXPECT_NEAR(tau[i],
                    weight[i] + kFactor * turning[i] + k[i] * (reference[i] - p.measured.q[i]) +
                        (d[i] + 2.0 * kRatio * std::sqrt(k[i])) *
                            (kVelocity * p.control.reference.velocity[i] - velocity[i]),
                    1e-9 * (1.0 + tau.cwiseAbs().maxCoeff()))
            << p.where() << ", joint " << i << ", period " << period;
      }
      reference += Period::period * p.control.reference.velocity;
      p.move();
    }
  }
}

TEST(JointImpedanceLaw, ItsCommandBeginsAtZeroAndChangesNoFasterThanItsRate) {
  for (const RobotModel& model : test::all_arms()) {
    Period free(model, "joint_impedance", 72), bound(model, "joint_impedance", 72);
    own(free.gains, "joint_impedance_damping_ratio").setZero();
    own(bound.gains, "joint_impedance_damping_ratio").setZero();
    set_options(free, 0.0);
    constexpr double kRate = 5000.0;
    set_options(bound, kRate);
    JointVector last = JointVector::Zero(model.n());
    int at_the_bound = 0, within = 0;
    for (int period = 0; period < 20; ++period) {
      JointVector weight;
      gravity_torque(model.chain, free.arm.poses, weight);
      const JointVector wanted = free.torque() - weight, command = bound.torque() - weight;
      for (int i = 0; i < model.n(); ++i) {
        const double step =
            std::min(std::max(wanted[i] - last[i], -kRate * Period::period), kRate * Period::period);
        ++(std::abs(step) == kRate * Period::period ? at_the_bound : within);
        EXPECT_NEAR(command[i], last[i] + step, 1e-9 * (1.0 + std::abs(command[i])));
      }
      last = command;
      free.move();
      bound.move();
    }
    EXPECT_GT(at_the_bound, 0) << bound.where();
    EXPECT_GT(within, 0) << bound.where();
  }
}

// The same arm and controller once more in a few lines: torque held over a period, q'' from the equation of
// motion by Runge-Kutta's fourth order.
TEST(JointImpedanceLaw, TheClosedLoopOfOneJointIsThatOfAnIndependentIntegration) {
  const auto arm = std::make_shared<const RobotModel>(test::pendulum());
  Gains gains = test::one_joint_gains("joint_impedance");
  own(gains, "joint_impedance_k")[0] = 400.0;
  own(gains, "joint_impedance_d")[0] = 30.0;
  own(gains, "joint_impedance_filter")[0] = 0.2;
  own(gains, "joint_impedance_torque_rate")[0] = 600.0;
  constexpr double kPeriod = 0.002;
  const JointSpline plan = test::one_joint_plan();
  Controller controller(arm, gains, theta_of(arm->chain), kPeriod, TaskMask::kPosition);
  Path path;
  Scene scene;
  scene.path = &path;
  scene.plan = &plan;

  JointState state{JointVector::Constant(1, 0.25), JointVector::Zero(1)};  // beside the plan
  double q = 0.25, qd = 0.0, filtered = 0.0, command = 0.0;
  int bound = 0;
  for (int k = 0; k < 900; ++k) {
    const double time = k * kPeriod;
    const double tau = controller.update(state, scene, time).torque[0];

    const auto desired = plan.at(time);
    filtered = 0.2 * filtered + 0.8 * qd;
    const double wanted = 400.0 * (desired.position[0] - q) + 30.0 * (desired.velocity[0] - filtered);
    if (std::abs(wanted - command) > 600.0 * kPeriod) ++bound;
    command += std::min(std::max(wanted - command, -600.0 * kPeriod), 600.0 * kPeriod);
    const double own_tau = command + 3.0 * 9.81 * 0.4 * std::cos(q);
    ASSERT_NEAR(tau, own_tau, 1e-9 * (1.0 + std::abs(own_tau))) << time;

    test::integrate([&](double x, double v) { return test::pendulum_acceleration(own_tau, x, v); }, kPeriod,
                    q, qd);
    test::integrate([&](double x, double v) { return test::joint_acceleration(*arm, tau, x, v); }, kPeriod,
                    state.q[0], state.qd[0]);
    ASSERT_NEAR(state.q[0], q, 1e-9) << time;
    ASSERT_NEAR(state.qd[0], qd, 1e-8) << time;
  }
  EXPECT_GT(bound, 5);
  EXPECT_LT(bound, 800);
}

}  // namespace joint_impedance_law_test
}  // namespace armtune::internal
