// Planned motions from tables of the user and from messages of ROS: names and units of their columns.

#include "sim/scenario/planned_motion.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "sim/scenario/scenario.hpp"
#include "tests/sim/support/planned_motion.hpp"

namespace armtune::internal {
namespace motion_tables_test {

using test::PlannedMotion;
using test::refused_at;
using testing::HasSubstr;

TEST_F(PlannedMotion, AUsersTableMayHavePlainNamesOtherUnitsOrNoNames) {
  std::string header = "time";
  for (const JointInfo& joint : robot_->joints) header += ";" + joint.name;
  const std::string rows = "0;0;0;0;0;0;0\n1500;90;0;-45;0;0;0\n";
  folder_.write("moves.csv", header + "\n" + rows);
  const std::string units = "units: {angle: deg, time: ms}";
  const Scenario named = scenario("planned: {file: moves.csv, " + units + "}\nduration: planned\n");
  EXPECT_EQ(named.planned->end(), 1.5);
  EXPECT_DOUBLE_EQ(named.planned->at(1.5).position[0], std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(named.planned->at(1.5).position[2], -std::numbers::pi / 4);
  folder_.write("moves.csv", rows);
  const auto as_they_are = [&] { scenario("planned: moves.csv\nduration: planned\n"); };
  const InputError unnamed = test::input_error(as_they_are);
  EXPECT_THAT(unnamed, refused_at({.file = folder_ / "moves.csv", .line = 1, .limit = "column names"}));
  EXPECT_THAT(unnamed.what(), HasSubstr("planned: {file: \"moves.csv\", columns: [time, shoulder_pan"));
  folder_.write("moves.csv", header + "\n" + rows);
  const InputError degrees = test::input_error(as_they_are);
  EXPECT_THAT(degrees, refused_at({.file = folder_ / "moves.csv",
                                   .line = 3,
                                   .key = "joint/shoulder_pan_joint/position",
                                   .value = "90"}));
  EXPECT_THAT(degrees.what(), HasSubstr("units: {angle: deg}"));
  folder_.write("moves.csv", rows);
  std::string columns = "time";
  for (const JointInfo& joint : robot_->joints) columns += ", " + joint.name;
  EXPECT_EQ(
      scenario("planned: {file: moves.csv, " + units + ", columns: [" + columns + "]}\nduration: planned\n")
          .planned->at(1.5)
          .position,
      named.planned->at(1.5).position);
  EXPECT_THAT([&] { scenario("planned: {file: moves.csv, segments: cubic}\nduration: planned\n"); },
              refused_at({.file = folder_ / "own.yaml",
                          .line = 2,
                          .key = "planned/segments",
                          .value = "cubic",
                          .limit = "as_ros or next_point"}));
}

TEST_F(PlannedMotion, DegreesOfAJointWithoutLimitsAreNamedAndTurnsInRadiansAreNot) {
  RobotModel robot = *robot_;
  robot.joints[0].limits.has_position = false;
  const double limit = robot.joints[0].limits.velocity;
  std::string names = "time";
  for (const JointInfo& joint : robot.joints) names += "," + joint.name;
  // One joint moves by `angle`, rests, and returns, with this mean velocity on the way out.
  const auto refused = [&](double angle, double velocity, double speed = 1.0) {
    const double out = angle / velocity;
    const std::string path =
        write(fmt::format("{}\n0,0,0,0,0,0,0\n{},{},0,0,0,0,0\n{},{},0,0,0,0,0\n{},0,0,0,0,0,0\n", names, out,
                          angle, 2.0 * out, angle, 20.0 * out));
    return test::input_error([&] {
      PlannedFile file{{path}};
      file.speed = speed;
      load_planned_motion(file, robot);
    });
  };
  const double degrees = 180.0 / std::numbers::pi;
  const InputError in_degrees = refused(90.0, 0.3 * limit * degrees);
  EXPECT_THAT(in_degrees, refused_at({.file = folder_ / "plan.csv",
                                      .line = 3,
                                      .key = "joint/shoulder_pan_joint/position",
                                      .value = "90"}));
  EXPECT_THAT(in_degrees.what(), HasSubstr("units: {angle: deg}"));
  EXPECT_STREQ(refused(90.0, 0.3 * limit * degrees, 0.1).what(), "nothing was refused")
      << "a tenth of the speed is honest";
  for (const double turns : {1.0, 20.0, 100.0})
    EXPECT_STREQ(refused(turns * 2.0 * std::numbers::pi, 2.0 * limit).what(), "nothing was refused") << turns;
  EXPECT_STREQ(refused(2.0 * std::numbers::pi, 1000.0 * limit).what(), "nothing was refused")
      << "a wrapped angle";
}

TEST_F(PlannedMotion, TheColumnOfTheTimeMayHaveCapitals) {
  std::string names;
  for (const JointInfo& joint : robot_->joints) names += "," + joint.name;
  const std::string rows = "\n0,0,0,0,0,0,0\n1.5,1,0,0,0,0,0\n";
  const JointSpline expected = load(write("time" + names + rows));
  for (const char* time : {"Time", "TIME", "T", "Time [s]", "Time_From_Start"}) {
    EXPECT_EQ(load(write(time + names + rows)).at(1.0).position, expected.at(1.0).position) << time;
  }
  // Of two columns that could be the time, the one of this name is.
  const std::string both = "T,Time" + names + "\n7,0,0,0,0,0,0,0\n7,1.5,1,0,0,0,0,0\n";
  EXPECT_EQ(load(write(both)).at(1.0).position, expected.at(1.0).position);
}

TEST_F(PlannedMotion, AMessageOfRosIsOne) {
  std::string names = "joint_names: [";
  for (const JointInfo& joint : robot_->joints) names += joint.name + ", ";
  folder_.write("moves.yaml", names.substr(0, names.size() - 2) +
                                  "]\npoints:\n- {positions: [0, 0, 0, 0, 0, 0], time_from_start: {sec: 0}}\n"
                                  "- {positions: [1, 0, 3.0, 0, 0, 0], time_from_start: {sec: 2}}\n");
  const Scenario s = scenario("planned: moves.yaml\nduration: planned\n");
  EXPECT_EQ(s.planned->at(0.5).position[0], 0.25) << "joined by straight lines, as ROS does";
  EXPECT_TRUE(s.start_velocity.isZero(0.0));
  EXPECT_TRUE(s.planned->at(2.0).velocity.isZero(0.0));
  folder_.write("moves.yaml",
                names.substr(0, names.size() - 2) +
                    "]\npoints:\n- {positions: [0, 0, 0, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], "
                    "time_from_start: 0}\n"
                    "- {positions: [1, 0, 3.0, 0, 0, 0], velocities: [0, 0, -9, 0, 0, 0], "
                    "time_from_start: 2}\n");
  EXPECT_THAT([&] { scenario("planned: moves.yaml\nduration: planned\n"); },
              refused_at({.file = folder_ / "moves.yaml",
                          .line = 3,
                          .key = "joint/elbow_joint/position",
                          .limit = "-3.14159 to 3.14159"}));
}

TEST_F(PlannedMotion, OfAMessageTheUnitsAreKnown) {
  std::string names = "joint_names: [";
  for (const JointInfo& joint : robot_->joints) names += joint.name + ", ";
  const auto message = [&](const char* last) {
    folder_.write("moves.yaml", names.substr(0, names.size() - 2) +
                                    "]\npoints:\n- {positions: [0, 0, 0, 0, 0, 0], time_from_start: 0}\n" +
                                    "- {positions: [" + last + ", 0, 0, 0, 0, 0], time_from_start: 2}\n");
  };
  message("1");
  for (const char* key : {"units: {angle: deg}", "units: {time: s}", "columns: [time]"})
    EXPECT_THAT(
        [&] { scenario(std::string("planned: {file: moves.yaml, ") + key + "}\nduration: planned\n"); },
        refused_at({.file = folder_ / "moves.yaml", .key = "units", .limit = "a CSV file"}))
        << key;
  message("90");
  const InputError error = test::input_error([&] { scenario("planned: moves.yaml\nduration: planned\n"); });
  EXPECT_THAT(error, refused_at({.file = folder_ / "moves.yaml",
                                 .line = 4,
                                 .key = "joint/shoulder_pan_joint/position",
                                 .value = "90"}));
  EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("has radians"), testing::Not(HasSubstr("units"))));
}

}  // namespace motion_tables_test
}  // namespace armtune::internal
