#include "sim/scenario/scenario.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>

#include "core/robot/theta.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/core/support/urdf_text.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace scenario_test {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kPi = 3.14159265358979323846;

// The published formulas, written out. Targets and obstacles in the URDF's base frame; the circle in the
// controller's, which is turned by pi about z.
Vec3 circle(double t, double period) {
  const double w = 2.0 * kPi / period;
  const double r = 0.12;
  const Vec3 controller(0.65 + r * std::sin(w * t), 0.08 + r * std::cos(w * t) - r, 0.5);
  return {-controller.x(), -controller.y(), controller.z()};
}

Vec3 target(double a, double b, double c, double X, double Y, double w, double t) {
  const double x =
      a * a * std::cos(a * w * t) + b * b / 2 * std::cos(b * w * t) - c * c / 3 * std::sin(c * w * t);
  const double y =
      -a * a * std::sin(a * w * t) - b * b / 2 * std::sin(b * w * t) + c * c / 3 * std::cos(c * w * t);
  return {-0.6 + X * x, Y * y, 0.0};
}
Vec3 red(double t) {
  return target(1, 2, 1, 0.0555607, 0.0547536, 0.6682049, t);
}
Vec3 green(double t) {
  return target(2, 0, 1, 0.0359850, 0.0353990, 0.5250913, t);
}

Vec3 obstacle_1(double t) {
  const double u = 2.0 * kPi / 10.0;
  return {-0.5, 0.2582 + 0.2 * std::sin(u * t), 1.28 + 0.4 * std::cos(u * t)};
}
Vec3 obstacle_2(double t) {
  const double p = 0.1837437 * t;
  return {0.7 + 0.0984900 * (4 * std::sin(2 * p) + 0.5 * std::sin(p) - 4.0 / 3 * std::cos(2 * p)),
          -0.1 + 0.0998475 * (4 * std::cos(2 * p) + 0.5 * std::cos(p) - 4.0 / 3 * std::sin(2 * p)), 0.6};
}
Vec3 obstacle_3(double t) {
  const double p = 0.2310780 * t;
  return {-1.0 + 0.1096565 * (std::sin(p) + 2 * std::sin(2 * p)),
          -0.2 + 0.1185185 * (std::cos(p) - 2 * std::cos(2 * p)), 0.6 - 0.2193130 * std::sin(3 * p)};
}

/// The file's path against a formula, and its velocity against the formula's finite difference.
void expect_path(const Path& path, const std::function<Vec3(double)>& formula, const std::string& what) {
  constexpr double h = 1e-5;
  for (double t = 0.0; t < 60.0; t += 0.37) {
    const MotionPoint<Vec3> point = path.at(t);
    EXPECT_LT((point.position - formula(t)).norm(), 1e-9) << what << " at " << t;
    EXPECT_LT((point.velocity - (formula(t + h) - formula(t - h)) / (2 * h)).norm(), 1e-8)
        << what << " at " << t;
  }
}

TEST(BundledScenario, PathsAreThePublishedFormulas) {
  const Scenario moving = load_scenario("moving_target");
  expect_path(
      moving.path, [](double t) { return circle(t, 10.0); }, "circle of 10 s");
  ASSERT_EQ(moving.targets.size(), 1U);
  expect_path(moving.targets[0].path, red, "red");

  const Scenario fixed = load_scenario("fixed_target");
  ASSERT_EQ(fixed.targets.size(), 1U);
  expect_path(
      fixed.targets[0].path, [](double) { return red(0.0); }, "red at rest");

  const Scenario turns = load_scenario("target_switch");
  ASSERT_EQ(turns.targets.size(), 2U);
  expect_path(turns.targets[0].path, red, "red");
  expect_path(turns.targets[1].path, green, "green");

  const Scenario pass = load_scenario("obstacle_pass");
  expect_path(
      pass.path, [](double t) { return circle(t, 15.0); }, "circle of 15 s");
  expect_path(pass.targets.at(0).path, red, "red");
  ASSERT_EQ(pass.obstacles.size(), 3U);
  expect_path(pass.obstacles[0].path, obstacle_1, "obstacle 1");
  expect_path(pass.obstacles[1].path, obstacle_2, "obstacle 2");
  expect_path(pass.obstacles[2].path, obstacle_3, "obstacle 3");
}

