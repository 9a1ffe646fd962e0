// The controller against an independent plant: q'' = (M + D)^-1 (tau - h), torque held over a period.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace closed_loop_test {

/// Largest |S| while a leaveSingularity of one second is under way, theta at the truth.
double largest_S(double period) {
  test::Rig rig;
  rig.period = period;
  rig.gains.adaptation_gain = 0.0;
  rig.gains.joint_trajectory_duration = 1.0;
  const std::unique_ptr<Controller> controller = rig.controller();
  JointState state = rig.goal();
  state.q -= (JointVector(6) << 0.5, 0.4, -0.5, 0.4, -0.5, 0.5).finished();
  double largest = 0.0;
  for (int step = 0; step * period < 0.999; ++step) {
    const ControlOutput& out = controller->update(state, rig.scene(), step * period);
    EXPECT_FALSE(out.saturated);
    largest = std::max(largest, out.S.norm());
    // Substeps of 0.5 ms: the Runge-Kutta error of fourth order is far below the law's own, of first order.
    test::integrate(rig.model->chain, out.torque, period, static_cast<int>(std::lround(period / 0.0005)),
                    state);
  }
  return largest;
}

TEST(ClosedLoop, WithTheTrueThetaSComesFromTheHeldTorqueAloneAndHalvesWithThePeriod) {
  const double coarse = largest_S(0.002);
  const double fine = largest_S(0.001);
  testing::Test::RecordProperty("S", fmt::format("{:.3g} {:.3g}", coarse, fine));
  EXPECT_GT(fine, 1e-6);
  EXPECT_LT(coarse, 0.05);
  EXPECT_GT(fine, 0.4 * coarse);
  EXPECT_LT(fine, 0.6 * coarse);
}

TEST(ClosedLoop, AHoldAtAConstantPoseLetsSAndTheErrorDecay) {
  test::Rig rig;
  rig.gains.task_space_gains_i.setZero();  // its slow mode would outlast the test
  rig.gains.adaptation_gain = 0.0;
  const std::unique_ptr<Controller> controller = rig.controller();
  JointState state = rig.goal();
  state.q[1] += 0.05;
  state.q[4] -= 0.05;
  double early = 0.0;
  double S = 0.0;
  double error = 0.0;
  for (int step = 0; step < 3000; ++step) {
    const double time = step * rig.period;
    const ControlOutput& out = controller->update(state, rig.scene(), time);
    S = out.S.norm();
    error = out.errors.pose.norm();
    if (time < 1.5) early = std::max(early, S);
    test::integrate(rig.model->chain, out.torque, rig.period, 1, state);
  }
  testing::Test::RecordProperty("S", fmt::format("{:.3g} {:.3g}, error {:.3g}", early, S, error));
  EXPECT_GT(early, 1e-4);
  EXPECT_LT(S, 1e-6);
  // The slowest axis has Kp = 3/s: e^(-3 * 5 s) = 3e-7 of some 0.1.
  EXPECT_LT(error, 1e-6);
}

TEST(ClosedLoop, AdaptationFromNothingLearnsToCarryTheArm) {
  test::Rig rig;
  rig.gains.adaptation_gain = 5.0;
  const std::unique_ptr<Controller> controller =
      rig.controller(ParameterVector::Zero(parameter_count(rig.model->chain)));
  JointState state = rig.goal();
  double worst_early = 0.0;
  double worst_late = 0.0;
  for (int step = 0; step < 2000; ++step) {
    const double time = step * rig.period;
    const ControlOutput& out = controller->update(state, rig.scene(), time);
    if (time < 1.0) worst_early = std::max(worst_early, out.S.norm());
    if (time > 3.0) worst_late = std::max(worst_late, out.S.norm());
    test::integrate(rig.model->chain, out.torque, rig.period, 1, state);
  }
  testing::Test::RecordProperty("S", fmt::format("{:.3g} {:.3g}", worst_early, worst_late));
  EXPECT_GT(worst_early, 0.01);
  EXPECT_LT(worst_late, 0.1 * worst_early);
}

}  // namespace closed_loop_test
}  // namespace armtune::internal
