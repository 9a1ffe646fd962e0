// An arm out of a larger tree: base and tip links, and held joints.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "tests/core/support/states.hpp"
#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_selection_test {

using test::joint;
using test::link;
using test::robot;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

UrdfOptions with_tip(const std::string& tip) {
  UrdfOptions options;
  options.tip_link = tip;
  return options;
}
UrdfOptions with_base(const std::string& base, const std::string& tip = "") {
  UrdfOptions options = with_tip(tip);
  options.base_link = base;
  return options;
}
UrdfOptions with_held(const std::string& joint, double value) {
  UrdfOptions options;
  options.held[joint] = value;
  return options;
}

/// Turned about the vertical alone: gravity pulls alike on both sides of it.
const std::string kUprightWaist =
    "<origin xyz='0.1 -0.2 0.3' rpy='0 0 0.7'/><axis xyz='0 0.6 0.8'/>" + test::kLimit;

class UrdfSelection : public test::UrdfFiles {
 protected:
  UrdfSelection() : generator_(77) {}

  /// A body that is unlike any other.
  std::string body() {
    const auto number = [this](double lower, double upper) {
      return test::random_number(generator_, lower, upper);
    };
    const double a = number(0.02, 0.03), b = number(0.02, 0.03), c = number(0.02, 0.03);
    return fmt::format(
        "<inertial><origin xyz='{} {} {}' rpy='{} {} {}'/><mass value='{}'/>"
        "<inertia ixx='{}' iyy='{}' izz='{}' ixy='0.001' ixz='0.002' iyz='-0.001'/></inertial>",
        number(-0.1, 0.1), number(-0.1, 0.1), number(-0.1, 0.1), number(-1, 1), number(-1, 1), number(-1, 1),
        number(1, 3), a, b, c);
  }
  std::string placed(const std::string& axis = "0 0.6 0.8") {
    const auto number = [this] { return test::random_number(generator_, -0.4, 0.4); };
    return fmt::format("<origin xyz='{} {} {}' rpy='{} {} {}'/><axis xyz='{}'/>{}", number(), number(),
                       number(), number(), number(), number(), axis, test::kLimit);
  }
  /// `count` moving joints on `base`, with links `prefix`1, 2, ...
  std::string chain(const std::string& prefix, const std::string& base, int count) {
    std::string text;
    std::string before = base;
    for (int i = 1; i <= count; ++i) {
      const std::string name = prefix + std::to_string(i);
      text += link(name, body()) +
              joint(name + "_joint", i == 2 ? "prismatic" : "revolute", before, name, placed());
      before = name;
    }
    return text;
  }

  void expect_same_arm(const RobotModel& a, const RobotModel& b) {
    ASSERT_EQ(a.n(), b.n());
    EXPECT_EQ(joint_names(a), joint_names(b));
    for (int sample = 0; sample < 10; ++sample) {
      const JointVector q = test::random_configuration(generator_, a);
      const JointVector qd = test::random_vector(generator_, a.n(), 1.0);
      const JointVector qdd = test::random_vector(generator_, a.n(), 1.0);
      const JointVector torque = test::inverse_dynamics_at(a.chain, q, qd, qdd);
      EXPECT_LT((torque - test::inverse_dynamics_at(b.chain, q, qd, qdd)).norm(), 1e-12 * torque.norm());
      EXPECT_LT((test::poses_at(a.chain, q).p_0T - test::poses_at(b.chain, q).p_0T).norm(), 1e-12);
      EXPECT_LT((test::poses_at(a.chain, q).R_0T - test::poses_at(b.chain, q).R_0T).norm(), 1e-12);
    }
  }

  std::mt19937 generator_;
};

