// A ROS parameter file is read by the rules of a distribution of ROS.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/trajectory_file.hpp"

namespace armtune::internal {
namespace controller_distro_test {

using test::refused;
using test::refused_at;
using test::with_j1;
using testing::AllOf;
using testing::HasSubstr;

/// The gains of j1 in a text, by the rules of a distribution if one is given.
Gains under(const std::string& text, std::optional<RosDistro> distro) {
  ParameterFile file{"f.yaml", text, chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml")};
  if (distro) set_distro(file, *distro);
  return joint_trajectory_gains(file.controller, "f.yaml", {"j1"});
}

TEST(ControllerFile, IsReadByTheRulesOfItsDistribution) {
  const std::string ros1 =
      "c:\n  type: effort_controllers/JointTrajectoryController\n  gains: {j1: {p: 1.0, antiwindup: true}}\n";
  EXPECT_EQ(jtc_distro(under(with_j1("p: 1.0"), {})), RosDistro::kJazzy);
  EXPECT_EQ(jtc_distro(under(ros1, {})), RosDistro::kNoetic);
  const std::string text = with_j1(
      "p: 1.0, i: 2.0, i_clamp: 4.0, i_clamp_max: 5.0, i_clamp_min: -3.0, u_clamp_max: 7.0, "
      "antiwindup_strategy: none, error_deadband: 0.1, normalize_error: true");
  const Gains humble = under(text, RosDistro::kHumble);
  EXPECT_EQ(jtc_distro(humble), RosDistro::kHumble);
  EXPECT_EQ(own(humble, "jtc_antiwindup")[0], 0.0) << "the contribution alone is clamped";
  EXPECT_EQ(own(humble, "jtc_i_clamp")[0], 4.0) << "Humble has no i_clamp_max";
  EXPECT_EQ(jtc_lower_i_clamp(humble, 0), 4.0);
  EXPECT_EQ(own(humble, "jtc_u_clamp_max")[0], 1e6);
  EXPECT_EQ(own(humble, "jtc_error_deadband")[0], 0.0);
  EXPECT_EQ(own(humble, "jtc_angle_wraparound")[0], 1.0);
  const Gains jazzy = under(text, RosDistro::kJazzy);
  EXPECT_EQ(jazzy.own, under(text, {}).own);
  EXPECT_EQ(own(jazzy, "jtc_i_clamp")[0], 5.0);
  EXPECT_EQ(own(jazzy, "jtc_angle_wraparound")[0], 0.0) << "Jazzy has no normalize_error";
  EXPECT_EQ(
      own(under(with_j1("p: 1.0, angle_wraparound: true"), RosDistro::kHumble), "jtc_angle_wraparound")[0],
      1.0);
}

TEST(ControllerFile, AMissingClampIsWhatTheDistributionMakesOfIt) {
  const std::string text = with_j1("p: 1.0, i: 2.0");
  EXPECT_EQ(own(under(text, RosDistro::kJazzy), "jtc_i_clamp")[0], 1e6);
  EXPECT_THAT([&] { under(text, RosDistro::kHumble); },
              refused_at({.file = "f.yaml", .line = 6, .limit = "i_clamp"}));
  EXPECT_THAT(refused(text, {"j1"}), refused_at({.line = 6, .limit = "i_clamp or --distro"}));
}

TEST(ControllerFile, ADistributionOfTheOtherRosIsRefused) {
  EXPECT_THAT(test::refusal([] { under(with_j1("p: 1.0"), RosDistro::kNoetic); }),
              AllOf(HasSubstr("f.yaml"), HasSubstr("ROS 1 Noetic")));
  const std::string ros1 =
      "c:\n  type: effort_controllers/JointTrajectoryController\n  gains: {j1: {p: 1.0}}\n";
  EXPECT_THAT(test::refusal([&] { under(ros1, RosDistro::kHumble); }), HasSubstr("ROS 2 Humble"));
}

}  // namespace controller_distro_test
}  // namespace armtune::internal