TEST(BundledScenario, LengthsAndStartsOfThetaAreAsPublished) {
  const auto check = [](const char* name, double duration, double scale, std::size_t obstacles) {
    const Scenario plain = load_scenario(name);
    EXPECT_EQ(plain.duration, duration) << name;
    EXPECT_EQ(plain.control_period, 0.002) << name;
    EXPECT_EQ(plain.theta.model_scale, scale) << name;
    EXPECT_EQ(plain.obstacles.size(), obstacles) << name;
    EXPECT_EQ(plain.plant.position_noise, 0.0);
    EXPECT_EQ(plain.plant.payload.mass, 0.0);
    EXPECT_EQ(plain.plant.torque_delay_periods, 0);
    const JointVector degrees = plain.start_position * 180.0 / kPi;
    JointVector expected(6);
    expected << 0, -90, 0, -90, 0, 0;
    EXPECT_LT((degrees - expected).norm(), 1e-12) << name;
  };
  check("fixed_target", 40.0, 0.0, 0);
  check("moving_target", 40.0, 0.0, 0);
  check("target_switch", 40.0, 1.0, 0);
  check("obstacle_pass", 60.0, 1.0, 3);
}

TEST(BundledScenario, RealisticVariantsAreTheSameWithARealArm) {
  for (const std::string name : {"fixed_target", "moving_target", "target_switch", "obstacle_pass"}) {
    const Scenario plain = load_scenario(name);
    const Scenario real = load_scenario("realistic_" + name);
    EXPECT_EQ(real.name, "realistic_" + name);
    EXPECT_EQ(real.duration, plain.duration);
    EXPECT_EQ(real.switch_every, plain.switch_every);
    EXPECT_EQ(real.targets.size(), plain.targets.size());
    EXPECT_EQ(real.obstacles.size(), plain.obstacles.size());
    EXPECT_EQ(real.path.at(3.0).position, plain.path.at(3.0).position);
    EXPECT_EQ(real.theta.model_scale, 0.8);
    EXPECT_EQ(real.plant.position_noise, 1e-4);
    EXPECT_EQ(real.plant.velocity_noise, 0.01);
    EXPECT_EQ(real.plant.torque_delay_periods, 1);
    EXPECT_EQ(real.plant.payload.mass, 1.0);
    JointVector friction(6);
    friction << 4, 4, 2.5, 0.75, 0.75, 0.5;
    EXPECT_EQ(real.plant.viscous_friction, friction);
    EXPECT_EQ(real.plant.coulomb_friction, friction);
    const RobotModel plant = plant_model(real);
    EXPECT_EQ(plant.chain.viscous_friction, friction);
    EXPECT_NEAR(plant.chain.link[5].mass, real.robot->chain.link[5].mass + 1.0, 1e-12);
    EXPECT_TRUE(real.robot->chain.viscous_friction.isZero(0.0)) << "the controller does not know";
  }
}

TEST(Scenario, TargetsTakeTurns) {
  const Scenario s = load_scenario("target_switch");
  for (int k = 0; k < s.periods(); ++k) {
    const auto expected = static_cast<std::size_t>(k / 4000 % 2);  // 8 s of 2 ms
    ASSERT_EQ(s.active_target(k * s.control_period), expected) << "period " << k;
  }
  EXPECT_EQ(load_scenario("moving_target").active_target(39.0), 0U);
}

class ScenarioFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const { return folder_.write("own.yaml", text); }
  Scenario load(const std::string& text) const { return load_scenario(write(text)); }
  /// Message with which this text, on top of moving_target, is refused; it begins with the file.
  std::string refused(const std::string& text) const {
    const std::string path = write("base: moving_target\n" + text);
    const std::string message = test::refusal([&] { load_scenario(path); });
    EXPECT_THAT(message, testing::StartsWith(path));
    return message;
  }

  const test::TemporaryFolder folder_;
};

