#include "sim/scenario/scenario.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "core/robot/theta.hpp"

namespace armtune::internal {
namespace scenario_test {

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

}  // namespace scenario_test
}  // namespace armtune::internal
