// Numbers of a parameter file that YAML aliases and merge keys use at several places.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace aliased_numbers_test {

using testing::AllOf;
using testing::HasSubstr;

TEST(AliasedNumbers, NumbersThatAnAnchorSharesCanOnlyChangeTogether) {
  const std::string text =
      "c:\n  type: effort_controllers/JointTrajectoryController\n  joints: [j1, j2]\n"
      "  gains: {j1: &all {p: 1.0, d: 2.0}, j2: *all}\n";
  const std::vector<std::string> joints = {"j1", "j2"};
  const RosController controller = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
  Gains gains = joint_trajectory_gains(controller, "f.yaml", joints);
  own(gains, "jtc_p") = JointVector::Constant(2, 7.0);
  EXPECT_THAT(with_gains(text, controller, "f.yaml", gains, joints),
              HasSubstr("&all {p: 7.0, d: 2.0}, j2: *all"));
  own(gains, "jtc_p")[1] = 8.0;
  EXPECT_THAT(test::refusal([&] { with_gains(text, controller, "f.yaml", gains, joints); }),
              AllOf(HasSubstr("f.yaml:4: c: "), HasSubstr(" p of j1 and p of j2")));
  own(gains, "jtc_p")[1] = 7.0;
  own(gains, "jtc_i")[0] = 1.0;
  EXPECT_THAT(
      test::refusal([&] { with_gains(text, controller, "f.yaml", gains, joints); }),
      AllOf(HasSubstr("jtc_i of j1 must become 1.0"), HasSubstr("would still give 0.0; set this gain")));
}

// An outermost value with an anchor is read by nobody at its own place, unless it has a controller.
TEST(AliasedNumbers, ANumberThatIsOnlyDefinedOutsideOfTheControllerCanChange) {
  const std::string arm = "c:\n  type: effort_controllers/JointTrajectoryController\n  joints: [j1, j2]\n";
  const std::vector<std::string> joints = {"j1", "j2"};
  const auto changed = [&joints](const std::string& text) {
    const RosController controller = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
    Gains gains = joint_trajectory_gains(controller, "f.yaml", joints);
    own(gains, "jtc_p") = JointVector::Constant(2, 7.0);
    return with_gains(text, controller, "f.yaml", gains, joints);
  };
  EXPECT_THAT(changed("pid: &pid {p: 1.0}\n" + arm + "  gains: {j1: *pid, j2: *pid}\n"),
              HasSubstr("pid: &pid {p: 7.0}\n"));
  EXPECT_THAT(changed("p: &p 1.0\n" + arm + "  gains: {j1: {p: *p}, j2: {p: *p}}\n"),
              HasSubstr("p: &p 7.0\n"));
  EXPECT_THAT(changed("pid: &pid {p: 1.0}\n" + arm + "  gains: {j1: {<<: *pid}, j2: {<<: *pid, d: 1.0}}\n"),
              HasSubstr("pid: &pid {p: 7.0}\n"));
  for (const std::string& other :
       {std::string("pid: &pid {p: 1.0}\n") + arm + "  gains: {j1: *pid, j2: *pid}\ngripper: {pid: *pid}\n",
        "pid: &pid {p: 1.0, type: my/Pid}\n" + arm + "  gains: {j1: *pid, j2: *pid}\n",
        "gripper: {p: &p 1.0}\n" + arm + "  gains: {j1: {p: *p}, j2: {p: *p}}\n",
        "gazebo: {pids: {x: &pid {p: 1.0}}}\n" + arm + "  gains: {j1: *pid, j2: *pid}\n"})
    EXPECT_THAT(test::refusal([&] { changed(other); }), HasSubstr("an alias elsewhere")) << other;
}

TEST(AliasedNumbers, ANumberThatAnAliasHasElsewhereIsNotChanged) {
  const std::string text =
      "c:\n  type: effort_controllers/JointTrajectoryController\n  constraints: {goal_time: *p}\n"
      "  gains: {j1: {p: 1.0, d: 2.0}}\n";
  const std::string after =
      "c:\n  type: effort_controllers/JointTrajectoryController\n  joints: [j1]\n"
      "  gains: {j1: {p: &p 1.0, d: 2.0}}\n  constraints: {goal_time: *p}\n";
  EXPECT_THAT(test::refusal([&] { ros_controllers(text, "f.yaml"); }), HasSubstr("not valid YAML"));
  const RosController controller = chosen_controller(ros_controllers(after, "f.yaml"), "f.yaml");
  Gains gains = joint_trajectory_gains(controller, "f.yaml", {"j1"});
  own(gains, "jtc_d")[0] = 3.0;
  EXPECT_THAT(with_gains(after, controller, "f.yaml", gains, {"j1"}), HasSubstr("{p: &p 1.0, d: 3.0}"));
  own(gains, "jtc_p")[0] = 3.0;
  EXPECT_THAT(test::refusal([&] { with_gains(after, controller, "f.yaml", gains, {"j1"}); }),
              AllOf(HasSubstr("f.yaml:4:"), HasSubstr("an alias elsewhere")));
}

// A thousand aliases of a map of a thousand values cost no more than the map.
TEST(AliasedNumbers, AliasesOfAliasesCostNothing) {
  std::string text = "a0: &a0 {x: 1}\n";
  for (int i = 1; i < 60; ++i) text += fmt::format("a{}: &a{} [*a{}, *a{}]\n", i, i, i - 1, i - 1);
  EXPECT_TRUE(yaml::read_placed(text, "f.yaml"));
  std::string merges = "a0: &a0 {x: 1}\n";
  for (int i = 1; i < 2000; ++i) merges += fmt::format("a{}: &a{} {{<<: *a{}, k{}: 1}}\n", i, i, i - 1, i);
  EXPECT_THAT(test::refusal([&] { yaml::read_placed(merges, "f.yaml"); }),
              HasSubstr("more than 200000 values"));
}

}  // namespace aliased_numbers_test
}  // namespace armtune::internal
