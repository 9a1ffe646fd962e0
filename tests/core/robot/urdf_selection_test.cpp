// An arm out of a larger tree: base and tip links, and held joints.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/core/robot/urdf_trees.hpp"

namespace armtune::internal {
namespace urdf_selection_test {

using test::joint;
using test::link;
using test::refused_at;
using test::robot;
using test::with_base;
using test::with_held;
using test::with_tip;
using testing::ElementsAre;
using testing::HasSubstr;

/// Turned about the vertical alone: gravity pulls alike on both sides of it.
const std::string kUprightWaist =
    "<origin xyz='0.1 -0.2 0.3' rpy='0 0 0.7'/><axis xyz='0 0.6 0.8'/>" + test::kLimit;

class UrdfSelection : public test::UrdfTrees {};

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
  EXPECT_THAT(error_of(whole, options),
              refused_at({.key = "left1_joint",
                          .value = "",
                          .limit = "hold: {left1_joint: 0, left2_joint: 0, left3_joint: 0}"}))
      << "but not the joints of the leg";
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
  EXPECT_THAT(error_of(mimic, {}),
              refused_at({.key = "finger_joint", .value = "arm4_joint", .limit = "hold: {finger_joint: 0}"}));
  EXPECT_EQ(read(mimic, with_held("finger_joint", 0.0)).n(), 4);
}

TEST_F(UrdfSelection, BothFingersOfAGripperAreToBeHeld) {
  const std::string inside = link("base") + chain("arm", "base", 3);
  const auto finger = [this](const std::string& name, const std::string& rest) {
    return link(name, body()) + joint(name + "_joint", "prismatic", "arm3", name, placed() + rest);
  };
  const std::string text =
      robot(inside + finger("left", "") + finger("right", "<mimic joint='left_joint'/>"));
  EXPECT_THAT(error_of(text, {}), refused_at({.key = "right_joint",
                                              .value = "left_joint",
                                              .limit = "hold: {left_joint: 0, right_joint: 0}"}));
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
  EXPECT_THAT(
      error_of(text, {}),
      refused_at({.key = "right_joint",
                  .value = "left_joint",
                  .limit = "hold: {left_joint: 0, left_tip_joint: 0, right_joint: 0, right_tip_joint: 0}"}));
  UrdfOptions options;
  for (const char* name : {"left_joint", "left_tip_joint", "right_joint", "right_tip_joint"})
    options.held[name] = 0.0;
  EXPECT_EQ(read(text, options).n(), 3);
}

TEST_F(UrdfSelection, NamesAndValuesThatAreNotTheFilesAreRefused) {
  const std::string text = robot(link("base") + chain("arm", "base", 3));
  const InputError base = error_of(text, with_base("bass"));
  EXPECT_THAT(base, refused_at({.key = "base_link", .value = "bass", .limit = "the name of a link"}));
  EXPECT_EQ(test::suggested_by(base), "base");
  EXPECT_THAT(error_of(text, with_base("arm2", "arm1")),
              refused_at({.key = "tip_link", .value = "arm1", .limit = "a link on a chain from 'arm2'"}));
  const InputError held = error_of(text, with_held("arm1_join", 0.0));
  EXPECT_THAT(held,
              refused_at({.key = "hold/arm1_join", .value = "arm1_join", .limit = "the name of a joint"}));
  EXPECT_EQ(test::suggested_by(held), "arm1_joint");
  EXPECT_THAT(error_of(text, with_held("arm1_joint", 2.5)),
              refused_at({.key = "hold/arm1_joint", .value = "2.5", .limit = "-1 to 2"}));
  EXPECT_THAT(error_of(text, with_held("arm1_joint", NAN)),
              refused_at({.key = "hold/arm1_joint", .value = "nan", .limit = "-1 to 2"}));
  UrdfOptions options;
  options.limits["arm9_joint"] = {};
  EXPECT_THAT(error_of(text, options), refused_at({.key = "limits/arm9_joint", .value = "arm9_joint"}));
  options.limits.clear();
  options.inertia["arm9"] = {};
  EXPECT_THAT(error_of(text, options), refused_at({.key = "inertia/arm9", .value = "arm9"}));
}

TEST_F(UrdfSelection, WhatIsProposedToBeHeldCanBeHeld) {
  const std::string arm = link("base") + chain("arm", "base", 3) + link("finger", body());
  const std::string limit = "<axis xyz='0 0 1'/><limit lower='0.1' upper='0.5' velocity='1' effort='1'/>";
  const std::string gripper = robot(arm + joint("finger_joint", "revolute", "arm3", "finger", limit));
  const std::string hold = "hold: {finger_joint: 0.1}";
  EXPECT_THAT(error_of(gripper, with_tip("arm3")), refused_at({.key = "finger_joint", .limit = hold}));
  UrdfOptions options = with_tip("arm3");
  options.held = {{"finger_joint", 0.1}};
  EXPECT_EQ(read(gripper, options).n(), 3);
  const std::string mimic =
      joint("finger_joint", "revolute", "arm3", "finger", limit + "<mimic joint='arm1_joint'/>");
  EXPECT_THAT(error_of(robot(arm + mimic)),
              refused_at({.key = "finger_joint", .value = "arm1_joint", .limit = hold}));
  // Nothing can hold a joint that floats.
  EXPECT_THAT(
      error_of(robot(arm + joint("finger_joint", "floating", "arm2", "finger")), with_tip("arm3")),
      refused_at({.key = "finger_joint", .limit = "a fixed, revolute, continuous or prismatic joint"}));
}

TEST_F(UrdfSelection, ATipLinkThatATreeDoesNotHaveIsNamedFirst) {
  const std::string tree = robot(link("base") + link("left") + joint("l", "revolute", "base", "left") +
                                 link("right") + joint("r", "revolute", "base", "right"));
  const InputError misspelt = error_of(tree, with_tip("rigth"));
  EXPECT_THAT(misspelt, refused_at({.key = "tip_link", .value = "rigth", .limit = "the name of a link"}));
  EXPECT_EQ(test::suggested_by(misspelt), "right");
  const InputError either = error_of(tree);
  EXPECT_THAT(either, refused_at({.key = "r", .value = "l", .limit = "one moving joint on each link"}));
  EXPECT_THAT(either.what(), HasSubstr("name the tip_link"));
}

}  // namespace urdf_selection_test
}  // namespace armtune::internal
