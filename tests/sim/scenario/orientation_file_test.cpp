// Orientations in scenario files, and mistakes in them.

#include "sim/scenario/orientation_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/control/pose_search.hpp"
#include "core/robot/kinematics.hpp"
#include "sim/scenario/scenario.hpp"
#include "sim/scenario/task_trouble.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace orientation_file_test {

using test::refused_at;
using testing::HasSubstr;

constexpr double kRounding = 1e-12;
const std::string kCircle = "path: {circle: {center: [-0.65, 0.04, 0.5], radius: 0.1, period: 10}}\n";
const std::string kEight =
    "path: {figure_eight: {center: [-0.65, 0.04, 0.5], length: [0.12, 0, 0], width: [0, 0.06, 0], period: "
    "10}}\n";

class OrientationFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const {
    return folder_.write(
        "own.yaml",
        "robot: ur10\nduration: 12\ncontrol_period: 0.002\ntheta_start: {model_scale: 1}\n" + text);
  }
  Scenario load(const std::string& text) const { return load_scenario(write(text)); }
  InputError refused(const std::string& text) const {
    const std::string path = write(text);
    return test::input_error([&] { load_scenario(path); });
  }
  Mat3 at(const Scenario& scenario, double t) const {
    return scenario.orientation->at(t, scenario.path).orientation.toRotationMatrix();
  }

  const test::TemporaryFolder folder_;
};

TEST_F(OrientationFile, RollPitchAndYawAreThoseOfAUrdf) {
  const Scenario s = load(kCircle + "orientation: {rpy_deg: [180, 20, -30]}\n");
  const double roll = M_PI, pitch = M_PI / 9.0, yaw = -M_PI / 6.0;
  Mat3 x, y, z;
  x << 1, 0, 0, 0, std::cos(roll), -std::sin(roll), 0, std::sin(roll), std::cos(roll);
  y << std::cos(pitch), 0, std::sin(pitch), 0, 1, 0, -std::sin(pitch), 0, std::cos(pitch);
  z << std::cos(yaw), -std::sin(yaw), 0, std::sin(yaw), std::cos(yaw), 0, 0, 0, 1;
  EXPECT_LT((at(s, 3.0) - z * y * x).norm(), kRounding);
  EXPECT_TRUE(s.targets.empty());
}

TEST_F(OrientationFile, AQuaternionIsOneOfLengthOneWithWFirst) {
  const Scenario s = load(kCircle + "orientation: {quaternion: [0, 1, 0, 0]}\n");
  EXPECT_LT((at(s, 3.0) - Vec3(1.0, -1.0, -1.0).asDiagonal().toDenseMatrix()).norm(), kRounding);
  EXPECT_THAT(refused(kCircle + "orientation: {quaternion: [0, 1, 1, 0]}\n"),
              refused_at({.line = 6,
                          .key = "orientation/quaternion",
                          .value = "1.41421",
                          .limit = "[w, x, y, z] of length 1"}));
}

TEST_F(OrientationFile, TheStartThatIsFoundHasTheToolAsItIsToBe) {
  const Scenario s = load(kEight + "orientation: {rpy_deg: [180, 0, 90]}\n");
  Poses poses;
  forward_kinematics(s.robot->chain, s.goal_position, poses);
  EXPECT_LT((poses.p_0T - s.path.at(0.0).position).norm(), 1e-8);
  EXPECT_LT((poses.R_0T - at(s, 0.0)).norm(), 1e-8);
  // Of an axis the roll is left to the arm.
  const Scenario axis = load(kEight + "task_mask: position_and_axis\norientation: {rpy_deg: [180, 0, 90]}\n");
  forward_kinematics(axis.robot->chain, axis.goal_position, poses);
  EXPECT_LT((poses.R_0T.col(2) + Vec3::UnitZ()).norm(), 1e-8);
}

TEST_F(OrientationFile, AWalkKeepsTheToolAsItIsToBe) {
  const Scenario s = load(kEight + "orientation: {along_path: [0, 0, -1]}\n");
  const PathWalk walk = walk_path(s, s.goal_position, 0.0);
  EXPECT_TRUE(is_clear(walk)) << trouble(walk, s).text();
}