TEST_F(UrdfSelection, AnArmOfAHumanoidMovesLikeTheArmAlone) {
  const std::string arm = chain("right", "chest", 4);
  const std::string whole = robot(link("pelvis", body()) + link("chest", body()) +
                                  joint("waist", "revolute", "pelvis", "chest", kUprightWaist) + arm +
                                  chain("left", "chest", 3) + chain("leg", "pelvis", 2));
  const RobotModel alone = read(robot(link("chest") + arm));
  UrdfOptions options;
  options.base_link = "chest";
  options.tip_link = "right4";
  const RobotModel selected = read(whole, options);
  EXPECT_EQ(selected.base_link, "chest");
  expect_same_arm(selected, alone);
  // Without a base the waist is the arm's first joint, and the other arm hangs on what it moves.
  options.base_link.clear();
  EXPECT_THAT(
      refusal(whole, options),
      AllOf(HasSubstr("the chain to 'right4'"), HasSubstr("'left1_joint', 'left2_joint', 'left3_joint'"),
            HasSubstr("hold: {left1_joint: 0, left2_joint: 0, left3_joint: 0}"),
            testing::Not(HasSubstr("leg"))));
  options.held = {{"left1_joint", 0.0}, {"left2_joint", 0.0}, {"left3_joint", 0.0}};
  EXPECT_EQ(read(whole, options).n(), 5);
}

TEST_F(UrdfSelection, ATiltedBaseLinkFeelsGravityAsTheWholeTreeDoes) {
  const std::string torso =
      link("pelvis") + link("spine") + link("chest") + joint("back", "fixed", "pelvis", "spine", placed());
  const std::string at_waist = placed();
  const std::string arm = chain("arm", "chest", 4);
  const auto tree = [&](const std::string& waist) {
    return robot(torso + joint("waist", waist, "spine", "chest", at_waist) + arm);
  };
  UrdfOptions of_arm = with_base("chest", "arm4");
  UrdfOptions of_tree = with_tip("arm4");
  // At zero where nothing holds the waist, as if it were fixed there.
  std::vector<std::pair<RobotModel, RobotModel>> arms;
  arms.emplace_back(read(tree("revolute"), of_arm), read(tree("fixed"), of_tree));
  of_arm.held = of_tree.held = {{"waist", 0.6}};
  arms.emplace_back(read(tree("revolute"), of_arm), read(tree("revolute"), of_tree));
  for (const auto& [alone, whole] : arms) {
    ASSERT_EQ(joint_names(alone), joint_names(whole));
    EXPECT_NEAR(alone.chain.gravity.norm(), 9.81, 1e-12);
    Chain upright = alone.chain;
    upright.gravity = Chain().gravity;
    for (int sample = 0; sample < 10; ++sample) {
      const JointVector q = test::random_configuration(generator_, alone);
      const JointVector torque = test::gravity_torque_at(whole.chain, q);
      EXPECT_LT((test::gravity_torque_at(alone.chain, q) - torque).norm(), 1e-12 * torque.norm());
      EXPECT_GT((test::gravity_torque_at(upright, q) - torque).norm(), 1e-3 * torque.norm());
    }
  }
}

TEST_F(UrdfSelection, AHeldJointIsOneFixedWhereItIsHeld) {
  const std::string arm = link("base") + chain("arm", "base", 3);
  const std::string finger_body = body();
  const std::string further = body();
  const auto with_gripper = [&](const std::string& type, const std::string& origin, const std::string& rest) {
    return robot(arm + link("finger", finger_body) +
                 joint("finger_joint", type, "arm3", "finger", "<origin " + origin + "/>" + rest) +
                 link("pad", further) +
                 joint("pad_joint", "fixed", "finger", "pad", "<origin xyz='0.1 0.2 0.3' rpy='0.3 0 0'/>"));
  };
  UrdfOptions options;
  options.tip_link = "arm3";
  // It slides by 0.5 along its axis; it turns by 0.5 about it. The axis is not of unit length in the file.
  options.held = {{"finger_joint", 0.5}};
  const std::string axis = "<axis xyz='0 0 2'/>" + test::kLimit;
  expect_same_arm(read(with_gripper("prismatic", "xyz='0.1 0 0.05' rpy='0 0 0'", axis), options),
                  read(with_gripper("fixed", "xyz='0.1 0 0.55' rpy='0 0 0'", ""), with_tip("arm3")));
  const RobotModel turned = read(with_gripper("revolute", "xyz='0.1 0 0.05' rpy='0 0 0'", axis), options);
  expect_same_arm(turned,
                  read(with_gripper("fixed", "xyz='0.1 0 0.05' rpy='0 0 0.5'", ""), with_tip("arm3")));
  const RobotModel bare = read(robot(arm));
  EXPECT_GT(turned.chain.link[2].mass, bare.chain.link[2].mass + 2.0) << "finger and pad are carried";
}

