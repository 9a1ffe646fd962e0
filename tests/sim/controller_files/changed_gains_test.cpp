#include "sim/controller_files/changed_gains.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/trajectory_file.hpp"

namespace armtune::internal {
namespace changed_gains_test {

using test::refused;
using test::with_j1;
using testing::AllOf;
using testing::HasSubstr;

// What a file cannot hold is refused, not lost.
TEST(ControllerFile, TheChangedFileReadsBackAsTheGains) {
  const std::vector<std::string> j1 = {"j1"};
  const auto into = [&j1](const std::string& text, const char* gain, double value) {
    const RosController controller = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
    Gains gains = joint_trajectory_gains(controller, "f.yaml", j1);
    own(gains, gain)[0] = value;
    return with_gains(text, controller, "f.yaml", gains, j1);
  };
  EXPECT_THAT(into(with_j1("p: 1.0, i: 1.0, i_clamp: 2.0"), "jtc_i_clamp", 3.0), HasSubstr("i_clamp: 3.0"));
  EXPECT_THAT(into(with_j1("p: 1.0, i_clamp: 9.0, i_clamp_max: 2.0, i_clamp_min: -2.0"), "jtc_i_clamp", 3.0),
              HasSubstr("i_clamp: 3.0, i_clamp_max: 3.0, i_clamp_min: -3.0"));
  EXPECT_THAT(into(with_j1("p: 1.0, ff_velocity_scale: 2.0"), "jtc_ff_velocity_scale", 4.0),
              HasSubstr("ff_velocity_scale: 4.0"));
  EXPECT_THAT(test::refusal([&] { into(with_j1("p: 1.0, i: 0.0"), "jtc_i", 3.0); }), HasSubstr("no i_clamp"));
  EXPECT_THAT(test::refusal([&] { into(with_j1("p: 1.0"), "jtc_antiwindup", 0.0); }),
              AllOf(HasSubstr("jtc_antiwindup must become 0.0"), HasSubstr("would still give 1.0")));
  // A number, a joint or all gains that somebody else has by an alias.
  const std::string left =
      "left:\n  ros__parameters:\n    command_interfaces: [effort]\n    gains: &g {j1: {p: 1.0}}\n";
  const std::string two =
      left + "right:\n  ros__parameters:\n    command_interfaces: [effort]\n    gains: *g\n";
  for (
      const std::string& text :
      {with_j1("p: &x 1.0, tracking_time_constant: *x"),
       std::string(
           "left: &l\n  ros__parameters:\n    command_interfaces: [effort]\n    gains: {j1: {p: 1.0}}\nright: *l\n")}) {
    EXPECT_THAT(test::refusal([&] { into(text, "jtc_p", 3.0); }), HasSubstr("an alias elsewhere")) << text;
  }
  for (const char* name : {"left", "right"}) {
    const RosController one = chosen_controller(ros_controllers(two, "f.yaml"), "f.yaml", name);
    Gains gains = joint_trajectory_gains(one, "f.yaml", j1);
    own(gains, "jtc_p")[0] = 3.0;
    EXPECT_THAT(test::refusal([&] { with_gains(two, one, "f.yaml", gains, j1); }),
                HasSubstr("an alias elsewhere"));
  }
}

}  // namespace changed_gains_test
}  // namespace armtune::internal