TEST_F(OrientationFile, WaypointsMayStandInThePathsFile) {
  folder_.write(
      "poses.csv",
      "time,x,y,z,qw,qx,qy,qz\n0,-0.6,0,0.5,0,1,0,0\n4,-0.7,0,0.5,0,0.8,0.6,0\n9,-0.7,0.1,0.5,0,1,0,0\n");
  const Scenario s = load("path: {waypoints: poses.csv}\norientation: {waypoints: poses.csv}\n");
  EXPECT_LT((s.path.at(4.0).position - Vec3(-0.7, 0.0, 0.5)).norm(), kRounding);
  EXPECT_LT((at(s, 4.0) - Eigen::Quaterniond(0.0, 0.8, 0.6, 0.0).toRotationMatrix()).norm(), kRounding);
  EXPECT_THAT(s.inputs, testing::Contains(HasSubstr("poses.csv")));
  EXPECT_THAT(refused("path: {waypoints: poses.csv}\ntargets: [{name: a, hold: [0, 0, 0]}]\n"),
              refused_at({.file = folder_ / "poses.csv",
                          .line = 1,
                          .key = "qw",
                          .value = "qw",
                          .limit = "one of: time, x, y, z"}));
  folder_.write("long.csv", "time,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0.1,0,0.1\n");
  EXPECT_THAT(refused(kCircle + "orientation: {waypoints: long.csv}\n"),
              refused_at({.file = folder_ / "long.csv",
                          .line = 3,
                          .key = "",
                          .value = "1.00995",
                          .limit = "a quaternion of length 1"}));
  folder_.write("round.csv",
                "time,qw,qx,qy,qz\n0,1,0,0,0\n1,0.0871557,0,0,0.9961947\n2,-0.9848078,0,0,0.1736482\n");
  EXPECT_THAT(refused(kCircle + "orientation: {waypoints: round.csv}\n"),
              refused_at({.file = folder_ / "round.csv",
                          .line = 4,
                          .key = "",
                          .value = "5.93",
                          .limit = "at most 4.71 rad"}));
  EXPECT_THAT(refused(kCircle + "orientation: {waypoints: round.csv}\n").what(), HasSubstr("turn it back"));
  EXPECT_THAT(refused("path: {waypoints: poses.csv}\norientation: {waypoints: round.csv}\n"),
              refused_at({.file = folder_ / "poses.csv",
                          .line = 1,
                          .key = "qw",
                          .value = "qw",
                          .limit = "one of: time, x, y, z"}));
  EXPECT_THAT(refused("path: {waypoints: poses.csv}\norientation: {waypoints: round.csv}\n").what(),
              HasSubstr("with the same file"));
  folder_.write("fast.csv", "time,qw,qx,qy,qz\n0,1,0,0,0\n1.0e-8,0,0,0,1\n1,1,0,0,0\n");
  EXPECT_THAT(
      refused(kCircle + "orientation: {waypoints: fast.csv}\n"),
      refused_at(
          {.file = folder_ / "fast.csv", .line = 2, .key = "", .limit = "at most 1e+06 rad/s and rad/s^2"}));
  EXPECT_THAT(refused(kCircle + "orientation: {waypoints: fast.csv}\n").what(), HasSubstr("more time"));
}

