#include "sim/scenario/plausibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/dynamics.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LinkInertia body(double mass, double radius_of_gyration) {
  const Vec3 center(0.0, 0.0, 0.1);
  const LinkInertia about_center{mass, Vec3::Zero(),
                                 mass * radius_of_gyration * radius_of_gyration * Mat3::Identity()};
  return in_frame(about_center, Mat3::Identity(), center);
}

TEST(Plausibility, NothingIsDoubtfulAboutTheBundledArms) {
  for (const std::string& name : bundled_names("robots"))
    EXPECT_THAT(doubts(*load_robot(name)), IsEmpty()) << name;
}

TEST(Plausibility, LinksThatAreTooLightAreNamed) {
  RobotModel arm = test::ur10();
  arm.chain.link[1] = body(0.01, 0.1);
  EXPECT_THAT(doubts(arm), ElementsAre(AllOf(HasSubstr("upper_arm_link (0.01 kg)"), HasSubstr("masses"))));
}

TEST(Plausibility, InertiaThatNoBodyOfTheMassHasIsNamed) {
  RobotModel arm = test::ur10();
  arm.chain.link[2] = body(4.0, 1.2);
  arm.chain.link[3] = body(2.0, 1e-3);
  EXPECT_THAT(doubts(arm), ElementsAre(AllOf(HasSubstr("forearm_link (1.2 m)"), HasSubstr("half")),
                                       AllOf(HasSubstr("wrist_1_link (0.001 m)"), HasSubstr("2 mm"))));
}

TEST(Plausibility, LimitsThatLookLikeDegreesAreNamed) {
  RobotModel arm = test::ur10();
  arm.joints[0].limits.lower = -160.0;
  arm.joints[0].limits.upper = 160.0;
  arm.joints[5].limits.velocity = 180.0;
  EXPECT_THAT(doubts(arm),
              ElementsAre(AllOf(HasSubstr("shoulder_pan_joint (160)"), HasSubstr("degrees")),
                          AllOf(HasSubstr("wrist_3_joint (180)"), HasSubstr("degrees per second"))));
}

TEST(Plausibility, AnEffortLimitThatCannotHoldTheArmIsNamedWithWhatItNeeds) {
  RobotModel arm = test::ur10();
  arm.joints[1].limits.effort = 10.0;
  const std::vector<std::string> found = doubts(arm);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0], AllOf(HasSubstr("shoulder_lift_joint: it needs"), HasSubstr("limit is 10")));
  // Stretched out: the whole arm's weight, less than its mass at its whole reach.
  double needs = 0.0;
  ASSERT_EQ(std::sscanf(found[0].c_str(), "shoulder_lift_joint: it needs %lf", &needs), 1);
  EXPECT_GT(needs, 50.0);
  EXPECT_LT(needs, 30.0 * 9.81 * reach(arm));
}

TEST(Plausibility, JointsThatSlideAreShownInMetres) {
  RobotModel arm = test::random_arm(6, 3, true);
  for (JointInfo& joint : arm.joints) joint.limits.effort = 1.0;
  EXPECT_THAT(doubts(arm), Contains(HasSubstr("] deg and m, and its effort limit is 1")));
  arm = test::random_arm(6, 3, false);
  for (JointInfo& joint : arm.joints) joint.limits.effort = 1.0;
  EXPECT_THAT(doubts(arm), Contains(HasSubstr("] deg, and its effort limit is 1")));
}

TEST(Plausibility, AFingerAsTheLastJointIsNamed) {
  RobotModel arm = test::ur10();
  arm.chain.motion[5] = JointMotion::kPrismatic;
  arm.joints[5].limits.lower = 0.01;
  arm.joints[5].limits.upper = 0.05;
  EXPECT_THAT(doubts(arm),
              ElementsAre(AllOf(HasSubstr("wrist_3_joint"), HasSubstr("hold: {wrist_3_joint: 0.01}"))));
}

// Without the comment marks, what is proposed is a robot YAML that settles the doubt.
TEST(Plausibility, WhatIsProposedSettlesTheDoubt) {
  const test::TemporaryFolder folder;
  RobotModel arm = test::ur10();
  arm.joints[0].limits.lower = -160.0;
  arm.joints[0].limits.upper = 160.0;
  arm.joints[0].limits.velocity = 180.0;
  folder.write("arm.urdf", urdf_text(arm));
  const std::vector<Doubt> found = doubts_with_proposals(arm);
  ASSERT_EQ(found.size(), 2U);
  std::string text = proposals_yaml("arm.urdf", found);
  EXPECT_EQ(doubts(*load_robot(folder.write("as_written.yaml", text))).size(), 2U)
      << "comments change nothing";
  std::string settled = "urdf: arm.urdf\nlimits:\n  shoulder_pan_joint:\n";
  for (const Doubt& doubt : found) {
    for (const ProposedValue& p : doubt.proposed) {
      EXPECT_THAT(text, HasSubstr("#     " + p.field + ": " + p.value));
      settled += "    " + p.field + ": " + p.value + "\n";
    }
  }
  const auto robot = load_robot(folder.write("settled.yaml", settled));
  EXPECT_THAT(doubts(*robot), IsEmpty());
  EXPECT_NEAR(robot->joints[0].limits.upper, 2.793, 1e-3);
  EXPECT_NEAR(robot->joints[0].limits.velocity, 3.142, 1e-3);
}

TEST(Plausibility, WhatOnlyTheMakerKnowsIsAskedFor) {
  RobotModel arm = test::ur10();
  arm.chain.link[1] = body(0.01, 0.1);
  const std::string text = proposals_yaml("arm.urdf", doubts_with_proposals(arm));
  EXPECT_THAT(text, HasSubstr("# inertia:\n#   \"upper_arm_link\":\n#     mass: \n"));
}

}  // namespace
}  // namespace armtune::internal
