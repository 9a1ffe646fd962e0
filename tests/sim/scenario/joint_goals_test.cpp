// Positions without times, through which a motion is planned later.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/planned.hpp"

namespace armtune::internal {
namespace joint_goals_test {

using test::refused_at;

class JointGoalsFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const { return folder_.write("plan.csv", text); }
  JointSpline load(const std::string& path) const { return load_planned_motion({{path}}, *robot_); }

  test::TemporaryFolder folder_;
  std::shared_ptr<const RobotModel> robot_ = load_robot("ur10");
};

constexpr const char* kJoints =
    "shoulder_pan_joint,shoulder_lift_joint,joint/elbow_joint/position,wrist_1_joint,wrist_2_joint,wrist_3_joint";

TEST_F(JointGoalsFile, HasPositionsWithoutTimes) {
  PlannedFile file{{folder_.write("goals.csv", kJoints + std::string("\n0,0,45,0,0,0\n0,-90,0,0,0,0\n"))}};
  file.table.units.angle = std::numbers::pi / 180.0;
  const MotionOrGoals read = load_motion_or_goals(file, *robot_);
  EXPECT_FALSE(read.motion);
  ASSERT_EQ(read.goals.size(), 2U);
  EXPECT_DOUBLE_EQ(read.goals.front()[2], std::numbers::pi / 4.0);
  EXPECT_DOUBLE_EQ(read.goals.back()[1], -std::numbers::pi / 2.0);
  test::QuinticPlan plan;
  plan.start = JointVector::Constant(6, -0.5);
  plan.goal = JointVector::Constant(6, 0.7);
  const MotionOrGoals motion = load_motion_or_goals({{write(test::plan_csv(*robot_, plan))}}, *robot_);
  EXPECT_TRUE(motion.goals.empty());
  EXPECT_EQ(motion.motion.value().end(), load(folder_ / "plan.csv").end());
  const std::string message =
      folder_.write("goals.yaml",
                    "joint_names: [shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint, "
                    "wrist_2_joint, wrist_3_joint]\npoints:\n- {positions: [0, 0, 1, 0, 0, 0]}\n"
                    "- {positions: [0, 0, 2, 0, 0, 0]}\n");
  EXPECT_EQ(load_motion_or_goals({{message}}, *robot_).goals.at(1)[2], 2.0);
  // A motion needs times.
  EXPECT_THAT([&] { load(file.table.path); }, refused_at({.file = folder_ / "goals.csv", .key = "time"}));
  EXPECT_THAT([&] { load(message); }, refused_at({.file = message, .key = "time_from_start"}));
}

TEST_F(JointGoalsFile, ThatCannotBeMeantIsRefused) {
  const auto refused = [&](const std::string& text) {
    const std::string path = write(text);
    return test::input_error([&] { load_motion_or_goals({{path}}, *robot_); });
  };
  const std::string header = kJoints;
  EXPECT_THAT(refused("clock," + header + "\n0,0,0,0,0,0,0\n1,1,0,0,0,0,0\n"),
              refused_at({.file = folder_ / "plan.csv", .line = 1, .key = "time"}));
  EXPECT_THAT(refused(header + "\n0,0,0,0,0,0\n"),
              refused_at({.file = folder_ / "plan.csv", .value = "1", .limit = "at least 2 joint goals"}));
  EXPECT_THAT(refused(header + "\n0,0,0,0,0,0\n0,0,4,0,0,0\n"),
              refused_at({.file = folder_ / "plan.csv",
                          .line = 3,
                          .key = "joint/elbow_joint/position",
                          .value = "4",
                          .limit = "-3.14159 to 3.14159"}));
  std::string many = header + "\n";
  for (std::size_t k = 0; k <= kMostGoals; ++k) many += "0,0,0,0,0,0\n";
  EXPECT_THAT(refused(many), refused_at({.value = "101", .limit = "at most 100 joint goals"}));
  // A limit of pi that was written with six digits is a little too large.
  const std::string rounded = write(header + "\n0,0,0,0,0,0\n0,0,3.141593,0,0,0\n");
  EXPECT_EQ(load_motion_or_goals({{rounded}}, *robot_).goals.at(1)[2], robot_->joints[2].limits.upper);
  EXPECT_THAT(refused("shoulder_pan_joint\n0\n1\n"),
              refused_at({.line = 1, .key = "joint/shoulder_lift_joint/position"}));
  const std::string message =
      folder_.write("goals.yaml",
                    "joint_names: [shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint, "
                    "wrist_2_joint, wrist_3_joint]\npoints:\n"
                    "- {positions: [0, 0, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0]}\n"
                    "- {positions: [0, 0, 2, 0, 0, 0], velocities: [0, 0, 1, 0, 0, 0]}\n");
  const auto read = [&] { load_motion_or_goals({{message}}, *robot_); };
  EXPECT_THAT(
      read,
      refused_at({.file = message, .line = 4, .key = "time_from_start", .limit = "a time for each point"}));
}

}  // namespace joint_goals_test
}  // namespace armtune::internal
