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
namespace plausibility_test {

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

/// The doubts about the arm if its rotor inertia fits its limits.
std::vector<std::string> other_doubts(RobotModel arm) {
  test::fit_rotors(arm);
  return doubts(arm);
}

TEST(Plausibility, NothingAboutTheBundledArmsIsDoubtful) {
  for (const std::string& name : bundled_names("robots"))
    EXPECT_THAT(doubts(*load_robot(name)), IsEmpty()) << name;
}

TEST(Plausibility, LinksThatAreTooLightAreNamed) {
  RobotModel arm = test::ur10();
  arm.chain.link[1] = body(0.01, 0.1);
  EXPECT_THAT(other_doubts(arm),
              ElementsAre(AllOf(HasSubstr("upper_arm_link (0.01 kg)"), HasSubstr("masses"))));
}

/// The arm with masses and inertias of a few grams, none of them the same.
RobotModel of_placeholders(RobotModel arm) {
  for (int i = 0; i < arm.n(); ++i)
    arm.chain.link[static_cast<std::size_t>(i)] = body(0.009 + 0.001 * i, 0.1);
  return arm;
}

// No link is too light for its own joint, and no two are the same.
TEST(Plausibility, AnArmOfAFewGramsIsNamedAlthoughItsEffortLimitsAreLow) {
  RobotModel arm = of_placeholders(test::ur10());
  for (JointInfo& joint : arm.joints) joint.limits.effort = 12.0;
  const auto named = AllOf(HasSubstr("shoulder_link (0.009 kg)"), HasSubstr("wrist_3_link (0.014 kg)"));
  EXPECT_THAT(other_doubts(arm), ElementsAre(named));
  test::fit_rotors(arm);
  std::vector<std::string> asked;
  const std::vector<Doubt> found = doubts_with_proposals(arm);
  for (const ProposedValue& proposed : found.at(0).proposed) {
    EXPECT_EQ(proposed.key, "inertia");
    EXPECT_EQ(proposed.value, "") << "only the maker can give it";
    if (proposed.field == "mass") asked.push_back(proposed.name);
  }
  EXPECT_EQ(asked.size(), 6U);
  // With strong joints, the links are named once and not by two rules.
  for (JointInfo& joint : arm.joints) joint.limits.effort = 200.0;
  EXPECT_THAT(other_doubts(arm), ElementsAre(named));
  // A small arm has a joint that is weak enough for such masses.
  arm.joints[5].limits.effort = 1.0;
  arm.joints[0].limits.effort = arm.joints[1].limits.effort = arm.joints[2].limits.effort = 12.0;
  arm.joints[3].limits.effort = arm.joints[4].limits.effort = 12.0;
  EXPECT_THAT(other_doubts(arm), IsEmpty());
}

// A rail that could carry many arms does not make the arm on it doubtful.
TEST(Plausibility, AnArmOnAStrongRailIsNotDoubted) {
  RobotModel arm = test::ur10();
  arm.chain.motion[0] = JointMotion::kPrismatic;
  arm.joints[0].limits.effort = 1e4;
  EXPECT_THAT(other_doubts(arm), IsEmpty());
}

TEST(Plausibility, ArmsOfAFifthOfTheWeightThatTheirJointsHoldAreNotDoubted) {
  const double weight_and_reach = 9.81 * 6.0 * reach(test::ur10());
  for (const double share : {0.19, 0.21}) {
    RobotModel arm = test::ur10();
    for (int i = 0; i < 6; ++i) arm.chain.link[static_cast<std::size_t>(i)] = body(1.0, 0.1 + 0.01 * i);
    for (JointInfo& joint : arm.joints) joint.limits.effort = weight_and_reach / share;
    EXPECT_EQ(other_doubts(arm).empty(), share > 0.2) << share;
  }
}

TEST(Plausibility, InertiaThatNoBodyOfTheMassHasIsNamed) {
  RobotModel arm = test::ur10();
  arm.chain.link[2] = body(4.0, 1.2);
  arm.chain.link[3] = body(2.0, 1e-3);
  EXPECT_THAT(other_doubts(arm), ElementsAre(AllOf(HasSubstr("forearm_link (1.2 m)"), HasSubstr("half")),
                                             AllOf(HasSubstr("wrist_1_link (0.001 m)"), HasSubstr("2 mm"))));
}

/// A motor's own inertia where the gear ratio was left out, and one whose ratio was taken twice.
TEST(Plausibility, RotorsThatDoNotGoWithTheirLimitsAreNamed) {
  RobotModel arm = test::ur10();
  test::fit_rotors(arm);
  EXPECT_THAT(doubts(arm), IsEmpty());
  const double right = arm.chain.rotor_inertia[2];
  for (const bool marked : {false, true}) {
    if (marked) arm.estimated_rotors = {"elbow_joint"};
    for (const double factor : {1.0 / 90.0, 90.0}) {
      arm.chain.rotor_inertia[2] = factor * right;
      EXPECT_THAT(doubts(arm), IsEmpty()) << factor;
    }
    for (const double factor : {1e-4, 1.0 / 110.0, 110.0}) {
      arm.chain.rotor_inertia[2] = factor * right;
      EXPECT_THAT(doubts(arm), ElementsAre(AllOf(HasSubstr("elbow_joint ("), HasSubstr("expected 1.6"),
                                                 HasSubstr("gear ratio"))))
          << factor;
    }
  }
}

TEST(Plausibility, LimitsThatLookLikeDegreesAreNamed) {
  RobotModel arm = test::ur10();
  arm.joints[0].limits.lower = -160.0;
  arm.joints[0].limits.upper = 160.0;
  test::fit_rotors(arm);
  arm.joints[5].limits.velocity = 180.0;  // suggests no rotor inertia
  EXPECT_THAT(doubts(arm),
              ElementsAre(AllOf(HasSubstr("shoulder_pan_joint (160)"), HasSubstr("degrees")),
                          AllOf(HasSubstr("wrist_3_joint (180)"), HasSubstr("degrees per second"))));
}

TEST(Plausibility, AnEffortLimitThatCannotHoldTheArmIsNamedWithWhatItNeeds) {
  RobotModel arm = test::ur10();
  arm.joints[1].limits.effort = 10.0;
  arm.joints[2].limits.effort = 7.0;
  const std::vector<std::string> found = other_doubts(arm);
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
  EXPECT_THAT(other_doubts(arm), Contains(HasSubstr("] deg and m, and its effort limit is 1")));
  arm = test::random_arm(6, 3, false);
  for (JointInfo& joint : arm.joints) joint.limits.effort = 1.0;
  EXPECT_THAT(other_doubts(arm), Contains(HasSubstr("] deg, and its effort limit is 1")));
}

TEST(Plausibility, AFingerAsTheLastJointIsNamed) {
  RobotModel arm = test::ur10();
  arm.chain.motion[5] = JointMotion::kPrismatic;
  arm.joints[5].limits.lower = 0.01;
  arm.joints[5].limits.upper = 0.05;
  EXPECT_THAT(other_doubts(arm),
              ElementsAre(AllOf(HasSubstr("wrist_3_joint"), HasSubstr("hold: {wrist_3_joint: 0.01}"))));
}

TEST(Plausibility, AClawThatTurnsIsNamedAndAWristIsNot) {
  RobotModel arm = test::ur10();
  arm.joints[5].limits.lower = -0.2;
  arm.joints[5].limits.upper = 0.85;
  EXPECT_THAT(other_doubts(arm),
              ElementsAre(AllOf(HasSubstr("wrist_3_joint: the last joint turns by only 1.05 rad"),
                                HasSubstr("hold: {wrist_3_joint: 0}"))));
  arm.joints[5].limits.lower = -1.6;
  arm.joints[5].limits.upper = 1.6;
  EXPECT_THAT(other_doubts(arm), IsEmpty());
  arm.joints[5].limits.has_position = false;  // a continuous joint has no range
  arm.joints[5].limits.lower = arm.joints[5].limits.upper = 0.0;
  EXPECT_THAT(other_doubts(arm), IsEmpty());
}

TEST(Plausibility, PlaceholdersThatAllLinksShareAreNamed) {
  RobotModel arm = test::ur10();
  // The frames of the bodies are turned against those of the URDF, as the axes of their joints are.
  for (int i = 0; i < arm.n(); ++i) {
    const Mat3 R_BL(Eigen::AngleAxisd(0.7 * i, Vec3::UnitX()));
    const LinkInertia in_L{3.0, Vec3(0.0, 0.0, 0.3), Vec3(0.21, 0.22, 0.03).asDiagonal()};
    arm.chain.link[static_cast<std::size_t>(i)] = in_frame(in_L, R_BL, Vec3(0.0, 0.1 * i, 0.0));
  }
  const auto named = AllOf(HasSubstr("shoulder_link, "), HasSubstr("wrist_3_link"), HasSubstr("3 kg"),
                           HasSubstr("placeholders"));
  EXPECT_THAT(doubts(arm), Contains(named));
  RobotModel other = arm;
  other.chain.link[3].mass *= 1.001;
  EXPECT_THAT(doubts(other), testing::Not(Contains(named)));
  other = arm;
  other.chain.link[3].inertia *= 1.001;
  EXPECT_THAT(doubts(other), testing::Not(Contains(named)));
}

TEST(Plausibility, NothingThatIsMissingIsDoubtful) {
  RobotModel arm = test::ur10();
  for (JointInfo& joint : arm.joints) joint.limits.effort = joint.limits.velocity = 0.0;
  std::string text = urdf_text(arm);
  const std::string end = "</inertial>";
  for (auto at = text.find("<inertial>"); at != std::string::npos; at = text.find("<inertial>", at))
    text.erase(at, text.find(end, at) + end.size() - at);
  const test::TemporaryFolder folder;
  MissingData missing;
  RobotModel robot = *load_robot(read_robot_file(folder.write("arm.urdf", text)), &missing);
  EXPECT_EQ(missing.inertia.size(), 6U);
  robot.chain.rotor_inertia.setConstant(1e-6);
  EXPECT_TRUE(doubts_with_proposals(robot, missing).empty());
  EXPECT_FALSE(doubts_with_proposals(robot).empty()) << "as if the placeholders were values of the arm";
}

}  // namespace plausibility_test
}  // namespace armtune::internal