TEST(Scenario, TargetsFollowTheirSchedule) {
  Scenario s;
  s.control_period = 0.002;
  s.duration = 20.0;
  s.targets.resize(3);
  s.schedule = {{2.0, 1}, {5.0, 2}, {9.0, 0}};
  const std::vector<std::pair<double, std::size_t>> expected = {{0.0, 0}, {1.998, 0}, {2.0, 1}, {4.99, 1},
                                                                {5.0, 2}, {8.99, 2},  {9.0, 0}, {100.0, 0}};
  for (const auto& [t, target] : expected) EXPECT_EQ(s.active_target(t), target) << t;
  EXPECT_EQ(s.next_switch(0.0), 2.0);
  EXPECT_EQ(s.next_switch(2.0), 5.0);
  EXPECT_EQ(s.next_switch(8.0), 9.0);
  EXPECT_EQ(s.next_switch(9.0), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(s.switches_target());
  s.schedule.clear();
  EXPECT_EQ(s.next_switch(0.0), std::numeric_limits<double>::infinity());
  s.switch_every = 4.0;
  EXPECT_EQ(s.next_switch(0.0), 4.0);
  EXPECT_EQ(s.next_switch(4.0), 8.0);
  EXPECT_EQ(s.next_switch(7.9), 8.0);
}

TEST_F(ScenarioFile, ObstaclesHaveBodiesAndCanBeKeptOffLinks) {
  const std::string ball = "obstacles: [{name: ball, hold: [1, 0, 1], radius: 0.2}]\n";
  const Scenario joints = load("base: moving_target\n" + ball);
  ASSERT_EQ(joints.obstacles.size(), 1U);
  EXPECT_EQ(joints.obstacles[0].radius, 0.2);
  EXPECT_EQ(joints.robot->chain.link_radius.size(), 0);
  const Scenario links = load("base: moving_target\nobstacle_distance: links\n" + ball);
  EXPECT_EQ(links.robot->chain.link_radius, joints.robot->link_radii);
  EXPECT_EQ(load("base: moving_target\nobstacle_distance: joints\n").robot->chain.link_radius.size(), 0);
  EXPECT_THAT(refused("obstacle_distance: arms\n"),
              AllOf(HasSubstr("own.yaml:2:"), HasSubstr("joints nor links")));
  EXPECT_THAT(refused("obstacles: [{name: ball, hold: [1, 0, 1], radius: -0.2}]\n"),
              AllOf(HasSubstr("own.yaml:2:"), HasSubstr("radius")));
}

TEST_F(ScenarioFile, AScheduleNamesItsTargets) {
  const Scenario s = load(
      "base: target_switch\nswitch_every: 0\nschedule: [{at: 3, target: green}, {at: 5, target: red}]\n");
  ASSERT_EQ(s.schedule.size(), 2U);
  EXPECT_EQ(s.targets[s.active_target(4.0)].name, "green");
  EXPECT_EQ(s.targets[s.active_target(6.0)].name, "red");
  const auto refused_schedule = [&](const std::string& schedule, const std::string& every = "0") {
    return test::refusal(
        [&] { load("base: target_switch\nswitch_every: " + every + "\nschedule: " + schedule + "\n"); });
  };
  EXPECT_THAT(refused_schedule("[{at: 3, target: gren}]"),
              AllOf(HasSubstr("'gren' is not a target"), HasSubstr("green")));
  EXPECT_THAT(refused_schedule("[{at: 0, target: green}]"), HasSubstr("above zero"));
  EXPECT_THAT(refused_schedule("[{at: 3, target: green}, {at: 3, target: red}]"), HasSubstr("increase"));
  EXPECT_THAT(refused_schedule("[{at: 3, target: red}]"), HasSubstr("already at red"));
  EXPECT_TRUE(load("base: target_switch\nschedule: []\n").schedule.empty()) << "over a base's";
  EXPECT_THAT(refused_schedule("[{at: 3, target: green}]", "8"), HasSubstr("switch_every"));
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
  EXPECT_THAT(
      test::refusal([&] { start_theta(load("base: moving_target\ntheta_start: {file: theta.yaml}\n")); }),
      AllOf(HasSubstr("theta.yaml"), HasSubstr("no_such_link/mass")));
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
              AllOf(HasSubstr("own.yaml:2:"), HasSubstr("pose, position_and_axis, position")));
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
    const std::string message = test::refusal([&] { load_scenario(path); });
    if (n == 2) {  // not even for position
      EXPECT_THAT(message, AllOf(HasSubstr("needs 6 joints"), HasSubstr("the arm has 2"),
                                 HasSubstr("leave the key 'task_mask' out"),
                                 testing::Not(HasSubstr("largest possible"))));
    } else if (n < 6) {
      EXPECT_THAT(message, AllOf(HasSubstr("own.yaml:4:"), HasSubstr("needs 6 joints"),
                                 HasSubstr(name(largest_mask(n)))));
    } else {
      EXPECT_EQ(message, "nothing was refused");
    }
  }
  EXPECT_EQ(components(largest_mask(3)), 3);
  EXPECT_EQ(components(largest_mask(5)), 5);
}

