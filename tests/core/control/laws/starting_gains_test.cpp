#include "core/control/laws/starting_gains.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "core/control/gain_fields.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace starting_gains_test {

TEST(StartingGains, DampEveryArmAtOneRate) {
  std::mt19937 generator(43);
  for (const RobotModel& arm : test::all_arms()) {
    const JointVector q = test::random_configuration(generator, arm);
    const Gains gains = starting_gains(arm, q, q, 0.1);
    EXPECT_NO_THROW(validate(gains, joint_names(arm), arm.name)) << arm.name;
    // S' = -M^-1 Kd S: rates that are real, positive, and 25 /s in the mean, as each joint alone has it.
    JointMatrix M = test::mass_matrix_at(arm.chain, q);
    M.diagonal() += arm.chain.rotor_inertia;
    const JointMatrix rates = M.inverse() * gains.task_space_gains_d.asDiagonal();
    EXPECT_NEAR(rates.trace(), 25.0 * arm.n(), 1e-6) << arm.name;
    const auto eigenvalues = Eigen::EigenSolver<Eigen::MatrixXd>(rates).eigenvalues();
    EXPECT_GT(eigenvalues.real().minCoeff(), 0.0) << arm.name;
    EXPECT_LT(eigenvalues.real().maxCoeff(), 25.0 * arm.n()) << arm.name;
  }
}

TEST(StartingGains, TheWayToTheGoalKeepsToTheVelocityLimits) {
  const RobotModel arm = test::ur10();
  const JointVector start = JointVector::Zero(6);
  JointVector goal = start;
  goal[1] = -6.0;
  const Gains gains = starting_gains(arm, start, goal, 0.1);
  // The quintic's peak, at half of its duration.
  const double peak =
      joint_trajectory(start, goal, gains.joint_trajectory_duration, 0.5 * gains.joint_trajectory_duration)
          .velocity.cwiseAbs()
          .maxCoeff();
  EXPECT_LE(peak, 0.4 * arm.joints[1].limits.velocity * (1.0 + 1e-12));
  EXPECT_NEAR(gains.joint_space_goal[1], -6.0 * 180.0 / M_PI, 1e-9);
  EXPECT_EQ(in_si(arm, in_degrees(arm, goal)), goal);
}

}  // namespace starting_gains_test
}  // namespace armtune::internal
