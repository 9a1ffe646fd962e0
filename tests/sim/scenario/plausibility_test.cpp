#include "sim/scenario/plausibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/dynamics.hpp"
#include "core/robot/rotor_estimate.hpp"
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

/// A motor's own inertia where the gear ratio was left out, and one whose ratio was taken twice.
TEST(Plausibility, RotorsThatDoNotGoWithTheirLimitsAreNamed) {
  RobotModel arm = test::ur10();
  arm.estimated_rotors.clear();
  for (Eigen::Index i = 0; i < arm.n(); ++i) {
    const JointLimits& limits = arm.joints[static_cast<std::size_t>(i)].limits;
    arm.chain.rotor_inertia[i] = kRotorTime * limits.effort / limits.velocity;
  }
  EXPECT_THAT(doubts(arm), IsEmpty());
  const double right = arm.chain.rotor_inertia[2];
  for (const double factor : {1.0 / 90.0, 90.0}) {
    arm.chain.rotor_inertia[2] = factor * right;
    EXPECT_THAT(doubts(arm), IsEmpty()) << factor;
  }
  for (const double factor : {1e-4, 1.0 / 110.0, 110.0}) {
    arm.chain.rotor_inertia[2] = factor * right;
    EXPECT_THAT(doubts(arm), ElementsAre(AllOf(HasSubstr("elbow_joint ("), HasSubstr("gear ratio"))))
        << factor;
  }
  arm.estimated_rotors = {"elbow_joint"};
  EXPECT_THAT(doubts(arm), IsEmpty()) << "the verdict says that it is an estimate";
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
  arm.joints[2].limits.effort = 7.0;
  const std::vector<std::string> found = doubts(arm);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0], AllOf(HasSubstr("shoulder_lift_joint: it needs"), HasSubstr("limit is 10 N m")));
  EXPECT_THAT(found[1], AllOf(HasSubstr("elbow_joint: it needs"), HasSubstr("limit is 7 N m")));
  // Stretched out it takes the most: the moment of all weights beyond the joint about it.
  JointVector stretched = JointVector::Zero(6);
  Poses poses;
  forward_kinematics(arm.chain, stretched, poses);
  double moment = 0.0;
  for (std::size_t k = 1; k < 6; ++k) {
    const LinkInertia& link = arm.chain.link[k];
    const Vec3 weighted = link.mass * (poses.p_0B[k] - poses.p_0B[1]) + poses.R_0B[k] * link.first_moment;
    moment += 9.81 * weighted.head<2>().norm();
  }
  double needs = 0.0;
  ASSERT_EQ(std::sscanf(found[0].c_str(), "shoulder_lift_joint: it needs %lf", &needs), 1);
  EXPECT_NEAR(needs, moment, 0.03 * moment);  // the wrists may stand a little farther out
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

TEST(Plausibility, AClawThatTurnsIsNamedAndAWristIsNot) {
  RobotModel arm = test::ur10();
  arm.joints[5].limits.lower = -0.2;
  arm.joints[5].limits.upper = 0.85;
  EXPECT_THAT(doubts(arm),
              ElementsAre(AllOf(HasSubstr("wrist_3_joint: the last joint turns by only 1.05 rad"),
                                HasSubstr("hold: {wrist_3_joint: 0}"))));
  arm.joints[5].limits.lower = -1.6;
  arm.joints[5].limits.upper = 1.6;
  EXPECT_THAT(doubts(arm), IsEmpty());
  arm.joints[5].limits.has_position = false;  // a continuous joint has no range
  arm.joints[5].limits.lower = arm.joints[5].limits.upper = 0.0;
  EXPECT_THAT(doubts(arm), IsEmpty());
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
  // Sentences have a blank behind their mark, which stays.
  std::string settled;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool mark = text[at] == '#' && (at == 0 || text[at - 1] == '\n');
    const bool of_value = mark && (text[at + 1] != ' ' || text[at + 2] == ' ');
    if (!of_value) settled += text[at];
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
  EXPECT_THAT(text, HasSubstr("#inertia:\n#  \"upper_arm_link\":\n#    mass: \n"));
}

}  // namespace
}  // namespace armtune::internal