TEST_F(UrdfSelection, AJointOfTheArmsOwnCanBeHeldAndAMimicToo) {
  const std::string inside = link("base") + chain("arm", "base", 4);
  UrdfOptions options;
  options.held = {{"arm3_joint", 0.25}};
  EXPECT_THAT(joint_names(read(robot(inside), options)),
              ElementsAre("arm1_joint", "arm2_joint", "arm4_joint"));
  const std::string mimic =
      robot(inside + link("finger", body()) +
            joint("finger_joint", "revolute", "arm4", "finger", placed() + "<mimic joint='arm4_joint'/>"));
  EXPECT_THAT(refusal(mimic, {}), AllOf(HasSubstr("finger_joint"), HasSubstr("mimic"), HasSubstr("hold")));
  EXPECT_EQ(read(mimic, with_held("finger_joint", 0.0)).n(), 4);
}

TEST_F(UrdfSelection, BothFingersOfAGripperAreToBeHeld) {
  const std::string inside = link("base") + chain("arm", "base", 3);
  const auto finger = [this](const std::string& name, const std::string& rest) {
    return link(name, body()) + joint(name + "_joint", "prismatic", "arm3", name, placed() + rest);
  };
  const std::string text =
      robot(inside + finger("left", "") + finger("right", "<mimic joint='left_joint'/>"));
  EXPECT_THAT(refusal(text, {}), HasSubstr("hold: {left_joint: 0, right_joint: 0}"));
  UrdfOptions options;
  options.held = {{"left_joint", 0.0}, {"right_joint", 0.0}};
  EXPECT_EQ(read(text, options).n(), 3);
}

TEST_F(UrdfSelection, AllJointsOfAGripperAreNamedAtOnce) {
  const auto finger = [this](const std::string& name, const std::string& on, const std::string& rest) {
    return link(name, body()) + joint(name + "_joint", "prismatic", on, name, placed() + rest);
  };
  const std::string follows = "<mimic joint='left_joint'/>";
  const std::string text = robot(link("base") + chain("arm", "base", 3) + finger("left", "arm3", "") +
                                 finger("left_tip", "left", follows) + finger("right", "arm3", follows) +
                                 finger("right_tip", "right", follows));
  EXPECT_THAT(refusal(text, {}),
              HasSubstr("hold: {left_joint: 0, left_tip_joint: 0, right_joint: 0, right_tip_joint: 0}"));
  UrdfOptions options;
  for (const char* name : {"left_joint", "left_tip_joint", "right_joint", "right_tip_joint"})
    options.held[name] = 0.0;
  EXPECT_EQ(read(text, options).n(), 3);
}

TEST_F(UrdfSelection, NamesAndValuesThatAreNotTheFilesAreRefused) {
  const std::string text = robot(link("base") + chain("arm", "base", 3));
  EXPECT_THAT(refusal(text, with_base("bass")), AllOf(HasSubstr("base_link 'bass'"), HasSubstr("'base'")));
  EXPECT_THAT(refusal(text, with_base("arm2", "arm1")),
              AllOf(HasSubstr("'arm2'"), HasSubstr("'arm1'"), HasSubstr("the same chain")));
  EXPECT_THAT(refusal(text, with_held("arm1_join", 0.0)),
              AllOf(HasSubstr("hold"), HasSubstr("did you mean 'arm1_joint'")));
  EXPECT_THAT(refusal(text, with_held("arm1_joint", 2.5)),
              AllOf(HasSubstr("'arm1_joint' at 2.5 rad"), HasSubstr("-1 .. 2")));
  EXPECT_THAT(refusal(text, with_held("arm1_joint", NAN)), HasSubstr("at nan rad"));
  UrdfOptions options;
  options.limits["arm9_joint"] = {};
  EXPECT_THAT(refusal(text, options), HasSubstr("limits: there is no joint 'arm9_joint'"));
  options.limits.clear();
  options.inertia["arm9"] = {};
  EXPECT_THAT(refusal(text, options), HasSubstr("inertia of link 'arm9'"));
}

TEST_F(UrdfSelection, GivenLimitsAndInertiaStandForThoseOfTheFile) {
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
    EXPECT_THAT(refusal(whole, other), HasSubstr("joint 'j': acceleration limit is"));
  }
  EXPECT_EQ(read(whole, options).joints[0].limits.lower, -0.5);
  EXPECT_EQ(read(whole, options).joints[0].limits.upper, 0.5);
}

