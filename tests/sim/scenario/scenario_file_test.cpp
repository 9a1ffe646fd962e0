// Scenario files: their keys, base files and other files, and mistakes in them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/robot/theta.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/core/support/urdf_text.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace scenario_file_test {

using test::refused_at;

class ScenarioFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const { return folder_.write("own.yaml", text); }
  Scenario load(const std::string& text) const { return load_scenario(write(text)); }
  /// The error in this file with which this text, on top of moving_target, is refused.
  InputError refused(const std::string& text) const {
    const std::string path = write("base: moving_target\n" + text);
    const InputError error = test::input_error([&] { load_scenario(path); });
    EXPECT_EQ(error.place().file, path);
    return error;
  }

  const test::TemporaryFolder folder_;
};

TEST_F(ScenarioFile, ObstaclesHaveBodiesAndCanBeKeptOffLinks) {
  const std::string ball = "obstacles: [{name: ball, hold: [1, 0, 1], radius: 0.2}]\n";
  const Scenario joints = load("base: moving_target\n" + ball);
  ASSERT_EQ(joints.obstacles.size(), 1U);
  EXPECT_EQ(joints.obstacles[0].radius, 0.2);
  EXPECT_EQ(joints.robot->chain.link_radius.size(), 0);
  const Scenario links = load("base: moving_target\nobstacle_distance: links\n" + ball);
  EXPECT_EQ(links.robot->chain.link_radius, joints.robot->link_radii);
  EXPECT_EQ(load("base: moving_target\nobstacle_distance: joints\n").robot->chain.link_radius.size(), 0);
  EXPECT_THAT(
      refused("obstacle_distance: arms\n"),
      refused_at({.line = 2, .key = "obstacle_distance", .value = "arms", .limit = "joints or links"}));
  EXPECT_THAT(refused("obstacles: [{name: ball, hold: [1, 0, 1], radius: -0.2}]\n"),
              refused_at({.line = 2, .key = "obstacles/0/radius", .value = "-0.2", .limit = "0 to 100"}));
}

TEST_F(ScenarioFile, AScheduleNamesItsTargets) {
  const Scenario s = load(
      "base: target_switch\nswitch_every: 0\nschedule: [{at: 3, target: green}, {at: 5, target: red}]\n");
  ASSERT_EQ(s.schedule.size(), 2U);
  EXPECT_EQ(s.targets[s.active_target(4.0)].name, "green");
  EXPECT_EQ(s.targets[s.active_target(6.0)].name, "red");
  const auto refused_schedule = [&](const std::string& schedule, const std::string& every = "0") {
    return test::input_error(
        [&] { load("base: target_switch\nswitch_every: " + every + "\nschedule: " + schedule + "\n"); });
  };
  EXPECT_THAT(
      refused_schedule("[{at: 3, target: gren}]"),
      refused_at({.line = 3, .key = "schedule/0/target", .value = "gren", .limit = "one of: red, green"}));
  EXPECT_THAT(refused_schedule("[{at: 0, target: green}]"),
              refused_at({.line = 3, .key = "schedule/0/at", .value = "0", .limit = "above 0"}));
  EXPECT_THAT(refused_schedule("[{at: 3, target: green}, {at: 3, target: red}]"),
              refused_at({.line = 3, .key = "schedule/1/at", .value = "3", .limit = "above 3"}));
  EXPECT_THAT(refused_schedule("[{at: 3, target: red}]"),
              refused_at({.line = 3, .key = "schedule/0/target", .value = "red", .limit = "another target"}));
  EXPECT_TRUE(load("base: target_switch\nschedule: []\n").schedule.empty()) << "over a base's";
  EXPECT_THAT(refused_schedule("[{at: 3, target: green}]", "8"),
              refused_at({.line = 3, .key = "schedule", .limit = "no switch_every"}));
}

TEST_F(ScenarioFile, ItsOwnKeysReplaceThoseOfItsBasesWhole) {
  folder_.write("first.yaml", "duration: 3\nseed: 5\nplant: {position_noise: 1}\n");
  folder_.write("second.yaml", "duration: 4\nplant: {velocity_noise: 2}\n");
  const Scenario s = load("base: [moving_target, first.yaml, second.yaml]\nswitch_every: 1\n");
  EXPECT_EQ(s.name, "own");
  EXPECT_EQ(s.duration, 4.0) << "the last base that has it";
  EXPECT_EQ(s.seed, 5U);
  EXPECT_EQ(s.plant.velocity_noise, 2.0);
  EXPECT_EQ(s.plant.position_noise, 0.0) << "a key is replaced whole";
  EXPECT_EQ(s.switch_every, 1.0);
  EXPECT_EQ(s.targets.size(), 1U);
}

