#include "core/robot/urdf_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "core/robot/theta.hpp"
#include "core/robot/urdf_reader.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace urdf_writer_test {

using test::WorstError;

RobotModel read_back(const std::string& text, const std::string& tip = "tool", const std::string& base = "") {
  const std::string path = testing::TempDir() + "armtune_written_" + std::to_string(getpid()) + ".urdf";
  std::ofstream(path, std::ios::binary) << text;
  UrdfOptions options;
  options.tip_link = tip;
  options.base_link = base;
  RobotModel model = read_urdf(path, options);
  std::remove(path.c_str());
  return model;
}

TEST(UrdfWriter, WhatItWritesReadsBackAsTheSameArm) {
  std::mt19937 generator(251);
  WorstError torque("torque", 1e-9);  // rounding; angles near straight up lose half the digits
  WorstError tool("tool", 1e-9);
  for (const RobotModel& arm : test::all_arms()) {
    const RobotModel back = read_back(urdf_text(arm));
    ASSERT_EQ(joint_names(back), joint_names(arm));
    for (int i = 0; i < arm.n(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_EQ(back.chain.motion[k], arm.chain.motion[k]);
      EXPECT_EQ(back.joints[k].limits.has_position, arm.joints[k].limits.has_position);
      EXPECT_EQ(back.joints[k].limits.lower, arm.joints[k].limits.lower);
      EXPECT_EQ(back.joints[k].limits.velocity, arm.joints[k].limits.velocity);
      EXPECT_EQ(back.joints[k].limits.effort, arm.joints[k].limits.effort);
    }
    Chain bare = test::without_friction(arm.chain);
    bare.rotor_inertia.setZero();
    for (int sample = 0; sample < 10; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const JointVector qd = test::random_vector(generator, arm.n(), 1.0);
      const JointVector qdd = test::random_vector(generator, arm.n(), 2.0);
      torque.compare(test::inverse_dynamics_at(back.chain, q, qd, qdd),
                     test::inverse_dynamics_at(bare, q, qd, qdd), arm.name);
      const Poses a = test::poses_at(back.chain, q);
      const Poses b = test::poses_at(arm.chain, q);
      tool.compare(a.p_0T, b.p_0T, arm.name);
      tool.compare(a.R_0T, b.R_0T, arm.name);
    }
  }
}

TEST(UrdfWriter, AnArmWithALinkCalledToolGetsAnotherNameForItsEnd) {
  RobotModel arm = test::ur10();
  EXPECT_EQ(urdf_tool_link(arm), "tool");
  arm.joints.back().link = "tool";
  ASSERT_EQ(urdf_tool_link(arm), "tool_");
  const RobotModel back = read_back(urdf_text(arm), "tool_");
  EXPECT_LT((back.chain.p_BT - arm.chain.p_BT).norm(), 1e-12);
}

TEST(UrdfWriter, ATiltedArmReadsBackUnderTheSameGravity) {
  RobotModel arm = test::ur10();
  for (const Vec3& gravity : {Vec3(3.0, -8.0, 2.0), Vec3(0.0, 0.0, 9.81)}) {
    arm.chain.gravity = 9.81 * gravity.normalized();
    const RobotModel back = read_back(urdf_text(arm), "tool", arm.base_link);
    EXPECT_LT((back.chain.gravity - arm.chain.gravity).norm(), 1e-9);  // as above
    EXPECT_LT((back.chain.p_BT - arm.chain.p_BT).norm(), 1e-12);
  }
  EXPECT_EQ(urdf_text(test::ur10()).find("upright"), std::string::npos);
}

TEST(UrdfWriter, AThinRodInTurnedAxesReadsBack) {
  // Turned into the joint's axes its smallest moment rounds to some -1e-17.
  const std::string rod =
      "<robot name='r'><link name='a'/><link name='b'><inertial><origin xyz='0.1 0 0' rpy='0 0.1 0'/><mass "
      "value='2'/>"
      "<inertia ixx='0.1' ixy='0' ixz='0' iyy='0' iyz='0' izz='0.1'/></inertial></link>"
      "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><origin xyz='0 0 0.3' rpy='0.1 0 "
      "0'/>"
      "<axis xyz='0 1 0'/><limit lower='-1' upper='2' velocity='3' effort='4'/></joint></robot>";
  const RobotModel arm = read_back(rod, "");
  EXPECT_NO_THROW(validate(arm));
  const RobotModel back = read_back(urdf_text(arm));
  EXPECT_NO_THROW(validate(back));
  EXPECT_LT((back.chain.link[0].inertia - arm.chain.link[0].inertia).norm(), 1e-12);
}

TEST(UrdfWriter, AHeavyPointFarFromItsOriginReadsBack) {
  // Its moments about its own centre are less than the rounding of those about the joint.
  RobotModel arm = test::ur10();
  for (const double mass : {1e3, 1e6}) {
    const Vec3 c(0.1, 1.1, 0.3);
    LinkInertia& body = arm.chain.link[0];
    body = in_frame({mass, Vec3::Zero(), Vec3(1e-8, 2e-8, 2e-8).asDiagonal()}, Mat3::Identity(), c);
    EXPECT_NO_THROW(validate(arm));
    const RobotModel back = read_back(urdf_text(arm));
    EXPECT_NO_THROW(validate(back));
    EXPECT_LT((back.chain.link[0].inertia - body.inertia).norm(), 1e-14 * body.inertia.norm());
  }
}

TEST(UrdfWriter, ALinkWithoutMassIsWrittenWithFiniteNumbers) {
  RobotModel arm = test::ur10();
  arm.chain.link[1] = {};
  EXPECT_EQ(urdf_text(arm).find("nan"), std::string::npos);
}

}  // namespace urdf_writer_test
}  // namespace armtune::internal
