// joint_trajectory.yaml against the motion it is of.

#include "tuner/planning/output/ros_trajectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "sim/yaml/document.hpp"
#include "tests/tuner/support/solved_plan.hpp"

namespace armtune::internal {
namespace ros_trajectory_test {

using testing::HasSubstr;

TEST(RosTrajectory, ReadsBackToTheSameBitsAndIsFloatingPointToEveryReader) {
  const test::Solved& plan = test::a_return();
  const std::string text = ros_trajectory(plan.robot(), plan.motion(), RosVersion::kRos2, {"one line"});
  const yaml::Node root = yaml::parse_text(text, "joint_trajectory.yaml");
  EXPECT_EQ(root.find("joint_names")->as_strings(), joint_names(plan.robot()));
  const auto& points = root.find("points")->items();
  ASSERT_EQ(points.size(), plan.motion().time.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const std::pair<const char*, const Eigen::MatrixXd*> parts[] = {
        {"positions", &plan.motion().position},
        {"velocities", &plan.motion().velocity},
        {"accelerations", &plan.motion().acceleration}};
    for (const auto& part : parts) {
      const std::vector<double> values = points[k].find(part.first)->as_numbers(6);
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(values[i], (*part.second)(static_cast<Eigen::Index>(i), column));
    }
    const yaml::Node& time = *points[k].find("time_from_start");
    EXPECT_NEAR(static_cast<double>(time.find("sec")->as_integer()) +
                    1e-9 * static_cast<double>(time.find("nanosec")->as_integer()),
                plan.motion().time[k] - plan.motion().time[0], 1e-9);
  }
  // YAML 1.1's floating point numbers (yaml.org/type/float.html): a point, and a sign in the exponent.
  const std::regex number(R"([-+]?[0-9]+\.[0-9]+([eE][-+][0-9]+)?)");
  const std::regex list(R"((positions|velocities|accelerations): \[([^\]]*)\])");
  std::size_t numbers = 0;
  for (auto line = std::sregex_iterator(text.begin(), text.end(), list); line != std::sregex_iterator();
       ++line) {
    const std::string all = (*line)[2];
    const std::regex comma(", ");
    for (auto one = std::sregex_token_iterator(all.begin(), all.end(), comma, -1);
         one != std::sregex_token_iterator(); ++one, ++numbers) {
      EXPECT_TRUE(std::regex_match(one->str(), number)) << one->str();
    }
  }
  EXPECT_EQ(numbers, 3 * 6 * points.size());
}

TEST(RosTrajectory, SmallLargeAndWholeNumbersHaveAPoint) {
  Trajectory tiny;
  tiny.time = {0.0, 1.0};
  const RobotModel& robot = test::a_return().robot();
  tiny.position = Eigen::MatrixXd::Zero(6, 2);
  tiny.velocity = tiny.acceleration = tiny.position;
  tiny.position.col(0) << 1e-5, -2e-300, 3e20, 0.0, -7.0, 1.5e-9;
  const std::string text = ros_trajectory(robot, tiny, RosVersion::kRos1, {});
  EXPECT_THAT(text, HasSubstr("positions: [1.0e-05, -2.0e-300, 3.0e+20, 0.0, -7.0, 1.5e-09]"));
  EXPECT_THAT(text, HasSubstr("{secs: 1, nsecs: 0}"));
}

TEST(RosTrajectory, SaysWhereItDoesNotEndAtRest) {
  const auto header = [](const test::Solved& plan) {
    const std::string text = ros_trajectory(plan.robot(), plan.motion(), RosVersion::kRos2, {"one line"});
    return text.substr(0, text.find("joint_names:"));
  };
  EXPECT_EQ(header(test::a_limited_move()), "# one line\n");
  EXPECT_THAT(header(test::a_return()),
              testing::AllOf(HasSubstr("does not end at rest"), HasSubstr("rad/s there")));
}

}  // namespace ros_trajectory_test
}  // namespace armtune::internal