TEST_F(UrdfSelection, GivenInertiaIsAboutTheCentreOfMassAsThatOfTheFileIs) {
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

TEST_F(UrdfSelection, AContinuousJointTakesPositionLimitsThatAreGiven) {
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
  EXPECT_THAT(refusal(text, options), AllOf(HasSubstr("joint 'j'"), HasSubstr("give both")));
}

TEST_F(UrdfSelection, LimitsAndInertiaOfWhatDoesNotMoveAreRefused) {
  const std::string text = robot(link("base") + chain("arm", "base", 3) + link("tip") +
                                 joint("fixed", "fixed", "arm3", "tip") + chain("other", "base", 2));
  for (const char* name : {"fixed", "other1_joint"}) {
    UrdfOptions options = with_tip("arm3");
    options.limits[name] = {{}, {}, 1.0, {}};
    EXPECT_THAT(refusal(text, options),
                HasSubstr(fmt::format("limits: joint '{}' is not a moving joint of this arm", name)));
  }
  for (const char* name : {"base", "other1"}) {
    UrdfOptions options = with_tip("arm3");
    options.inertia[name] = {1.0, Vec3::Zero(), Mat3::Identity()};
    EXPECT_THAT(refusal(text, options),
                HasSubstr(fmt::format("inertia: link '{}' is not moved by this arm; leave it out", name)));
  }
}

TEST_F(UrdfSelection, AHeldJointKeepsToTheLimitsThatAreGiven) {
  const std::string text = robot(link("base") + chain("arm", "base", 3));  // limits -1 .. 2
  UrdfOptions options = with_held("arm3_joint", 2.5);
  options.limits["arm3_joint"] = {{}, 3.0, {}, {}};
  EXPECT_EQ(read(text, options).n(), 2);
  options.limits["arm3_joint"] = {0.0, 1.0, {}, {}};
  EXPECT_THAT(refusal(text, options), AllOf(HasSubstr("'arm3_joint' at 2.5 rad"), HasSubstr("0 .. 1")));
  options.limits["arm3_joint"] = {{}, 3.0, {}, 5.0};
  EXPECT_THAT(refusal(text, options), AllOf(HasSubstr("'arm3_joint' is fixed by 'hold'"),
                                            HasSubstr("velocity, effort and acceleration")));
}

TEST_F(UrdfSelection, WhatIsProposedToBeHeldCanBeHeld) {
  const std::string arm = link("base") + chain("arm", "base", 3) + link("finger", body());
  const std::string limit = "<axis xyz='0 0 1'/><limit lower='0.1' upper='0.5' velocity='1' effort='1'/>";
  const std::string gripper = robot(arm + joint("finger_joint", "revolute", "arm3", "finger", limit));
  EXPECT_THAT(refusal(gripper, with_tip("arm3")), HasSubstr("hold: {finger_joint: 0.1}"));
  UrdfOptions options = with_tip("arm3");
  options.held = {{"finger_joint", 0.1}};
  EXPECT_EQ(read(gripper, options).n(), 3);
  EXPECT_THAT(refusal(robot(arm + joint("finger_joint", "revolute", "arm3", "finger",
                                        limit + "<mimic joint='arm1_joint'/>"))),
              HasSubstr("hold: {finger_joint: 0.1}"));
  // Nothing can hold a joint that floats.
  EXPECT_THAT(
      refusal(robot(arm + joint("finger_joint", "floating", "arm2", "finger")), with_tip("arm3")),
      AllOf(HasSubstr("'finger_joint'"), HasSubstr("a fixed joint"), testing::Not(HasSubstr("hold:"))));
}

TEST_F(UrdfSelection, ATipLinkThatATreeDoesNotHaveIsNamedFirst) {
  const std::string tree = robot(link("base") + link("left") + joint("l", "revolute", "base", "left") +
                                 link("right") + joint("r", "revolute", "base", "right"));
  EXPECT_THAT(refusal(tree, with_tip("rigth")),
              AllOf(HasSubstr("tip_link 'rigth': there is no such link"), HasSubstr("'right'")));
  EXPECT_THAT(refusal(tree), HasSubstr("name the tip_link"));
}

}  // namespace urdf_selection_test
}  // namespace armtune::internal
