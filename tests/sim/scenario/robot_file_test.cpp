#include "sim/scenario/robot_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/kinematics.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kUrdf = ARMTUNE_SOURCE_DIR "/sim/robots/ur10.urdf";

std::string robot_text(const std::string& rest) {
  return "urdf: " + kUrdf + "\n" + rest;
}

TEST(RobotFile, TheBundledUr10HasItsToolAndItsRotors) {
  const auto ur10 = load_robot("ur10");
  EXPECT_EQ(ur10->n(), 6);
  EXPECT_TRUE(ur10->chain.rotor_inertia.isApproxToConstant(0.1));
  EXPECT_TRUE(ur10->chain.viscous_friction.isZero(0.0));
  // The tool reaches 0.14 m beyond the flange, along the tool's own z.
  const test::TemporaryFolder folder;
  const auto bare = load_robot(folder.write("arm.yaml", robot_text("tip_link: tool0\n")));
  Poses with, without;
  const JointVector q = JointVector::LinSpaced(6, -1.0, 1.0);
  forward_kinematics(ur10->chain, q, with);
  forward_kinematics(bare->chain, q, without);
  EXPECT_LT((with.p_0T - without.p_0T - 0.14 * with.R_0T.col(2)).norm(), 1e-12);
}

TEST(RobotFile, TakesAUrdfAlone) {
  const auto arm = load_robot(kUrdf);
  EXPECT_EQ(arm->n(), 6);
  EXPECT_TRUE(arm->chain.rotor_inertia.isZero(0.0));
}

TEST(RobotFile, TakesActuatorDataAsAListOrByJointName) {
  const test::TemporaryFolder folder;
  const auto arm = load_robot(
      folder.write("arm.yaml", robot_text("viscous_friction: [1, 2, 3, 4, 5, 6]\n"
                                          "coulomb_friction: {wrist_3_joint: 6, shoulder_pan_joint: 1, "
                                          "shoulder_lift_joint: 2, elbow_joint: 3, wrist_1_joint: 4, "
                                          "wrist_2_joint: 5}\n")));
  const JointVector expected = JointVector::LinSpaced(6, 1.0, 6.0);
  EXPECT_EQ(arm->chain.viscous_friction, expected);
  EXPECT_EQ(arm->chain.coulomb_friction, expected);
}

TEST(RobotFile, ATurnedToolIsTurned) {
  const test::TemporaryFolder folder;
  const auto arm = load_robot(folder.write(
      "arm.yaml", robot_text("tip_link: tool0\ntool: {xyz: [0, 0, 0.1], rpy: [0.2, -0.4, 0.9]}\n")));
  const auto bare = load_robot(folder.write("bare.yaml", robot_text("tip_link: tool0\n")));
  const Mat3 turn = bare->chain.R_BT.transpose() * arm->chain.R_BT;
  const Mat3 expected = (Eigen::AngleAxisd(0.9, Vec3::UnitZ()) * Eigen::AngleAxisd(-0.4, Vec3::UnitY()) *
                         Eigen::AngleAxisd(0.2, Vec3::UnitX()))
                            .toRotationMatrix();
  EXPECT_LT((turn - expected).norm(), 1e-12);
}

TEST(RobotFile, WhatDoesNotFitIsRefusedInOneLine) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const std::string& rest) {
    const std::string path = folder.write("arm.yaml", robot_text(rest));
    return test::refusal([&] { load_robot(path); });
  };
  const std::string path = folder / "arm.yaml";
  EXPECT_THAT(refused("rotor_inertia: [0.1, 0.1]\n"), AllOf(HasSubstr(path + ":2"), HasSubstr("expected 6")));
  EXPECT_THAT(refused("rotor_inertia: {elbow: 1}\n"),
              AllOf(HasSubstr(path + ":2"), HasSubstr("missing key")));
  EXPECT_THAT(refused("rotor_inertia: [0.1, 0.1, -0.1, 0.1, 0.1, 0.1]\n"), HasSubstr("elbow_joint"));
  EXPECT_THAT(refused("rotor_inertias: [1]\n"), HasSubstr("did you mean 'rotor_inertia'"));
  EXPECT_THAT(refused("tool: {xyz: [0, 0]}\n"), AllOf(HasSubstr(path + ":2"), HasSubstr("3")));
  EXPECT_THAT(refused("tip_link: tool1\n"), HasSubstr("tool1"));
  folder.write("arm.yaml", "tip_link: tool0\n");
  EXPECT_THAT(test::refusal([&] { load_robot(path); }), HasSubstr("missing key 'urdf'"));
  EXPECT_THAT(test::refusal([&] { load_robot(folder / "none.urdf"); }), HasSubstr("none.urdf"));
}

}  // namespace
}  // namespace armtune
