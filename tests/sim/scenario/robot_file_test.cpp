#include "sim/scenario/robot_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/kinematics.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "core/robot/urdf_reader.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/robot_writer.hpp"
#include "sim/scenario/sidecar_text.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace robot_file_test {

using test::refused_at;
using testing::HasSubstr;

const std::string kUrdf = test::source_dir() + "/sim/robots/ur10.urdf";

std::string robot_text(const std::string& rest) {
  return "urdf: " + kUrdf + "\n" + rest;
}

// Sums of the masses in xarm_ros2 0417b0f9, xarm_description/config/link_inertial/xarm7_type7_HT_BR2.yaml and
// xarm6_type6_HT_BR2.yaml. An older description by the same vendor has 2.8 kg for the xArm 7.
TEST(RobotFile, TheBundledXArmsHaveTheMassesThatTheirMakerMaintains) {
  const auto moving_mass = [](const char* name) {
    const auto robot = load_robot(name);
    double mass = 0.0;
    for (int i = 0; i < robot->n(); ++i) mass += robot->chain.link[static_cast<std::size_t>(i)].mass;
    return mass;
  };
  EXPECT_NEAR(moving_mass("xarm7"), 10.4315, 1e-9);
  EXPECT_NEAR(moving_mass("xarm6"), 9.35164, 1e-9);
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

TEST(RobotFile, EstimatesTheRotorsThatNoFileGives) {
  const test::TemporaryFolder folder;
  const auto arm = load_robot(folder.write("arm.yaml", robot_text("rotor_inertia: estimated\n")));
  EXPECT_EQ(arm->estimated_rotors, joint_names(*arm));
  for (int i = 0; i < arm->n(); ++i) {
    const JointLimits& limits = arm->joints[static_cast<std::size_t>(i)].limits;
    EXPECT_EQ(arm->chain.rotor_inertia[i], kRotorTime * limits.effort / limits.velocity);
  }
  const auto own = load_robot(
      folder.write("own.yaml", robot_text("rotor_inertia: {estimated: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]}\n")));
  EXPECT_EQ(own->estimated_rotors, joint_names(*own));
  EXPECT_EQ(own->chain.rotor_inertia[4], 0.5);
  EXPECT_THAT(load_robot(folder.write("given.yaml", robot_text("rotor_inertia: [1, 2, 3, 4, 5, 6]\n")))
                  ->estimated_rotors,
              testing::IsEmpty());
  const std::string two = folder.write("two.yaml", robot_text("rotor_inertia: {estimated: [0.1, 0.2]}\n"));
  EXPECT_THAT(
      [&] { load_robot(two); },
      refused_at(
          {.file = two, .line = 2, .key = "rotor_inertia/estimated", .value = "2", .limit = "6 numbers"}));
  const std::string guessed = folder.write("guessed.yaml", robot_text("rotor_inertia: guessed\n"));
  EXPECT_THAT([&] { load_robot(guessed); },
              refused_at({.file = guessed, .line = 2, .key = "rotor_inertia", .value = "guessed"}));
}

TEST(RobotFile, LinksAreAsThickAsTheirShapesOrAsItSays) {
  const test::TemporaryFolder folder;
  const auto bundled = load_robot("ur10");
  EXPECT_EQ(bundled->link_radii[1], 0.075) << "the upper arm's cylinders";
  EXPECT_EQ(bundled->chain.link_radius.size(), 0);
  const auto said =
      load_robot(folder.write("arm.yaml", robot_text("link_radius: [0.1, 0.2, 0, 0.1, 0.1, 0.1]\n")));
  EXPECT_EQ(said->link_radii[1], 0.2);
  EXPECT_EQ(said->link_radii[2], 0.0);
  const std::string thin =
      folder.write("thin.yaml", robot_text("link_radius: [0.1, 0.2, -0.1, 0.1, 0.1, 0.1]\n"));
  const InputError error = test::input_error([&] { load_robot(thin); });
  EXPECT_THAT(
      error,
      refused_at({.file = thin, .line = 2, .key = "link_radius", .value = "-0.1", .limit = "0 to 10 m"}));
  EXPECT_THAT(error.what(), HasSubstr("forearm_link"));
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

TEST(RobotFile, HoldsJointsAndEndsWhereItIsTold) {
  const test::TemporaryFolder folder;
  const auto arm = load_robot(folder.write(
      "arm.yaml",
      robot_text("base_link: shoulder_link\ntip_link: wrist_2_link\nhold: {wrist_3_joint: 0.5}\n")));
  EXPECT_THAT(joint_names(*arm),
              testing::ElementsAre("shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint"));
  EXPECT_EQ(arm->base_link, "shoulder_link");
}

TEST(RobotFile, LimitsAndInertiaStandForThoseOfTheUrdf) {
  const test::TemporaryFolder folder;
  const auto arm = load_robot(folder.write(
      "arm.yaml",
      robot_text(
          "tip_link: wrist_3_link\nlimits: {elbow_joint: {velocity: 1.5, lower: -1, upper: 2, acceleration: 9}}\n"
          "inertia: {wrist_3_link: {mass: 2, center: [0, 0, 0.1], moments: [3, 0.4, 0.5, 4, 0.6, 5]}}\n")));
  const auto bare = load_robot(kUrdf);
  const JointLimits& given = arm->joints[2].limits;
  EXPECT_EQ(given.velocity, 1.5);
  EXPECT_EQ(given.effort, bare->joints[2].limits.effort);
  EXPECT_EQ(given.acceleration, 9.0);
  folder.write("again.urdf", urdf_text(*arm));
  const auto again = load_robot(folder.write("again.yaml", robot_yaml(*arm, "again.urdf", "")));
  EXPECT_EQ(again->acceleration_limits(), arm->acceleration_limits()) << "no URDF has them";
  EXPECT_EQ(given.lower, -1.0);
  EXPECT_EQ(given.upper, 2.0);
  // What is fixed to the wrist in the URDF weighs nothing; the body's z axis is the link's y axis.
  const LinkInertia& wrist = arm->chain.link[5];
  EXPECT_EQ(wrist.mass, 2.0);
  EXPECT_NEAR(wrist.first_moment.norm(), 0.2, 1e-12);
  EXPECT_NEAR(wrist.first_moment.z(), 0.0, 1e-12);
  EXPECT_NEAR(wrist.inertia(2, 2), 4.0 + 2.0 * 0.1 * 0.1, 1e-12) << "about the joint: iyy and Steiner's term";
  EXPECT_NEAR(wrist.inertia.trace(), 3.0 + 4.0 + 5.0 + 2.0 * 2.0 * 0.1 * 0.1, 1e-12);
}

TEST(RobotFile, WhatIsMissingIsAYamlThatLoadsOnceItIsFilledIn) {
  const test::TemporaryFolder folder;
  const std::string urdf =
      folder.write("bare.urdf",
                   "<robot name='r'><link name='a'/><link name='b'/><joint name='j: k' "
                   "type='revolute'><parent link='a'/>"
                   "<child link='b'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='0' effort='0'/>"
                   "</joint></robot>");
  const RobotFile file = read_robot_file(urdf);
  const std::string text = sidecar_yaml(file.urdf, missing_data(file.urdf, file.options), {});
  const std::string path = folder.write("arm.yaml", text);
  EXPECT_THAT([&] { load_robot(path); },
              refused_at({.file = path, .line = 4, .key = "limits/j: k/velocity", .limit = "a number"}));
  std::string filled = text;
  const auto fill = [&](const std::string& key, const std::string& value) {
    const auto at = filled.find(key + ":  #");
    ASSERT_NE(at, std::string::npos) << key;
    filled.insert(at + key.size() + 1, " " + value);
  };
  fill("velocity", "2");
  fill("effort", "3");
  fill("mass", "1.5");
  fill("moments", "[1, 0, 0, 1, 0, 1]");
  const auto arm = load_robot(folder.write("arm.yaml", filled));
  EXPECT_EQ(arm->joints[0].limits.velocity, 2.0);
  EXPECT_EQ(arm->joints[0].limits.effort, 3.0);
  EXPECT_EQ(arm->chain.link[0].mass, 1.5);
  EXPECT_TRUE(missing_data(file.urdf, read_robot_file(path).options).empty());
}

TEST(RobotFile, MissingPositionLimitsAreAskedForToo) {
  const test::TemporaryFolder folder;
  const std::string urdf = folder.write(
      "bare.urdf",
      "<robot name='r'><link name='a'/><link name='b'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
      "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='j' type='revolute'><parent link='a'/>"
      "<child link='b'/><axis xyz='0 0 1'/><limit velocity='2' effort='3'/></joint></robot>");
  std::string text = sidecar_yaml(urdf, missing_data(urdf), {});
  for (const auto& [key, value] : {std::pair("lower:", " -0.5"), std::pair("upper:", " 0.75")}) {
    const auto at = text.find(key);
    ASSERT_NE(at, std::string::npos) << text;
    text.insert(at + std::string(key).size(), value);
  }
  const auto arm = load_robot(folder.write("arm.yaml", text));
  EXPECT_EQ(arm->joints[0].limits.lower, -0.5);
  EXPECT_EQ(arm->joints[0].limits.upper, 0.75);
}

TEST(RobotFile, WhatDoesNotFitIsRefusedInOneLine) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const std::string& rest) {
    const std::string path = folder.write("arm.yaml", robot_text(rest));
    return test::input_error([&] { load_robot(path); });
  };
  const std::string path = folder / "arm.yaml";
  EXPECT_THAT(
      refused("rotor_inertia: [0.1, 0.1]\n"),
      refused_at({.file = path, .line = 2, .key = "rotor_inertia", .value = "2", .limit = "6 numbers"}));
  EXPECT_THAT(
      refused("rotor_inertia: {elbow: 1}\n"),
      refused_at({.file = path, .line = 2, .key = "rotor_inertia", .limit = "the key 'shoulder_pan_joint'"}));
  EXPECT_THAT(refused("rotor_inertia: [0.1, 0.1, -0.1, 0.1, 0.1, 0.1]\n"),
              refused_at({.file = kUrdf, .key = "elbow_joint/rotor_inertia", .value = "-0.1"}));
  const InputError misspelt = refused("rotor_inertias: [1]\n");
  EXPECT_THAT(misspelt,
              refused_at({.file = path, .line = 2, .key = "rotor_inertias", .value = "rotor_inertias"}));
  EXPECT_EQ(test::suggested_by(misspelt), "rotor_inertia");
  EXPECT_THAT(refused("tool: {xyz: [0, 0]}\n"),
              refused_at({.file = path, .line = 2, .key = "tool/xyz", .value = "2", .limit = "3 numbers"}));
  EXPECT_THAT(refused("tip_link: tool1\n"), refused_at({.file = kUrdf, .key = "tip_link", .value = "tool1"}));
  EXPECT_THAT(refused("hold: {elbow: 0}\n"),
              refused_at({.file = kUrdf, .key = "hold/elbow", .value = "elbow"}));
  EXPECT_THAT(refused("hold: {elbow_joint: bent}\n"),
              refused_at({.file = path, .line = 2, .key = "hold/elbow_joint", .value = "bent"}));
  EXPECT_THAT(refused("limits: {elbow_joint: {speed: 1}}\n"),
              refused_at({.file = path, .line = 2, .key = "limits/elbow_joint/speed", .value = "speed"}));
  EXPECT_THAT(refused("inertia: {forearm_link: {mass: -1, moments: [1, 0, 0, 1, 0, 1]}}\n"),
              refused_at({.file = path,
                          .line = 2,
                          .key = "inertia/forearm_link/mass",
                          .value = "-1",
                          .limit = "not negative"}));
  folder.write("arm.yaml", "tip_link: tool0\n");
  EXPECT_THAT([&] { load_robot(path); },
              refused_at({.file = path, .line = 1, .key = "", .limit = "the key 'urdf'"}));
  const std::string none = folder / "none.urdf";
  EXPECT_THAT([&] { load_robot(none); }, refused_at({.file = none}));
}

}  // namespace robot_file_test
}  // namespace armtune::internal
