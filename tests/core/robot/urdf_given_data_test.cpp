// Limits and inertias that a user gives in place of those of the URDF.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/robot/urdf_trees.hpp"

namespace armtune::internal {
namespace urdf_given_data_test {

using test::joint;
using test::link;
using test::refused_at;
using test::robot;
using test::with_held;
using test::with_tip;

class UrdfGivenData : public test::UrdfTrees {};

TEST_F(UrdfGivenData, GivenLimitsAndInertiaStandForThoseOfTheFile) {
  const std::string axis = "<axis xyz='0 0 1'/>";
  const std::string whole = robot(test::one_joint());
  const std::string bare =
      robot(link("a") + link("b", "") +
            joint("j", "revolute", "a", "b", axis + "<limit lower='-1' upper='2' velocity='0' effort='0'/>"));
  UrdfOptions options;
  options.limits["j"] = {{}, {}, 3.0, 4.0};
  options.inertia["b"] = {1.0, Vec3::Zero(), Mat3::Identity()};
  const RobotModel given = read(bare, options);
  const RobotModel said = read(whole);
  expect_same_arm(given, said);
  EXPECT_EQ(given.joints[0].limits.velocity, said.joints[0].limits.velocity);
  EXPECT_EQ(given.joints[0].limits.effort, said.joints[0].limits.effort);
  EXPECT_TRUE(std::isinf(given.joints[0].limits.acceleration)) << "no URDF has one";
  options.limits["j"] = {-0.5, 0.5, 3.0, 4.0, 7.5};
  EXPECT_EQ(read(whole, options).joints[0].limits.acceleration, 7.5);
  EXPECT_EQ(read(whole, options).acceleration_limits()[0], 7.5);
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    UrdfOptions other;
    other.limits["j"].acceleration = wrong;
    EXPECT_THAT(error_of(whole, other),
                refused_at({.key = "j/acceleration", .value = fmt::format("{}", wrong), .limit = "above 0"}));
  }
  EXPECT_EQ(read(whole, options).joints[0].limits.lower, -0.5);
  EXPECT_EQ(read(whole, options).joints[0].limits.upper, 0.5);
}

TEST_F(UrdfGivenData, GivenInertiaIsAboutTheCentreOfMassAsThatOfTheFileIs) {
  const std::string lying = "<axis xyz='0 1 0'/>" + test::kLimit;  // gravity pulls at the centre of mass
  UrdfOptions options;
  options.inertia["b"].mass = 2.0;
  options.inertia["b"].center = {0.1, -0.2, 0.3};
  options.inertia["b"].about_center << 3.0, 0.4, 0.5, 0.4, 4.0, 0.6, 0.5, 0.6, 5.0;
  expect_same_arm(
      read(robot(test::one_joint("", lying)), options),
      read(robot(test::one_joint(
          "<inertial><origin xyz='0.1 -0.2 0.3'/><mass value='2'/><inertia ixx='3' iyy='4' izz='5' "
          "ixy='0.4' ixz='0.5' iyz='0.6'/></inertial>",
          lying))));
}

TEST_F(UrdfGivenData, AContinuousJointTakesPositionLimitsThatAreGiven) {
  const std::string text =
      robot(link("a") + link("b") +
            joint("j", "continuous", "a", "b", "<axis xyz='0 0 1'/><limit velocity='3' effort='4'/>"));
  EXPECT_FALSE(read(text).joints[0].limits.has_position);
  UrdfOptions options;
  options.limits["j"] = {-0.5, 0.7, {}, {}};
  const JointLimits limits = read(text, options).joints[0].limits;
  EXPECT_TRUE(limits.has_position);
  EXPECT_EQ(limits.lower, -0.5);
  EXPECT_EQ(limits.upper, 0.7);
  EXPECT_EQ(limits.velocity, 3.0);
  options.limits["j"] = {-0.5, {}, {}, {}};
  EXPECT_THAT(error_of(text, options),
              refused_at({.key = "j/lower", .limit = "a lower limit below an upper one"}));
}

TEST_F(UrdfGivenData, LimitsAndInertiaOfWhatDoesNotMoveAreRefused) {
  const std::string text = robot(link("base") + chain("arm", "base", 3) + link("tip") +
                                 joint("fixed", "fixed", "arm3", "tip") + chain("other", "base", 2));
  for (const char* name : {"fixed", "other1_joint"}) {
    UrdfOptions options = with_tip("arm3");
    options.limits[name] = {{}, {}, 1.0, {}};
    EXPECT_THAT(error_of(text, options), refused_at({.key = fmt::format("limits/{}", name),
                                                     .value = name,
                                                     .limit = "a moving joint of the arm"}));
  }
  for (const char* name : {"base", "other1"}) {
    UrdfOptions options = with_tip("arm3");
    options.inertia[name] = {1.0, Vec3::Zero(), Mat3::Identity()};
    EXPECT_THAT(error_of(text, options), refused_at({.key = fmt::format("inertia/{}", name),
                                                     .value = name,
                                                     .limit = "a link that the arm moves"}));
  }
}

TEST_F(UrdfGivenData, AHeldJointKeepsToTheLimitsThatAreGiven) {
  const std::string text = robot(link("base") + chain("arm", "base", 3));  // limits -1 .. 2
  UrdfOptions options = with_held("arm3_joint", 2.5);
  options.limits["arm3_joint"] = {{}, 3.0, {}, {}};
  EXPECT_EQ(read(text, options).n(), 2);
  options.limits["arm3_joint"] = {0.0, 1.0, {}, {}};
  EXPECT_THAT(error_of(text, options),
              refused_at({.key = "hold/arm3_joint", .value = "2.5", .limit = "0 to 1"}));
  options.limits["arm3_joint"] = {{}, 3.0, {}, 5.0};
  EXPECT_THAT(error_of(text, options),
              refused_at({.key = "limits/arm3_joint", .limit = "lower and upper only"}));
}

}  // namespace urdf_given_data_test
}  // namespace armtune::internal