TEST_F(ScenarioFile, ThetaStartsAtAMultipleOfTheModelOrAtAFile) {
  const Scenario scaled = load("base: moving_target\ntheta_start: {model_scale: 0.3}\n");
  const ParameterVector model = theta_of(scaled.robot->chain);
  EXPECT_LT((start_theta(scaled) - 0.3 * model).norm(), 1e-15 * model.norm());
  EXPECT_TRUE(start_theta(load_scenario("moving_target")).isZero(0.0));

  const auto names = theta_names(*scaled.robot);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += names[i] + ": " + std::to_string(i) + "\n";
  folder_.write("theta.yaml", text);
  const ParameterVector theta = start_theta(load("base: moving_target\ntheta_start: {file: theta.yaml}\n"));
  for (Eigen::Index i = 0; i < theta.size(); ++i) EXPECT_EQ(theta[i], static_cast<double>(i));

  folder_.write("theta.yaml", text + "no_such_link/mass: 1\n");
  EXPECT_THAT([&] { load("base: moving_target\ntheta_start: {file: theta.yaml}\n"); },
              refused_at({.file = folder_ / "theta.yaml",
                          .line = static_cast<long>(names.size()) + 1,
                          .key = "no_such_link/mass",
                          .value = "no_such_link/mass"}));
}

TEST_F(ScenarioFile, ItsFilesAreReadWithItAndNotAgainWhenARolloutBegins) {
  const auto names = theta_names(*load_scenario("moving_target").robot);
  std::string text;
  for (const std::string& name : names) text += name + ": 0.25\n";
  folder_.write("theta.yaml", text);
  const Scenario scenario = load("base: moving_target\ntheta_start: {file: theta.yaml}\n");
  std::filesystem::remove(folder_ / "theta.yaml");
  EXPECT_EQ(start_theta(scenario), ParameterVector::Constant(static_cast<Eigen::Index>(names.size()), 0.25));
}

TEST_F(ScenarioFile, AFileAboveASymbolicLinkIsTheOneThatTheSystemFinds) {
  // from/scenario.yaml names ../theta.yaml; from is a link to real/from.
  std::filesystem::create_directories(folder_ / "real/from");
  std::filesystem::create_directory_symlink(folder_ / "real/from", folder_ / "from");
  std::string text;
  for (const std::string& name : theta_names(*load_scenario("moving_target").robot)) text += name + ": 0.5\n";
  folder_.write("real/theta.yaml", text);
  folder_.write("theta.yaml", "nobody: means this one\n");
  folder_.write("from/scenario.yaml", "base: moving_target\ntheta_start: {file: ../theta.yaml}\n");
  EXPECT_EQ(start_theta(load_scenario(folder_ / "from/scenario.yaml"))[0], 0.5);
}

TEST_F(ScenarioFile, FilesThatABaseNamesAreFoundFromThatBasesFolder) {
  std::filesystem::create_directory(folder_.path() + "/below");
  const auto names = theta_names(*load_scenario("moving_target").robot);
  std::string text;
  for (const std::string& name : names) text += name + ": 0.25\n";
  folder_.write("below/theta.yaml", text);
  folder_.write("below/first.yaml", "base: moving_target\ntheta_start: {file: theta.yaml}\n");
  EXPECT_EQ(start_theta(load("base: below/first.yaml\n")).maxCoeff(), 0.25);
}

TEST_F(ScenarioFile, ACameraSeesTheTargetsOnlyWhereOneStands) {
  EXPECT_FALSE(load_scenario("realistic_moving_target").camera.has_value());
  const auto camera = load_scenario("realistic_camera_target").camera;
  ASSERT_TRUE(camera.has_value());
  EXPECT_EQ(camera->noise, 0.001);
  EXPECT_EQ(camera->bandwidth, 15.0);
}

TEST_F(ScenarioFile, TheTaskIsTheMostThatTheJointsCanHoldUnlessItSaysLess) {
  EXPECT_EQ(load_scenario("moving_target").mask, TaskMask::kPose);
  EXPECT_EQ(load("base: moving_target\ntask_mask: position\n").mask, TaskMask::kPosition);
  EXPECT_THAT(refused("task_mask: sideways\n"),
              refused_at({.line = 2,
                          .key = "task_mask",
                          .value = "sideways",
                          .limit = "one of: pose, position_and_axis, position"}));
  for (int n = 2; n <= 7; ++n) {
    std::string inside = test::link("l0", "");
    for (int i = 1; i <= n; ++i) {
      inside +=
          test::link(fmt::format("l{}", i)) +
          test::joint(fmt::format("j{}", i), "revolute", fmt::format("l{}", i - 1), fmt::format("l{}", i));
    }
    folder_.write("arm.urdf", test::robot(inside));
    const std::string of_arm = fmt::format("base: moving_target\nrobot: arm.urdf\nstart_position_deg: [{}]\n",
                                           fmt::join(std::vector<int>(static_cast<std::size_t>(n), 0), ", "));
    EXPECT_EQ(load(of_arm).mask, largest_mask(n)) << n;
    const std::string path = write(of_arm + "task_mask: pose\n");
    const InputError error = test::input_error([&] { load_scenario(path); });
    if (n < 6) {
      const std::string most = n == 2 ? "no task_mask" : fmt::format("at most {}", name(largest_mask(n)));
      EXPECT_THAT(error,
                  refused_at({.file = path, .line = 4, .key = "task_mask", .value = "pose", .limit = most}))
          << n;
    } else {
      EXPECT_STREQ(error.what(), "nothing was refused");
    }
  }
  EXPECT_EQ(components(largest_mask(3)), 3);
  EXPECT_EQ(components(largest_mask(5)), 5);
}

