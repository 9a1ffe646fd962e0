// A file that has no gains to tune is refused with what it has and with what can be done.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "sim/controller_files/parameter_file.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace file_without_gains_test {

using test::refused_at;
using testing::EndsWith;
using testing::HasSubstr;

/// The error with which a file is refused for an arm of one joint.
InputError refused(const std::string& text, const std::string& node = "") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("f.yaml", text);
  return test::input_error([&] { required_parameter_file(path, node, {}, {"j1"}); });
}

/// As in the driver of Universal Robots for ROS 2.
constexpr const char* kPositions = R"(controller_manager:
  ros__parameters:
    update_rate: 500
    scaled: {type: ur_controllers/ScaledJointTrajectoryController}
    forward: {type: velocity_controllers/JointGroupVelocityController}
scaled:
  ros__parameters:
    joints: [j1]
    command_interfaces: [position]
    state_interfaces: [position, velocity]
forward:
  ros__parameters: {joints: [j1], interface_name: velocity}
)";

TEST(FileWithoutGains, OfPositionCommandsPointsToStreamedPositions) {
  for (const char* node : {"", "scaled"}) {
    const InputError error = refused(kPositions, node);
    EXPECT_THAT(error, refused_at({.file = EndsWith("f.yaml"),
                                   .line = 8,
                                   .key = "scaled",
                                   .value = "position",
                                   .limit = "effort or velocity"}));
    EXPECT_THAT(error.what(), HasSubstr("--controller position_streaming"));
  }
  EXPECT_THAT(refused("arm:\n  type: position_controllers/ScaledJointTrajectoryController\n  joints: [j1]\n"),
              refused_at({.line = 2,
                          .key = "arm",
                          .value = "position_controllers/ScaledJointTrajectoryController",
                          .limit = "effort or velocity"}));
}

// Another controller of the file has gains.
TEST(FileWithoutGains, IsRefusedLikewiseBesideGainsOfAnotherKind) {
  const std::string pid = "pid:\n  ros__parameters:\n    gains: {j1: {p: 1.0}}\n";
  const std::string manager = "more:\n  ros__parameters:\n    pid: {type: pid_controller/PidController}\n";
  EXPECT_THAT(refused(kPositions + pid + manager),
              refused_at({.line = 8, .key = "scaled", .value = "position"}));
  EXPECT_THAT(refused(kPositions + pid + manager, "scaled"), refused_at({.line = 8, .key = "scaled"}));
}

TEST(FileWithoutGains, OfOtherCommandsAsksForThem) {
  std::string text = kPositions;
  text.replace(text.find("[position]"), 10, "[effort]");
  EXPECT_THAT(refused(text), refused_at({.line = 8, .key = "scaled", .value = "effort", .limit = "gains"}));
  EXPECT_THAT(refused(text, "forward"), refused_at({.file = EndsWith("f.yaml"), .value = "forward"}));
  EXPECT_THAT(refused("a: {b: 1}\n"), refused_at({.file = EndsWith("f.yaml"), .line = 0}));
}

}  // namespace file_without_gains_test
}  // namespace armtune::internal
