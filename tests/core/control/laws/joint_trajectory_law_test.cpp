#include "core/control/laws/joint_trajectory_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/control/laws/controller.hpp"
#include "core/control/laws/ros_pid.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/law_period.hpp"
#include "tests/core/support/one_joint.hpp"

namespace armtune::internal {
namespace joint_trajectory_law_test {

using test::Period;

// In states that follow no trajectory the references are integrated from where the arm was.
TEST(JointTrajectoryLaw, IsAPidOfEachJointAlongTheIntegratedReferences) {
  int bounded = 0, unbounded = 0;
  for (const RobotModel& model : test::all_arms()) {
    Period p(model, "joint_trajectory_controller", 91);
    own(p.gains, "jtc_error_deadband") *= 0.002;  // of the size of the errors
    p.law = controller_kind("joint_trajectory_controller")
                .make({p.model, p.gains, theta_of(p.model.chain), Period::period, p.mask});
    const JointVector most = own(p.gains, "jtc_u_clamp_max"), least = -own(p.gains, "jtc_u_clamp_min");
    const JointVector deadband = own(p.gains, "jtc_error_deadband");
    const JointVector P = own(p.gains, "jtc_p"), I = own(p.gains, "jtc_i"), D = own(p.gains, "jtc_d");
    const JointVector ff = own(p.gains, "jtc_ff_velocity_scale"), clamp = own(p.gains, "jtc_i_clamp");
    const JointVector lower_clamp = own(p.gains, "jtc_i_clamp_min");
    JointVector reference = p.measured.q;
    JointVector integral = JointVector::Zero(model.n());
    for (int k = 0; k < 5; ++k) {
      const JointVector tau = p.torque();
      for (int i = 0; i < model.n(); ++i) {
        double error = reference[i] - p.measured.q[i];
        if (!model.joints[static_cast<std::size_t>(i)].limits.has_position)
          error = std::atan2(std::sin(error), std::cos(error));
        if (std::abs(error) > deadband[i])
          integral[i] =
              std::min(std::max(integral[i] + I[i] * Period::period * error, -lower_clamp[i]), clamp[i]);
        const double output = P[i] * error + integral[i] - (D[i] * p.control.S[i]);
        ++(output > most[i] || output < least[i] ? bounded : unbounded);
        EXPECT_NEAR(tau[i],
                    std::min(std::max(output, least[i]), most[i]) + ff[i] * p.control.reference.velocity[i],
                    1e-9 * (1.0 + std::abs(tau[i])))
            << p.where() << ", joint " << i << ", period " << k;
      }
      reference += Period::period * p.control.reference.velocity;
      p.move();
    }
  }
  EXPECT_GT(bounded, 0);
  EXPECT_GT(unbounded, 0);
}

// ros_pid_test has the arithmetic of each kind.
TEST(JointTrajectoryLaw, ChoosesTheAntiWindupByItsNumber) {
  constexpr AntiWindup kKinds[] = {AntiWindup::kOfContribution, AntiWindup::kOfIntegral, AntiWindup::kNone,
                                   AntiWindup::kConditional, AntiWindup::kBackCalculation};
  for (int kind = 0; kind < 5; ++kind) {
    Period p(test::pendulum(), "joint_trajectory_controller", 93);
    const auto set = [&p](const char* name, double value) { own(p.gains, name).setConstant(value); };
    set("jtc_p", 30.0);
    set("jtc_i", 40000.0);
    set("jtc_d", 0.0);
    set("jtc_i_clamp", 20.0);
    set("jtc_i_clamp_min", 20.0);
    set("jtc_ff_velocity_scale", 0.0);
    set("jtc_antiwindup", kind);
    set("jtc_tracking_time", 0.01);
    set("jtc_error_deadband", 1e-3);
    set("jtc_u_clamp_max", 10.0);
    set("jtc_u_clamp_min", 5.0);
    p.law = controller_kind("joint_trajectory_controller")
                .make({p.model, p.gains, theta_of(p.model.chain), Period::period, p.mask});
    RosPid pid;
    pid.start(0, {30.0, 40000.0, 0.0, 20.0, -20.0, 10.0, -5.0, kKinds[kind], 0.01, 1e-3});
    JointVector reference = p.measured.q;
    for (int k = 0; k < 50; ++k) {
      const double error = reference[0] - p.measured.q[0];
      const double output = pid.output(error, 0.0, Period::period);
      ASSERT_NEAR(p.torque()[0], output, 1e-9) << kind << ", period " << k;
      reference += Period::period * p.control.reference.velocity;
      p.move();
    }
  }
}

// A robot that holds its own weight adds g(q), here by the recursion that the arm's dynamics use.
// At the error at which p alone gives the largest torque, an integral that a clamp bounds reaches it in the
// same time as an unbounded one reaches the largest torque.
TEST(JointTrajectoryLaw, AnIntegralIsReducedToWhatItsClampLetsItGive) {
  const RobotModel arm = test::ur10();
  const JointVector effort = arm.effort_limits();
  Gains gains;
  change_controller(gains, kJointTrajectoryController, 6);
  JointVector &p = jtc_gain(gains, "p"), &i = jtc_gain(gains, "i");
  p << 4000.0, 3000.0, 2000.0, 500.0, 400.0, 0.0;
  i = 2.0 * p;
  jtc_gain(gains, "i_clamp") << 1.0, 0.5 * effort[1], 1e6, 0.0, 3.0, 1.0;
  jtc_gain(gains, "i_clamp_min")[4] = 2.0;
  JointVector reached(6);
  reached << 1.0, 0.5 * effort[1], effort[2], 0.0, 2.0, 0.0;
  fit_integral_to_clamp(arm, gains);
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(i[k] * effort[k] / p[k] / 2.0, reached[k], 1e-12 * effort[k]) << k;
  EXPECT_EQ(i[5], 0.0);
}

TEST(JointTrajectoryLaw, OfARobotThatCompensatesGravityHasTheWeightOnTop) {
  for (RobotModel model : test::all_arms()) {
    Period alone(model, "joint_trajectory_controller", 92);
    model.compensates_gravity = true;
    Period held(model, "joint_trajectory_controller", 92);
    for (int k = 0; k < 3; ++k) {
      JointVector weight;
      gravity_torque(model.chain, held.arm.poses, weight);
      const JointVector with = held.torque(), without = alone.torque();
      EXPECT_LT((with - without - weight).cwiseAbs().maxCoeff(), 1e-9 * (1.0 + with.cwiseAbs().maxCoeff()))
          << held.where();
      EXPECT_GT(weight.norm(), 1e-3);
      held.move();
      alone.move();
    }
  }
}

// The same arm and controller once more in a few lines: torque held over a period, q'' from the equation of
// motion by Runge-Kutta's fourth order.
TEST(JointTrajectoryLaw, TheClosedLoopOfOneJointIsThatOfAnIndependentIntegration) {
  const auto arm = std::make_shared<const RobotModel>(test::pendulum());
  Gains gains = test::one_joint_gains("joint_trajectory_controller");
  own(gains, "jtc_p")[0] = 400.0;
  own(gains, "jtc_i")[0] = 900.0;
  own(gains, "jtc_d")[0] = 30.0;
  own(gains, "jtc_i_clamp")[0] = 4.0;
  own(gains, "jtc_ff_velocity_scale")[0] = 1.5;
  constexpr double kPeriod = 0.002;
  const JointSpline plan = test::one_joint_plan();
  Controller controller(arm, gains, theta_of(arm->chain), kPeriod, TaskMask::kPosition);
  const JointVector zero = JointVector::Zero(1);
  Path path;
  Scene scene;
  scene.path = &path;
  scene.plan = &plan;

  JointState state{JointVector::Constant(1, 0.2), zero};
  double q = 0.2, qd = 0.0, integral = 0.0;
  bool clamped = false;
  for (int k = 0; k < 900; ++k) {
    const double time = k * kPeriod;
    const double tau = controller.update(state, scene, time).torque[0];

    const auto desired = plan.at(time);
    const double error = desired.position[0] - q;
    integral = std::min(std::max(integral + 900.0 * kPeriod * error, -4.0), 4.0);
    clamped = clamped || std::abs(integral) == 4.0;
    const double own_tau = 400.0 * error + integral + 30.0 * (desired.velocity[0] - qd) +
                           1.5 * plan.at(time + kPeriod).velocity[0];
    ASSERT_NEAR(tau, own_tau, 1e-9 * (1.0 + std::abs(own_tau))) << time;

    test::integrate([&](double x, double v) { return test::pendulum_acceleration(own_tau, x, v); }, kPeriod,
                    q, qd);
    test::integrate([&](double x, double v) { return test::joint_acceleration(*arm, tau, x, v); }, kPeriod,
                    state.q[0], state.qd[0]);
    ASSERT_NEAR(state.q[0], q, 1e-9) << time;
    ASSERT_NEAR(state.qd[0], qd, 1e-8) << time;
  }
  EXPECT_TRUE(clamped);
}

// With velocity commands, on the same arm: the PID's velocity within the joint's limit, and the drive's PI
// under it, which begins with the torque that holds the arm. The drive runs once or several times in a
// control period, and the commands may reach it late. After the end of the plan the desired velocity is zero.
TEST(JointTrajectoryLaw, WithVelocityCommandsTheDriveFollowsThePid) {
  RobotModel model = test::pendulum();
  model.joints[0].limits.velocity = 1.2;  // which the command passes at first
  model.drive_velocity_gain = JointVector::Constant(1, 40.0);
  model.drive_velocity_integral = JointVector::Constant(1, 300.0);
  const auto arm = std::make_shared<const RobotModel>(model);
  Gains gains = test::one_joint_gains("joint_trajectory_controller_velocity");
  own(gains, "jtc_velocity_p")[0] = 9.0;
  own(gains, "jtc_velocity_i")[0] = 3.0;
  own(gains, "jtc_velocity_d")[0] = 0.1;
  own(gains, "jtc_velocity_i_clamp")[0] = 0.5;
  own(gains, "jtc_velocity_ff_velocity_scale")[0] = 0.9;
  constexpr double kPeriod = 0.002;
  const auto at = [](double q, double v) {
    return MotionPoint<JointVector>{JointVector::Constant(1, q), JointVector::Constant(1, v),
                                    JointVector::Zero(1)};
  };
  const JointSpline plan({0.0, 1.5}, {at(0.5, 0.4), at(1.1, 0.4)});
  for (const auto& [steps, delay] : {std::pair{1, 0}, {4, 0}, {4, 2}}) {
    Controller controller(arm, gains, theta_of(arm->chain), kPeriod, TaskMask::kPosition,
                          {steps / kPeriod, delay});
    Path path;
    Scene scene;
    scene.path = &path;
    scene.plan = &plan;
    scene.holds_plan = true;

    double q = 0.2, qd = 0.0, of_pid = 0.0, of_drive = 3.0 * 9.81 * 0.4 * std::cos(0.2);
    std::vector<double> commands(static_cast<std::size_t>(delay), 0.0);
    bool cut = false;
    for (int k = 0; k < 900; ++k) {
      const double time = k * kPeriod;
      const bool over = time >= 1.5;
      const double error = (over ? 1.1 : plan.at(time).position[0]) - q;
      of_pid = std::clamp(of_pid + 3.0 * kPeriod * error, -0.5, 0.5);
      commands.push_back((time + kPeriod > 1.5 ? 0.0 : 0.9 * 0.4) + 9.0 * error + of_pid +
                         0.1 * ((over ? 0.0 : 0.4) - qd));
      const double wanted = commands[static_cast<std::size_t>(k)];
      cut = cut || std::abs(wanted) > 1.2;
      for (int step = 0; step < steps; ++step) {
        const JointState state{JointVector::Constant(1, q), JointVector::Constant(1, qd)};
        JointVector unlimited, limited;
        if (step == 0) {
          limited = controller.update(state, scene, time).torque;
        } else {
          controller.drive(state, unlimited, limited);
        }
        const double slip = std::clamp(wanted, -1.2, 1.2) - qd;
        of_drive += 300.0 * (kPeriod / steps) * slip;
        ASSERT_NEAR(limited[0], 40.0 * slip + of_drive, 1e-9 * (1.0 + std::abs(limited[0]))) << time;

        // Half steps of leapfrog, which is enough to lead the arm on.
        for (int part = 0; part < 4; ++part) {
          const double h = kPeriod / steps / 4.0;
          q += 0.5 * h * qd;
          qd += h * (limited[0] - 3.0 * 9.81 * 0.4 * std::cos(q) - 1.5 * qd) / (0.6 + 0.2);
          q += 0.5 * h * qd;
        }
      }
    }
    EXPECT_TRUE(cut);
    EXPECT_NEAR(q, 1.1, 0.03) << "and the arm follows, from 0.3 rad away, and stays";
  }
}

}  // namespace joint_trajectory_law_test
}  // namespace armtune::internal