TEST_F(ScenarioFile, MistakesAreRefusedWithTheirLine) {
  EXPECT_THAT(
      refused("duration: -1\n"),
      refused_at(
          {.line = 2, .key = "duration", .value = "-1", .limit = "1 to 1e+08 control periods of 0.002 s"}));
  EXPECT_THAT(refused("duration: 0.001\n"), refused_at({.line = 2,
                                                        .key = "duration",
                                                        .value = "0.001",
                                                        .limit = "1 to 1e+08 control periods of 0.002 s"}));
  EXPECT_THAT(refused("duration: long\n"),
              refused_at({.line = 2,
                          .key = "duration",
                          .value = "long",
                          .limit = "a decimal number with '.' and no unit, such as -1.5 or 1e3"}));
  EXPECT_THAT(refused("control_period: 1\n"),
              refused_at({.line = 2, .key = "control_period", .value = "1", .limit = "1e-5 to 0.1 s"}));
  EXPECT_THAT(refused("dration: 3\n"),
              refused_at({.line = 2,
                          .key = "dration",
                          .value = "dration",
                          .limit = testing::StartsWith(
                              "the keys: base, description, robot, control_period, planned,")}));
  EXPECT_EQ(test::suggested_by(refused("dration: 3\n")), "duration");
  EXPECT_THAT(refused("start_position_deg: [0, 0]\n"),
              refused_at({.line = 2, .key = "start_position_deg", .value = "2", .limit = "6 numbers"}));
  EXPECT_THAT(
      refused("start_position_deg: [0, -90, 400, 0, 0, 0]\n"),
      refused_at(
          {.line = 2, .key = "start_position_deg", .value = "6.98132", .limit = "-3.14159 to 3.14159"}));
  EXPECT_THAT(refused("targets: []\n"),
              refused_at({.line = 2, .key = "targets", .limit = "at least one target"}));
  EXPECT_THAT(refused("targets:\n  - {name: a, center: [0, 0]}\n"),
              refused_at({.line = 3, .key = "targets/0/center", .value = "2", .limit = "3 numbers"}));
  EXPECT_THAT(refused("targets:\n  - {center: [0, 0, 0]}\n"),
              refused_at({.line = 3, .key = "targets/0", .limit = "the key 'name'"}));
  EXPECT_THAT(refused("path:\n  center: [0, 0, 0]\n  terms:\n    - {order: -1}\n"),
              refused_at({.line = 5, .key = "path/terms/0/order", .value = "-1", .limit = "0 .. 1000"}));
  EXPECT_THAT(refused("switch_every: -8\n"),
              refused_at({.line = 2, .key = "switch_every", .value = "-8", .limit = "at least 0"}));
  EXPECT_THAT(refused("seed: -8\n"),
              refused_at({.line = 2, .key = "seed", .value = "-8", .limit = "not negative"}));
  EXPECT_THAT(refused("theta_start: {}\n"),
              refused_at({.line = 2, .key = "theta_start", .limit = "file or model_scale"}));
  EXPECT_THAT(refused("theta_start: {model_scale: 1, file: a.yaml}\n"),
              refused_at({.line = 2, .key = "theta_start", .limit = "file or model_scale"}));
  EXPECT_THAT(refused("plant: {position_noise: -1}\n"),
              refused_at({.line = 2, .key = "plant/position_noise", .value = "-1", .limit = "at least 0"}));
  EXPECT_THAT(refused("plant: {torque_delay_periods: 1.5}\n"),
              refused_at({.line = 2,
                          .key = "plant/torque_delay_periods",
                          .value = "1.5",
                          .limit = "decimal digits only, without point, exponent or unit"}));
  EXPECT_THAT(
      refused("plant: {torque_delay_periods: -1}\n"),
      refused_at({.line = 2, .key = "plant/torque_delay_periods", .value = "-1", .limit = "0 .. 1000"}));
  EXPECT_THAT(refused("plant: {payload: {mass: -1}}\n"),
              refused_at({.line = 2, .key = "plant/payload/mass", .value = "-1", .limit = "at least 0"}));
  EXPECT_THAT(refused("plant: {viscous_friction: [1, 1, 1, 1, 1, -1]}\n"),
              refused_at({.line = 2, .key = "plant/viscous_friction", .value = "-1", .limit = "0 or more"}));
}

TEST_F(ScenarioFile, ABaseThatIsNotThereOrNeverEndsIsRefused) {
  const std::string path = write("base: moving_targett\n");
  const InputError misspelt = test::input_error([&] { load_scenario(path); });
  EXPECT_THAT(misspelt, refused_at({.value = "moving_targett"}));
  EXPECT_EQ(test::suggested_by(misspelt), "moving_target");
  write("base: own.yaml\n");
  EXPECT_THAT([&] { load_scenario(path); },
              refused_at({.file = path, .line = 1, .key = "base", .limit = "at most 16 base files"}));
}

}  // namespace scenario_file_test
}  // namespace armtune::internal
