// What a simulation needs and a URDF does not say.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_missing_data_test {

using test::joint;
using test::link;
using test::refused_at;
using test::robot;
using testing::ElementsAre;
using testing::IsEmpty;

class UrdfMissingData : public test::UrdfFiles {};

TEST_F(UrdfMissingData, EqualPositionLimitsAreMissingOnes) {
  // What urdfdom makes of a limit element without lower and upper.
  const std::string text =
      robot(test::one_joint(test::kInertial, "<axis xyz='0 0 1'/><limit velocity='3' effort='4'/>"));
  const auto lacks_limits = refused_at({.key = "j/lower", .limit = "a lower limit below an upper one"});
  EXPECT_THAT(error_of(text), lacks_limits);
  const MissingData missing = missing_data(write(text));
  EXPECT_THAT(missing.position, ElementsAre("j"));
  EXPECT_THAT(missing.velocity, IsEmpty());
  UrdfOptions options;
  options.limits["j"] = {-1.0, 2.0, {}, {}};
  EXPECT_TRUE(missing_data(write(text), options).empty());
  EXPECT_EQ(read(text, options).joints[0].limits.upper, 2.0);
  options.limits["j"] = {1.0, 1.0, {}, {}};
  EXPECT_THAT(error_of(text, options), lacks_limits);
}

TEST_F(UrdfMissingData, AllThatIsMissingIsToldAtOnce) {
  const std::string nothing = "<axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='0' effort='0'/>";
  const std::string text =
      robot(link("a") + link("b", "") + joint("j", "revolute", "a", "b", nothing) + link("c") +
            joint("k", "revolute", "b", "c",
                  "<axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='2' effort='0'/>") +
            link("d", "") + joint("f", "fixed", "b", "d"));
  const MissingData missing = missing_data(write(text));
  EXPECT_THAT(missing.velocity, ElementsAre("j"));
  EXPECT_THAT(missing.effort, ElementsAre("j", "k"));
  EXPECT_THAT(missing.inertia, ElementsAre("b"));
  UrdfOptions options;
  options.limits["j"] = {{}, {}, 1.0, 2.0};
  options.limits["k"] = {{}, {}, {}, 2.0};
  options.inertia["d"] = {1.0, Vec3::Zero(), Mat3::Identity()};
  EXPECT_TRUE(missing_data(write(text), options).empty()) << "what is fixed to a link is part of its body";
  EXPECT_EQ(read(text, options).n(), 2);
  EXPECT_THAT(missing_data(write(robot(test::one_joint()))).inertia, IsEmpty());
}

TEST_F(UrdfMissingData, LimitsThatAreNotThereAreMissingAndNotWrong) {
  const std::string axis = "<axis xyz='0 0 1'/>";
  const std::string text = robot(
      link("a") + link("b") + joint("none", "revolute", "a", "b", axis) + link("c") +
      joint("slow", "revolute", "b", "c", axis + "<limit lower='-1' upper='1' effort = '4'/>") + link("d") +
      joint("weak", "prismatic", "c", "d", axis + "<limit\n velocity='3' lower='-1' upper='1'></limit>") +
      link("e") + joint("f", "fixed", "d", "e") + link("g") +
      joint("whole", "continuous", "e", "g", axis + test::kLimit));
  const MissingData missing = missing_data(write(text));
  EXPECT_THAT(missing.position, ElementsAre("none"));
  EXPECT_THAT(missing.velocity, ElementsAre("none", "slow"));
  EXPECT_THAT(missing.effort, ElementsAre("none", "weak"));
  UrdfOptions options;
  options.limits["none"] = {-1.0, 2.0, 3.0, 4.0};
  options.limits["slow"] = {{}, {}, 5.0, {}};
  options.limits["weak"] = {{}, {}, {}, 6.0};
  const RobotModel arm = read(text, options);
  EXPECT_EQ(arm.joints[1].limits.velocity, 5.0);
  EXPECT_EQ(arm.joints[1].limits.effort, 4.0);
  EXPECT_EQ(arm.joints[2].limits.velocity, 3.0);
  EXPECT_EQ(arm.joints[2].limits.effort, 6.0);
}

}  // namespace urdf_missing_data_test
}  // namespace armtune::internal
