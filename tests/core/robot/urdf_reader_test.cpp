#include "core/robot/urdf_reader.hpp"

#include <console_bridge/console.h>

#include <numbers>
#include <thread>

#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_reader_test {

using test::joint;
using test::kInertial;
using test::kLimit;
using test::kUr10;
using test::link;
using test::one_joint;
using test::refused_at;
using test::robot;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

class UrdfReader : public test::UrdfFiles {};

TEST_F(UrdfReader, ExpandedIndustrialFileWithBareFramesLoads) {
  const RobotModel arm = read_urdf(kUr10);
  EXPECT_EQ(arm.name, "ur10");
  EXPECT_EQ(arm.source, kUr10);
  EXPECT_EQ(arm.base_link, "world");
  EXPECT_EQ(arm.tip_link, "tool0");
  ASSERT_EQ(arm.n(), 6);
  EXPECT_EQ(arm.joints[2].name, "elbow_joint");
  EXPECT_EQ(arm.joints[2].link, "forearm_link");
  EXPECT_DOUBLE_EQ(arm.joints[2].limits.upper, kPi);
  double mass = 0.0;
  for (const LinkInertia& body : arm.chain.link) mass += body.mass;
  EXPECT_NEAR(mass, 28.7, 1e-12);
}

TEST_F(UrdfReader, LimitsAndDynamicsAreTaken) {
  const RobotModel arm = read(
      robot(one_joint(kInertial, "<axis xyz='0 1 0'/><dynamics damping='0.5' friction='0.25'/>" + kLimit)));
  const JointLimits& limits = arm.joints[0].limits;
  EXPECT_TRUE(limits.has_position);
  EXPECT_EQ(limits.lower, -1.0);
  EXPECT_EQ(limits.upper, 2.0);
  EXPECT_EQ(limits.velocity, 3.0);
  EXPECT_EQ(limits.effort, 4.0);
  EXPECT_EQ(arm.chain.viscous_friction[0], 0.5);
  EXPECT_EQ(arm.chain.coulomb_friction[0], 0.25);
  EXPECT_EQ(arm.chain.rotor_inertia[0], 0.0);
}

TEST_F(UrdfReader, ContinuousJointHasNoPositionLimits) {
  const RobotModel arm = read(robot(link("a") + link("b") + joint("j", "continuous", "a", "b")));
  EXPECT_FALSE(arm.joints[0].limits.has_position);
  EXPECT_EQ(arm.joints[0].limits.velocity, 3.0);
}

TEST_F(UrdfReader, ToolFrameIsOnTheLastMovingLinkUnlessAskedOtherwise) {
  const std::string text = robot(one_joint() + link("flange") +
                                 joint("f", "fixed", "b", "flange", "<origin xyz='0 0 0.5' rpy='0 0 0'/>"));
  EXPECT_EQ(read(text).tip_link, "b");
  UrdfOptions options;
  options.tip_link = "flange";
  options.p_tip_T = Vec3(0.1, 0, 0);
  EXPECT_LT((read(text, options).chain.p_BT - Vec3(0.1, 0, 0.5)).norm(), 1e-15);
  options.tip_link = "a";
  EXPECT_THAT(error_of(text, options),
              refused_at({.key = "tip_link", .value = "a", .limit = "one of: b, flange"}));
  options.tip_link = "flansch";
  EXPECT_THAT(error_of(text, options),
              refused_at({.key = "tip_link", .value = "flansch", .limit = "one of: b, flange"}));
}

TEST_F(UrdfReader, XacroNamespaceCommentsAndPercentInMeshNamesAreFine) {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<!-- <xacro:macro name='${x}'> <a><a> 100 % -->\n"
      "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n" +
      one_joint(kInertial + "<visual><geometry><mesh filename='package://a%20b.stl'/></geometry></visual>") +
      "<gazebo><plugin a='x > y'>$(arg) ${x} 50 %</plugin><![CDATA[<xacro:if>]]></gazebo></robot>";
  EXPECT_EQ(read(text).n(), 1);
}

TEST_F(UrdfReader, LinksFixedToTheBaseAreDropped) {
  const RobotModel alone = read(robot(one_joint()));
  const RobotModel on_table = read(robot(one_joint() + link("table") + joint("t", "fixed", "table", "a") +
                                         link("lamp") + joint("l", "fixed", "table", "lamp")));
  EXPECT_EQ(on_table.base_link, "table");
  EXPECT_EQ(on_table.chain.link[0].mass, alone.chain.link[0].mass);
  EXPECT_EQ(on_table.n(), 1);
}

// --- No state stays behind ---

class Listener : public console_bridge::OutputHandler {
 public:
  void log(const std::string&, console_bridge::LogLevel, const char*, int) override { ++heard; }
  int heard = 0;
};

TEST_F(UrdfReader, LoggingIsLeftAsItWasFound) {
  console_bridge::OutputHandler* const original = console_bridge::getOutputHandler();
  Listener listener;
  console_bridge::useOutputHandler(&listener);
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  EXPECT_THAT(refusal(robot(link("a") + link("b"))), HasSubstr("Two root links"));
  EXPECT_EQ(console_bridge::getOutputHandler(), &listener);
  EXPECT_EQ(console_bridge::getLogLevel(), console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  EXPECT_EQ(listener.heard, 0);
  EXPECT_EQ(read_urdf(kUr10).n(), 6) << "an error of the file before must not be remembered";
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_WARN);
  console_bridge::useOutputHandler(original);
  console_bridge::useOutputHandler(original);
}

TEST_F(UrdfReader, ThreadsReadGoodAndBadFilesAtTheSameTime) {
  const std::string bad = write(robot(link("a") + link("b")));
  std::vector<int> good(4, 0);
  std::vector<int> refused(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < good.size(); ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 20; ++i) {
        good[t] += read_urdf(kUr10).n() == 6 ? 1 : 0;
        try {
          read_urdf(bad);
        } catch (const InputError&) {
          ++refused[t];
        }
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(good, testing::Each(20));
  EXPECT_THAT(refused, testing::Each(20));
}

}  // namespace urdf_reader_test
}  // namespace armtune::internal