TEST_F(ScenarioFile, MistakesAreRefusedWithTheirLine) {
  EXPECT_THAT(refused("duration: -1\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("duration")));
  EXPECT_THAT(refused("duration: 0.001\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("control periods")));
  EXPECT_THAT(refused("duration: long\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("number")));
  EXPECT_THAT(refused("control_period: 1\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("1e-5")));
  EXPECT_THAT(refused("dration: 3\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("did you mean 'duration'")));
  EXPECT_THAT(refused("start_position_deg: [0, 0]\n"),
              AllOf(HasSubstr("own.yaml:2:"), HasSubstr("expected 6")));
  EXPECT_THAT(refused("start_position_deg: [0, -90, 400, 0, 0, 0]\n"),
              AllOf(HasSubstr("own.yaml:2:"), HasSubstr("elbow_joint"), HasSubstr("limits")));
  EXPECT_THAT(refused("targets: []\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("target")));
  EXPECT_THAT(refused("targets:\n  - {name: a, center: [0, 0]}\n"),
              AllOf(HasSubstr("own.yaml:3:"), HasSubstr("targets/0/center")));
  EXPECT_THAT(refused("targets:\n  - {center: [0, 0, 0]}\n"), HasSubstr("missing key 'name'"));
  EXPECT_THAT(refused("path:\n  center: [0, 0, 0]\n  terms:\n    - {order: -1}\n"),
              AllOf(HasSubstr("own.yaml:5:"), HasSubstr("order is -1")));
  EXPECT_THAT(refused("switch_every: -8\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("switch_every")));
  EXPECT_THAT(refused("seed: -8\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("seed")));
  EXPECT_THAT(refused("theta_start: {}\n"), AllOf(HasSubstr("own.yaml:2:"), HasSubstr("model_scale")));
  EXPECT_THAT(refused("theta_start: {model_scale: 1, file: a.yaml}\n"), HasSubstr("give either file or"));
  EXPECT_THAT(refused("plant: {position_noise: -1}\n"),
              AllOf(HasSubstr("own.yaml:2:"), HasSubstr("position_noise")));
  EXPECT_THAT(refused("plant: {torque_delay_periods: 1.5}\n"), HasSubstr("torque_delay_periods"));
  EXPECT_THAT(refused("plant: {torque_delay_periods: -1}\n"), HasSubstr("torque_delay_periods"));
  EXPECT_THAT(refused("plant: {payload: {mass: -1}}\n"), HasSubstr("mass"));
  EXPECT_THAT(refused("plant: {viscous_friction: [1, 1, 1, 1, 1, -1]}\n"), HasSubstr("negative"));
}

TEST_F(ScenarioFile, ABaseThatIsNotThereOrNeverEndsIsRefused) {
  const std::string path = write("base: moving_targett\n");
  EXPECT_THAT(test::refusal([&] { load_scenario(path); }), HasSubstr("did you mean 'moving_target'"));
  write("base: own.yaml\n");
  EXPECT_THAT(test::refusal([&] { load_scenario(path); }), AllOf(HasSubstr("own.yaml"), HasSubstr("base")));
}

}  // namespace scenario_test
}  // namespace armtune::internal
