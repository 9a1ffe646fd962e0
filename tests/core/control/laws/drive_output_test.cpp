#include "core/control/laws/drive_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/core/support/allocation_counter.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace drive_output_test {

using test::random_vector;

TEST(DriveOutput, PassesTorquesUnchangedWithoutValues) {
  std::mt19937 generator(961);
  DriveOutput output(test::ur10(), 0.001);
  output.start(JointVector::Zero(6));
  for (int k = 0; k < 5; ++k) {
    const JointVector computed = random_vector(generator, 6, 1e4);
    JointVector tau = computed;
    output.pass(tau);
    EXPECT_EQ(tau, computed);
  }
}

// A ramp of the given slope in N m/s up and down, from the torque at the start, each joint by its own.
TEST(DriveOutput, LimitsHowFastEachTorqueChanges) {
  RobotModel arm = test::ur10();
  arm.drive_torque_rate = JointVector::LinSpaced(6, 1000.0, 6000.0);
  constexpr double kPeriod = 0.002;
  DriveOutput output(arm, kPeriod);
  const JointVector start = JointVector::Constant(6, 5.0);
  output.start(start);
  for (int k = 1; k <= 3; ++k) {
    JointVector tau = JointVector::Constant(6, 1e4);
    output.pass(tau);
    EXPECT_LT((tau - start - k * kPeriod * arm.drive_torque_rate).cwiseAbs().maxCoeff(), 1e-9) << k;
  }
  for (int k = 1; k <= 4; ++k) {
    JointVector tau = JointVector::Constant(6, -1e4);
    output.pass(tau);
    EXPECT_LT((tau - start - (3 - k) * kPeriod * arm.drive_torque_rate).cwiseAbs().maxCoeff(), 1e-9) << k;
  }
  JointVector near = JointVector::Constant(6, 4.0) - 0.002 * arm.drive_torque_rate;
  const JointVector wanted = near;
  output.pass(near);
  EXPECT_EQ(near, wanted) << "a smaller change is not limited";
}

// The arm never gets more than the effort limit, so a drive that asks for more must not need time to return.
TEST(DriveOutput, ReturnsFromTheEffortLimitAtOnce) {
  RobotModel arm = test::ur10();
  for (JointInfo& joint : arm.joints) joint.limits.effort = 20.0;
  arm.drive_torque_rate = JointVector::Constant(6, 1000.0);
  DriveOutput output(arm, 0.001);
  output.start(JointVector::Zero(6));
  JointVector tau;
  for (const double sign : {1.0, -1.0}) {
    for (int k = 0; k < 100; ++k) {
      tau = JointVector::Constant(6, sign * 1e3);
      output.pass(tau);
    }
    EXPECT_TRUE((sign * tau.array() > 20.0).all()) << "which shows that the joints are saturated";
    tau.setZero();
    output.pass(tau);
    EXPECT_LT((tau.array() - sign * 19.0).abs().maxCoeff(), 1e-9);
  }
}

// A delay is a time in seconds, in any period of the drives. What acts in a period is the mean over it of the
// computed torque, which is constant within each period, that long ago.
TEST(DriveOutput, DelaysEachTorqueByItsTime) {
  std::mt19937 generator(962);
  RobotModel arm = test::ur10();
  arm.drive_delay.resize(6);
  arm.drive_delay << 0.0, 0.0004, 0.001, 0.003, 0.0033, 0.1;
  const JointVector start = random_vector(generator, 6, 20.0);
  for (const double period : {0.001, 0.0005, 0.002}) {
    DriveOutput output(arm, period);
    output.start(start);
    std::vector<JointVector> computed;
    for (int k = 0; k < 300; ++k) {
      computed.push_back(random_vector(generator, 6, 50.0));
      JointVector tau = computed.back();
      output.pass(tau);
      constexpr int kParts = 100;  // steps of 5e-6 s to 2e-5 s; every delay is a multiple
      JointVector mean = JointVector::Zero(6);
      for (int i = 0; i < 6; ++i) {
        for (int part = 0; part < kParts; ++part) {
          const double then = (k + (part + 0.5) / kParts) * period - arm.drive_delay[i];
          mean[i] += (then < 0.0 ? start[i] : computed[static_cast<std::size_t>(then / period)][i]) / kParts;
        }
      }
      ASSERT_LT((tau - mean).cwiseAbs().maxCoeff(), 1e-9) << period << ", period " << k;
    }
  }
}

TEST(DriveOutput, AllocatesNothing) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  RobotModel arm = test::ur10();
  arm.drive_torque_rate = JointVector::Constant(6, 1000.0);
  arm.drive_delay = JointVector::Constant(6, 0.0025);
  DriveOutput output(arm, 0.001);
  JointVector tau = JointVector::Constant(6, 7.0);
  const long before = test::allocations();
  output.start(tau);
  for (int k = 0; k < 5; ++k) output.pass(tau);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace drive_output_test
}  // namespace armtune::internal
