#include "sim/rollout/columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace columns_test {

using Values = std::map<std::string, double>;

/// One period in which no two numbers are the same.
struct Period {
  Period() {
    control.state = ControlState::kFollowPlan;
    control.slerping = true;
    control.torque = JointVector::LinSpaced(6, 10.0, 15.0);
    control.commanded = -3.0 * control.torque;
    control.desired.position = Vec3(0.31, 0.32, 0.33);
    control.desired_gaze.orientation = Eigen::Quaterniond(0.1, 0.3, 0.5, 0.8).normalized();
    control.planned.position = JointVector::LinSpaced(6, -2.0, -1.0);
    control.manipulability = 0.17;
    poses.p_0T = Vec3(0.41, 0.42, 0.43);
    poses.R_0T = Eigen::Quaterniond(0.7, -0.1, 0.4, 0.2).normalized().toRotationMatrix();
    o.time = 1.25;
    o.q = &q;
    o.qd = &qd;
    o.control = &control;
    o.poses = &poses;
    o.target = 3;
    o.target_motion.position = Vec3(1.1, 1.2, 1.3);
    o.error << 0.01, 0.02, 0.03, 0.04, 0.05, 0.06;
    o.error_rate << 0.11, 0.12, 0.13, 0.14, 0.15, 0.16;
    o.gaze_angle = 0.21;
    o.clearance = 0.55;
    o.compensation_error = 7.5;
  }
  JointVector q = JointVector::LinSpaced(6, 0.5, 1.5);
  JointVector qd = JointVector::LinSpaced(6, -0.9, -0.4);
  ControlOutput control;
  Poses poses;
  Observation o;
};

void expect_vector(Values& expected, const std::string& name, const Vec3& v) {
  expected[name + "/x"] = v.x();
  expected[name + "/y"] = v.y();
  expected[name + "/z"] = v.z();
}

void expect_quaternion(Values& expected, const std::string& name, const Eigen::Quaterniond& q) {
  expect_vector(expected, name, q.vec());
  expected[name + "/w"] = q.w();
}

void expect_joints(Values& expected, const Period& p, const RobotModel& robot) {
  for (int i = 0; i < robot.n(); ++i) {
    const JointInfo& joint = robot.joints[static_cast<std::size_t>(i)];
    const std::string tree = "joint/" + joint.name + "/";
    expected[tree + "position"] = p.q[i];
    expected[tree + "velocity"] = p.qd[i];
    expected[tree + "velocity_ratio"] = -p.qd[i] / joint.limits.velocity;
    expected[tree + "torque"] = p.control.torque[i];
    expected[tree + "torque_ratio"] = 3.0 * p.control.torque[i] / joint.limits.effort;
  }
}

TEST(Columns, EachShowsWhatItsNameSays) {
  const Scenario scenario = test::scenario_of("obstacle_pass");
  const Period p;
  Values expected = {{"time", 1.25},           {"state", 4.0},
                     {"slerping", 1.0},        {"gaze/angle", 0.21},
                     {"target/index", 3.0},    {"obstacle/distance", 0.55},
                     {"manipulability", 0.17}, {"compensation_error", 7.5}};
  expect_vector(expected, "tool/position", p.poses.p_0T);
  expect_quaternion(expected, "tool/orientation", Eigen::Quaterniond(p.poses.R_0T));
  expect_vector(expected, "desired/position", p.control.desired.position);
  expect_quaternion(expected, "desired/orientation", p.control.desired_gaze.orientation);
  expect_vector(expected, "error/position", p.o.error.head<3>());
  expect_vector(expected, "error/orientation", p.o.error.tail<3>());
  expect_vector(expected, "error/linear_velocity", p.o.error_rate.head<3>());
  expect_vector(expected, "error/angular_velocity", p.o.error_rate.tail<3>());
  expect_vector(expected, "target/position", p.o.target_motion.position);
  expect_joints(expected, p, *scenario.robot);
  const auto columns = rollout_columns(scenario);
  EXPECT_EQ(columns.size(), expected.size());
  for (const Column& column : columns) {
    ASSERT_TRUE(expected.contains(column.name)) << column.name;
    EXPECT_DOUBLE_EQ(column.value(p.o), expected[column.name]) << column.name;
  }
}

TEST(Columns, APlansAreThoseOfItsJointsWhileItIsFollowed) {
  Scenario scenario = test::scenario_of("moving_target");
  const MotionPoint<JointVector> rest{JointVector::Zero(6), JointVector::Zero(6), JointVector::Zero(6)};
  scenario.planned =
      std::make_shared<const JointSpline>(std::vector<double>{0.0, 1.0}, std::vector{rest, rest});
  Period p;
  Values shown;
  for (const Column& column : rollout_columns(scenario)) shown[column.name] = column.value(p.o);
  p.control.state = ControlState::kFollowTrajectory;
  Values later;
  for (const Column& column : rollout_columns(scenario)) later[column.name] = column.value(p.o);
  for (int i = 0; i < 6; ++i) {
    const std::string tree = "joint/" + scenario.robot->joints[static_cast<std::size_t>(i)].name + "/";
    EXPECT_EQ(shown.at(tree + "planned"), p.control.planned.position[i]);
    EXPECT_DOUBLE_EQ(shown.at(tree + "error"), p.q[i] - p.control.planned.position[i]);
    EXPECT_TRUE(std::isnan(later.at(tree + "planned")));
    EXPECT_TRUE(std::isnan(later.at(tree + "error")));
  }
}

}  // namespace columns_test
}  // namespace armtune::internal
