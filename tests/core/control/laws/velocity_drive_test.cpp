#include "core/control/laws/velocity_drive.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "core/control/laws/first_gains.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace velocity_drive_test {

using test::random_number;
using test::random_vector;

// Where the file says nothing, the velocity of each joint alone follows q'' = (gain/inertia)(v - q').
TEST(VelocityDrives, AreAsFastAsTheirRateInTheMiddleOfTheRanges) {
  for (RobotModel arm : test::all_arms()) {
    JointVector middle = JointVector::Zero(arm.n());
    for (int i = 0; i < arm.n(); ++i) {
      const JointLimits& limits = arm.joints[static_cast<std::size_t>(i)].limits;
      if (limits.has_position) middle[i] = 0.5 * (limits.lower + limits.upper);
    }
    const JointMatrix mobility = mass_with_rotors(arm, middle).inverse();
    const DriveGains gains = drive_gains(arm);
    for (int i = 0; i < arm.n(); ++i) {
      EXPECT_NEAR(gains.gain[i] * mobility(i, i), kDriveRate, 1e-9 * kDriveRate)
          << arm.name << ", joint " << i;
      EXPECT_DOUBLE_EQ(gains.integral[i] / gains.gain[i], kDriveIntegralRate);
    }
    arm.drive_velocity_gain = JointVector::Constant(arm.n(), 7.0);
    EXPECT_EQ(drive_gains(arm).gain, arm.drive_velocity_gain);
    EXPECT_EQ(drive_gains(arm).integral, kDriveIntegralRate * arm.drive_velocity_gain);
    arm.drive_velocity_integral = JointVector::Zero(arm.n());
    EXPECT_EQ(drive_gains(arm).integral, arm.drive_velocity_integral);
  }
}

// Joint by joint, in a few lines: the command within the velocity limit, the integral within the effort
// limit.
TEST(VelocityDrives, ArePiControllersWithinTheLimits) {
  std::mt19937 generator(951);
  RobotModel arm = test::ur10();
  arm.drive_velocity_gain = random_vector(generator, 6, 50.0).cwiseAbs();
  arm.drive_velocity_integral = random_vector(generator, 6, 4000.0).cwiseAbs();
  VelocityDrives drives(arm);
  const JointVector held = random_vector(generator, 6, 20.0);
  drives.hold(held);
  std::vector<double> integral(held.data(), held.data() + 6);
  bool cut_velocity = false, cut_effort = false;
  for (int k = 0; k < 200; ++k) {
    const JointVector commanded = random_vector(generator, 6, 5.0), qd = random_vector(generator, 6, 2.0);
    JointVector tau;
    drives.torque(commanded, qd, 0.002, tau);
    for (int i = 0; i < 6; ++i) {
      const JointLimits& limits = arm.joints[static_cast<std::size_t>(i)].limits;
      const double wanted = std::clamp(commanded[i], -limits.velocity, limits.velocity);
      double& sum = integral[static_cast<std::size_t>(i)];
      sum += arm.drive_velocity_integral[i] * (wanted - qd[i]) * 0.002;
      cut_effort = cut_effort || std::abs(sum) > limits.effort;
      sum = std::clamp(sum, -limits.effort, limits.effort);
      cut_velocity = cut_velocity || wanted != commanded[i];
      const double expected = arm.drive_velocity_gain[i] * (wanted - qd[i]) + sum;
      EXPECT_NEAR(tau[i], expected, 1e-12 * (1.0 + std::abs(expected))) << k << ", joint " << i;
    }
  }
  EXPECT_TRUE(cut_velocity);
  EXPECT_TRUE(cut_effort);
}

// q' changes by period (M^-1)_ii tau_i, with M and the rotors inverted here as a whole.
TEST(VelocityDrives, StepIsTheShareOfAVelocityErrorThatAPeriodRemoves) {
  std::mt19937 generator(953);
  for (const RobotModel& arm : test::all_arms()) {
    const JointVector q = test::random_configuration(generator, arm);
    JointMatrix M = test::mass_matrix_at(arm.chain, q);
    M.diagonal() += arm.chain.rotor_inertia;
    const JointVector step = drive_step(arm, q, 0.004), gain = drive_gains(arm).gain;
    for (int i = 0; i < arm.n(); ++i)
      EXPECT_NEAR(step[i], 0.004 * gain[i] * M.inverse()(i, i), 1e-9 * step[i]) << arm.name;
  }
}

TEST(VelocityDrives, AllocateNothing) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  std::mt19937 generator(952);
  VelocityDrives drives(test::ur10());
  const JointVector commanded = random_vector(generator, 6, 5.0), qd = random_vector(generator, 6, 2.0);
  JointVector tau;
  const long before = test::allocations();
  drives.torque(commanded, qd, 0.002, tau);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace velocity_drive_test
}  // namespace armtune::internal
