// The whole command of joint_trajectory_controller against test vectors that were derived from the source of
// ROS, for Jazzy by someone who had not seen this code. The files in data/ say how.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "core/control/laws/controller.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/ros_distro.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/one_joint.hpp"
#include "tests/core/support/source_dir.hpp"

namespace armtune::internal {
namespace jtc_vectors_test {

struct Step {
  double time = 0.0, q = 0.0, qd = 0.0, command = 0.0;
};
struct Case {
  std::string name;
  double period = 0.0;
  double p = 0.0, i = 0.0, d = 0.0, i_clamp = 0.0, u_max = 0.0, u_min = 0.0, ff = 0.0;
  std::string distro = "jazzy";
  bool velocity = false;     ///< the command is a velocity, not an effort
  double i_clamp_min = 0.0;  ///< 0: -i_clamp
  double wraparound = 0.0;
  std::string strategy;
  double tracking_time = 0.0, deadband = 0.0;
  int continuous = 0;
  PointsGive given = PointsGive::kPositions;
  std::vector<double> time;
  std::vector<MotionPoint<JointVector>> points;
  std::vector<Step> steps;
};

JointVector one(double x) {
  return JointVector::Constant(1, x);
}

double number(std::istringstream& words) {
  std::string text;
  words >> text;
  return std::stod(text);  // reads "inf" as well
}

void read_line(const std::string& word, std::istringstream& words, Case& c) {
  if (word == "period") c.period = number(words);
  if (word == "gains") {
    for (double* value : {&c.p, &c.i, &c.d, &c.i_clamp, &c.u_max, &c.u_min, &c.ff}) *value = number(words);
  }
  if (word == "windup") {
    words >> c.strategy;
    c.tracking_time = number(words);
    c.deadband = number(words);
  }
  if (word == "distro") words >> c.distro;
  if (word == "interface") {
    std::string interface;
    words >> interface;
    c.velocity = interface == "velocity";
  }
  if (word == "i_clamp_min") c.i_clamp_min = number(words);
  if (word == "wraparound") c.wraparound = number(words);
  if (word == "continuous") words >> c.continuous;
  if (word == "points") {
    std::string kind;
    words >> kind;
    c.given = kind == "positions"    ? PointsGive::kPositions
              : kind == "velocities" ? PointsGive::kVelocities
                                     : PointsGive::kAccelerations;
  }
  if (word == "point") {
    c.time.push_back(number(words));
    MotionPoint<JointVector> point{one(number(words)), one(0.0), one(0.0)};
    if (c.given != PointsGive::kPositions) point.velocity = one(number(words));
    if (c.given == PointsGive::kAccelerations) point.acceleration = one(number(words));
    c.points.push_back(point);
  }
  if (word == "step") {
    Step step;
    for (double* value : {&step.time, &step.q, &step.qd, &step.command}) *value = number(words);
    c.steps.push_back(step);
  }
}

std::vector<Case> cases(const std::string& name) {
  std::ifstream file(test::source_dir() + "/tests/core/control/laws/data/" + name);
  std::vector<Case> all;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word[0] == '#') continue;
    if (word == "case") {
      all.emplace_back();
      words >> all.back().name;
    } else {
      read_line(word, words, all.back());
    }
    EXPECT_FALSE(words.fail()) << line;
  }
  return all;
}

/// The gains of a case, as the reader of parameter files gives them to the law.
Gains gains_of(const Case& c) {
  constexpr double kNoClamp = 1e6;
  static const std::map<std::string, double> kStrategies = {{"contribution", 0.0},
                                                            {"integral", 1.0},
                                                            {"legacy", 1.0},
                                                            {"none", 2.0},
                                                            {"conditional_integration", 3.0},
                                                            {"back_calculation", 4.0}};
  Gains gains =
      test::one_joint_gains(c.velocity ? kJointTrajectoryVelocityController : kJointTrajectoryController);
  const auto set = [&gains](const char* name, double value) { jtc_gain(gains, name)[0] = value; };
  set("p", c.p);
  set("i", c.i);
  set("d", c.d);
  set("i_clamp", std::min(c.i_clamp, kNoClamp));
  set("u_clamp_max", std::min(c.u_max, kNoClamp));
  set("u_clamp_min", std::min(-c.u_min, kNoClamp));
  set("ff_velocity_scale", c.ff);
  set("antiwindup", kStrategies.at(c.strategy));
  set("tracking_time", c.tracking_time);
  set("error_deadband", c.deadband);
  set("i_clamp_min", -c.i_clamp_min);
  set("angle_wraparound", c.wraparound);
  set("distro", static_cast<double>(distro_from_name(c.distro).value()));
  return gains;
}

/// Makes the torque of the joint's drive the difference between the commanded and the present velocity.
void show_command(RobotModel& model) {
  model.chain.gravity.setZero();
  model.joints[0].limits.velocity = 1e9;
  model.drive_velocity_gain = one(1.0);
  model.drive_velocity_integral = one(0.0);
}

/// The commands of armtune's law at the steps of a case.
std::vector<double> commands(const Case& c) {
  RobotModel model = test::pendulum();
  model.joints[0].limits.has_position = c.continuous == 0;
  model.joints[0].limits.effort = 1e9;  // the command itself is looked at
  if (c.velocity) show_command(model);
  const auto arm = std::make_shared<const RobotModel>(model);
  Controller controller(arm, gains_of(c), theta_of(arm->chain), c.period, TaskMask::kPosition);
  const JointSpline plan(c.time, c.points, c.given);
  Path path;
  Scene scene;
  scene.path = &path;
  scene.plan = &plan;
  scene.holds_plan = true;
  std::vector<double> all;
  for (const Step& step : c.steps) {
    const double torque = controller.update({one(step.q), one(step.qd)}, scene, step.time).commanded[0];
    all.push_back(c.velocity ? torque + step.qd : torque);
  }
  return all;
}

void expect_commands(const std::vector<Case>& all) {
  ASSERT_GE(all.size(), 10U);
  for (const Case& c : all) {
    ASSERT_GE(c.steps.size(), 5U) << c.name;
    const std::vector<double> found = commands(c);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Step& step = c.steps[k];
      EXPECT_NEAR(found[k], step.command, 1e-9 * (1.0 + std::abs(step.command)))
          << c.name << ", " << step.time << " s";
    }
  }
}

TEST(JtcVectors, AreThoseOfRosJointTrajectoryController) {
  expect_commands(cases("jtc_command.txt"));
}

TEST(JtcVectors, OfHumbleAndNoeticAreThoseOfTheirJointTrajectoryControllers) {
  expect_commands(cases("jtc_command_distros.txt"));
}

TEST(JtcVectors, OfVelocityCommandsAreThoseOfRosJointTrajectoryController) {
  expect_commands(cases("jtc_velocity_command.txt"));
}

// The vectors tell the distributions apart: under the rules of Jazzy the same gains give other commands, but
// for the cases that only differ in how a file is read.
TEST(JtcVectors, OfOtherDistributionsAreNotThoseOfJazzy) {
  int differ = 0;
  for (const Case& c : cases("jtc_command_distros.txt")) {
    Case jazzy = c;
    jazzy.distro = "jazzy";
    const std::vector<double> own = commands(c), other = commands(jazzy);
    double most = 0.0;
    for (std::size_t k = 0; k < own.size(); ++k) most = std::max(most, std::abs(own[k] - other[k]));
    if (most > 1e-3) ++differ;
  }
  EXPECT_GE(differ, 8);
}

}  // namespace jtc_vectors_test
}  // namespace armtune::internal