TEST_F(OrientationFile, WhatCannotBeIsRefusedWithLineAndAdvice) {
  EXPECT_THAT(refused(kCircle), refused_at({.line = 1, .key = "", .limit = "the key 'targets'"}));
  EXPECT_THAT(refused(kCircle + "targets: []\n"),
              refused_at({.line = 6, .key = "targets", .limit = "at least one target"}));
  EXPECT_THAT(refused(kCircle + "targets: [{name: a, hold: [0, 0, 0]}]\norientation: {rpy_deg: [0, 0, 0]}\n"),
              refused_at({.line = 7, .key = "orientation", .limit = "no gaze targets"}));
  EXPECT_THAT(
      refused(kCircle + "targets: [{name: a, hold: [0, 0, 0]}]\norientation: {rpy_deg: [0, 0, 0]}\n").what(),
      HasSubstr("set 'targets' to []"));
  EXPECT_THAT(
      refused(kCircle + "orientation: {}\n"),
      refused_at(
          {.line = 6, .key = "orientation", .limit = "one of: rpy_deg, quaternion, along_path, waypoints"}));
  EXPECT_THAT(
      refused(kCircle + "orientation: {rpy_deg: [0, 0, 0], quaternion: [1, 0, 0, 0]}\n"),
      refused_at(
          {.line = 6, .key = "orientation", .limit = "one of: rpy_deg, quaternion, along_path, waypoints"}));
  EXPECT_THAT(refused("path: {hold: [-0.6, 0, 0.5]}\norientation: {along_path: [0, 0, -1]}\n"),
              refused_at({.line = 6, .key = "orientation/along_path", .limit = "a path that moves"}));
  EXPECT_THAT(refused(kCircle + "orientation: {along_path: [0, 0, 0]}\n"),
              refused_at({.line = 6, .key = "orientation/along_path", .limit = "not zero"}));
  EXPECT_THAT(
      refused(kCircle + "orientation: {along_path: [0, 1, 0]}\n"),
      refused_at({.line = 6, .key = "orientation/along_path", .limit = "a direction that crosses the path"}));
  EXPECT_THAT(refused(kCircle + "orientation: {along_path: [0, 1, 0]}\n").what(),
              HasSubstr("another direction"));
  EXPECT_THAT(
      refused("path: {center: [-0.6, 0, 0.5], frequency: 1, terms: [{order: 1, sin: [0.1, 0, 0]}]}\n"
              "orientation: {along_path: [0, 0, -1]}\n"),
      refused_at(
          {.line = 6, .key = "orientation/along_path", .limit = "a path that neither stops nor reverses"}));
  EXPECT_THAT(refused("path: {center: [-0.6, 0, 0.5], frequency: 1, terms: [{order: 1, sin: [0.1, 0, 0]}]}\n"
                      "orientation: {along_path: [0, 0, -1]}\n")
                  .what(),
              HasSubstr("waypoints"));
  EXPECT_THAT(refused(kCircle + "task_mask: position\norientation: {rpy_deg: [180, 0, 0]}\n"),
              refused_at({.line = 7, .key = "orientation", .limit = "a task_mask with an orientation"}));
  EXPECT_THAT(refused(kCircle + "task_mask: position_and_axis\norientation: {along_path: [0, 0, -1]}\n"),
              refused_at({.line = 7, .key = "orientation", .limit = "a task_mask of pose"}));
  EXPECT_THAT(
      refused("path: {polyline: {corners: [[-0.6, 0, 0.5], [-0.7, 0, 0.5], [-0.7, 0.1, 0.5]], speed: 0.5, "
              "blend: 0.001}}\norientation: {along_path: [0, 0, -1]}\n"),
      refused_at({.line = 6, .key = "orientation/along_path", .limit = "at most 100 rad/s"}));
  EXPECT_THAT(
      refused("path: {polyline: {corners: [[-0.6, 0, 0.5], [-0.7, 0, 0.5], [-0.7, 0.1, 0.5]], speed: 0.5, "
              "blend: 0.001}}\norientation: {along_path: [0, 0, -1]}\n")
          .what(),
      HasSubstr("round the path more"));
  const std::string fixed = kCircle + "orientation: {rpy_deg: [180, 0, 0]}\n";
  EXPECT_THAT(refused(fixed + "target_camera: {noise: 0.001, bandwidth: 15}\n"),
              refused_at({.line = 7, .key = "target_camera", .limit = "no camera"}));
  EXPECT_THAT(refused(fixed + "stimulus: {on: target, step: {offset: [0.01, 0, 0], at: 8}}\n"),
              refused_at({.line = 7, .key = "stimulus", .limit = "on: path"}));
}

}  // namespace orientation_file_test
}  // namespace armtune::internal
