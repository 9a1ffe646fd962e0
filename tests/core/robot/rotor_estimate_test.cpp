#include "core/robot/rotor_estimate.hpp"

#include <gtest/gtest.h>

#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace rotor_estimate_test {

struct Published {
  const char* joint;
  double effort;         // N m
  double velocity;       // rad/s
  double rotor_inertia;  // kg m^2, as the joint feels it
};

/// Franka Research 3: limits of the vendor's documentation, inertia as the Drake project quotes the vendor.
/// KUKA youBot: the vendor's limits, motors and gear ratios. Manutec r3, from the Modelica Standard Library's
/// RobotR3, after measurements by DLR: motors of 0.0013 kg m^2 with 1.1616 N m/A, at most 9 A and 315 rad/s,
/// and gear ratios of 105, 210 and 60.
constexpr Published kPublished[] = {
    {"fr3_joint1", 87.0, 2.62, 0.605721456}, {"fr3_joint2", 87.0, 2.62, 0.605721456},
    {"fr3_joint3", 87.0, 2.62, 0.462474144}, {"fr3_joint4", 87.0, 2.62, 0.462474144},
    {"fr3_joint5", 12.0, 5.26, 0.205544064}, {"fr3_joint6", 12.0, 4.18, 0.205544064},
    {"fr3_joint7", 12.0, 5.26, 0.205544064}, {"youbot_joint_1", 9.5, 1.5708, 0.338},
    {"youbot_joint_2", 9.5, 1.5708, 0.338},  {"youbot_joint_3", 6.0, 1.5708, 0.139},
    {"youbot_joint_4", 2.0, 1.5708, 0.047},  {"youbot_joint_5", 1.0, 1.5708, 0.018},
    {"r3_axis_1", 1097.7, 3.0, 14.33},       {"r3_axis_2", 2195.4, 1.5, 57.33},
    {"r3_axis_3", 627.3, 5.25, 4.68},
};

TEST(RotorEstimate, IsWithinAFactorOfThreeOfPublishedFigures) {
  for (const Published& published : kPublished) {
    RobotModel arm = test::random_arm(1, 1, false);
    arm.chain.rotor_inertia[0] = 0.0;
    arm.joints[0].limits.effort = published.effort;
    arm.joints[0].limits.velocity = published.velocity;
    estimate_rotors(arm);
    EXPECT_GT(arm.chain.rotor_inertia[0], published.rotor_inertia / 3.0) << published.joint;
    EXPECT_LT(arm.chain.rotor_inertia[0], published.rotor_inertia * 3.0) << published.joint;
  }
}

// The meaning of kRotorTime: constant acceleration by the whole effort, from rest to the velocity limit.
TEST(RotorEstimate, ARotorAloneReachesTheVelocityLimitInThatTime) {
  RobotModel arm = test::ur10();
  arm.chain.rotor_inertia.setZero();
  estimate_rotors(arm);
  const JointVector acceleration = arm.effort_limits().cwiseQuotient(arm.chain.rotor_inertia);
  for (int i = 0; i < arm.n(); ++i)
    EXPECT_NEAR(kRotorTime * acceleration[i], arm.velocity_limits()[i], 1e-12 * acceleration[i]);
}

TEST(RotorEstimate, WhatIsGivenStays) {
  RobotModel arm = test::ur10();
  arm.chain.rotor_inertia[2] = 0.0;
  estimate_rotors(arm);
  EXPECT_EQ(arm.estimated_rotors, std::vector<std::string>{arm.joints[2].name});
  EXPECT_EQ(arm.chain.rotor_inertia[1], 0.1);
  EXPECT_GT(arm.chain.rotor_inertia[2], 0.0);
}

}  // namespace rotor_estimate_test
}  // namespace armtune::internal
