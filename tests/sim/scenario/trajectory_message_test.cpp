#include "sim/scenario/trajectory_message.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace trajectory_message_test {

using test::refused_at;

// The joints of a UR10 in another order, and a gripper's.
constexpr const char* kNames =
    "joint_names: [elbow_joint, finger, shoulder_pan_joint, shoulder_lift_joint, wrist_1_joint, "
    "wrist_2_joint, wrist_3_joint]\n";

class TrajectoryMessage : public testing::Test {
 protected:
  MotionPoints load(const std::string& text) const {
    return load_trajectory_message(folder_.write("moves.yaml", text), *robot_);
  }
  InputError refused(const std::string& text) const {
    const InputError error = test::input_error([&] { load(text); });
    EXPECT_EQ(error.place().file, folder_ / "moves.yaml");
    return error;
  }

  test::TemporaryFolder folder_;
  std::shared_ptr<const RobotModel> robot_ = load_robot("ur10");
};

TEST_F(TrajectoryMessage, OfRos2GivesEveryJointWhatIsItsOwn) {
  // As `ros2 topic echo` prints it.
  const MotionPoints motion =
      load(std::string("header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: ''\n") + kNames +
           "points:\n"
           "- positions: [0.1, 9, 0.2, 0.3, 0.4, 0.5, 0.6]\n"
           "  velocities: [1, 9, 2, 3, 4, 5, 6]\n"
           "  accelerations: []\n"
           "  effort: []\n"
           "  time_from_start:\n    sec: 0\n    nanosec: 0\n"
           "- positions: [0.7, 9, 0, 0, 0, 0, 0]\n"
           "  velocities: [0, 9, 0, 0, 0, 0, 0]\n"
           "  accelerations: []\n"
           "  effort: []\n"
           "  time_from_start:\n    sec: 2\n    nanosec: 500000000\n"
           "---\n");
  EXPECT_EQ(motion.time, (std::vector{0.0, 2.5}));
  EXPECT_EQ(motion.given, PointsGive::kVelocities);
  JointVector position(6), velocity(6);
  position << 0.2, 0.3, 0.1, 0.4, 0.5, 0.6;
  velocity << 2, 3, 1, 4, 5, 6;
  EXPECT_EQ(motion.points[0].position, position);
  EXPECT_EQ(motion.points[0].velocity, velocity);
  EXPECT_EQ(motion.points[0].acceleration, JointVector(JointVector::Zero(6)));
  EXPECT_EQ(motion.points[1].position[2], 0.7);
  EXPECT_THAT(motion.where(1, "time").file, testing::EndsWith("moves.yaml"));
  EXPECT_EQ(motion.where(1, "time").line, 15);
}

/// Two points, all joints at rest, with more in each.
std::string points(const std::string& more, const std::string& times) {
  const std::string zeros = "[0, 0, 0, 0, 0, 0, 0]";
  std::string text = "points:\n";
  for (const char* time : {"0", times.c_str()})
    text += fmt::format("- {{positions: {}{}, time_from_start: {}}}\n", zeros, more, time);
  return text;
}

TEST_F(TrajectoryMessage, IsFoundWithinGoalsAndOtherMessagesAndTakesTimesOfRos1) {
  const std::string own = kNames + points("", "{secs: 1, nsecs: 250000000}");
  const MotionPoints alone = load(own);
  EXPECT_EQ(alone.time, (std::vector{0.0, 1.25}));
  EXPECT_EQ(alone.given, PointsGive::kPositions);
  const auto within = [](const std::string& key, const std::string& text) {
    std::string indented = key + ":\n";
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at) + 1;
      indented += "  " + text.substr(at, end - at);
      at = end;
    }
    return indented;
  };
  EXPECT_EQ(load(within("joint_trajectory", own)).time, alone.time);
  EXPECT_EQ(load(within("goal", within("trajectory", own))).time, alone.time);
  const std::string zeros = "[0, 0, 0, 0, 0, 0, 0]";
  EXPECT_EQ(load(kNames + points(fmt::format(", velocities: {0}, accelerations: {0}", zeros), "2")).given,
            PointsGive::kAccelerations);
}

TEST_F(TrajectoryMessage, WhatRosWouldNotFollowIsRefusedWithItsLine) {
  const std::string zeros = "[0, 0, 0, 0, 0, 0, 0]";
  EXPECT_THAT(
      refused("joint_names: [elbow_joint, elbow_joint]\n" + points("", "1")),
      refused_at({.line = 1, .key = "joint_names/1", .value = "elbow_joint", .limit = "each joint once"}));
  EXPECT_THAT(refused("controller: {}\n"),
              refused_at({.line = 1, .key = "", .limit = "a trajectory_msgs/JointTrajectory"}));
  EXPECT_THAT(refused("joint_names: [elbow_joit]\n" + points("", "1")),
              refused_at({.line = 1, .key = "joint_names", .limit = "a list with 'shoulder_pan_joint'"}));
  EXPECT_THAT(
      refused(kNames + points("", "1e-9") + fmt::format("- {{positions: {}, time_from_start: 0}}\n", zeros)),
      refused_at({.line = 5, .key = "points/2/time_from_start", .value = "0", .limit = "above 1e-09 s"}));
  EXPECT_THAT(
      refused(kNames + points("", "-1")),
      refused_at({.line = 4, .key = "points/1/time_from_start", .value = "-1", .limit = "0 or more"}));
  EXPECT_THAT(refused(kNames + points(", accelerations: " + zeros, "1")),
              refused_at({.line = 3, .key = "points/0", .limit = "velocities with accelerations"}));
  EXPECT_THAT(refused(kNames + points(", velocities: [0, 0]", "1")),
              refused_at({.line = 3, .key = "points/0/velocities", .value = "2", .limit = "7 numbers"}));
  const std::string one = fmt::format("points:\n- {{positions: {}, time_from_start: 0}}\n", zeros);
  EXPECT_THAT(refused(kNames + one), refused_at({.line = 2, .key = "points", .limit = "at least 2 points"}));
  EXPECT_THAT(refused(kNames + one +
                      fmt::format("- {{positions: {0}, velocities: {0}, time_from_start: 1}}\n", zeros)),
              refused_at({.line = 4, .key = "points/1", .limit = "what the first point has"}));
  EXPECT_THAT(refused(kNames + one + "- {time_from_start: 1}\n"),
              refused_at({.line = 4, .key = "points/1", .limit = "a position for each joint"}));
  EXPECT_THAT(refused(kNames + one + fmt::format("- {{positions: {}}}\n", zeros)),
              refused_at({.line = 4, .key = "points/1", .limit = "the key 'time_from_start'"}));
}

TEST_F(TrajectoryMessage, HasNoTimesIfNoPointOrOnlyZerosGiveThem) {
  for (const char* time : {"", ", time_from_start: 0", ", time_from_start: {sec: 0, nanosec: 0}"}) {
    std::string text = kNames + std::string("points:\n");
    for (const double elbow : {0.0, 0.5, 1.0})
      text += fmt::format("- {{positions: [{}, 0, 0, 0, 0, 0, 0]{}}}\n", elbow, time);
    const MotionPoints motion = load(text);
    EXPECT_TRUE(motion.time.empty()) << time;
    ASSERT_EQ(motion.points.size(), 3U);
    EXPECT_EQ(motion.points[1].position[2], 0.5);
    EXPECT_EQ(motion.lines, (std::vector<std::size_t>{3, 4, 5}));
  }
}

}  // namespace trajectory_message_test
}  // namespace armtune::internal
