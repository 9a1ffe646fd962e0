// The drives that a robot file gives.

#include "sim/scenario/robot_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/robot_writer.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace robot_drives_test {

using test::refused_at;
using testing::HasSubstr;

const std::string kUrdf = test::source_dir() + "/sim/robots/ur10.urdf";

std::string robot_text(const std::string& rest) {
  return "urdf: " + kUrdf + "\n" + rest;
}

TEST(RobotFile, SaysWhetherTheRobotHoldsItsOwnWeight) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(load_robot(folder.write("arm.yaml", robot_text("")))->compensates_gravity);
  const auto arm = load_robot(folder.write("arm.yaml", robot_text("compensates_gravity: true\n")));
  EXPECT_TRUE(arm->compensates_gravity);
  folder.write("again.urdf", urdf_text(*arm));
  EXPECT_TRUE(
      load_robot(folder.write("again.yaml", robot_yaml(*arm, "again.urdf", "")))->compensates_gravity);
  for (const char* name : {"fr3", "panda", "iiwa14"})
    EXPECT_TRUE(load_robot(name)->compensates_gravity) << name;
  const std::string wrong = folder.write("arm.yaml", robot_text("compensates_gravity: 1.5\n"));
  EXPECT_THAT([&] { load_robot(wrong); }, refused_at({.file = wrong,
                                                      .line = 2,
                                                      .key = "compensates_gravity",
                                                      .value = "1.5",
                                                      .limit = "true or false"}));
}

TEST(RobotFile, HasGainsOfDrives) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(load_robot(folder.write("arm.yaml", robot_text("")))->drive_velocity_gain.size(), 0);
  const auto arm = load_robot(folder.write(
      "arm.yaml",
      robot_text("drive_velocity_gain: [1, 2, 3, 4, 5, 6]\ndrive_velocity_integral: [0, 2, 3, 4, 5, 6]\n")));
  EXPECT_EQ(arm->drive_velocity_gain, JointVector::LinSpaced(6, 1.0, 6.0));
  EXPECT_EQ(arm->drive_velocity_integral[0], 0.0);
  folder.write("again.urdf", urdf_text(*arm));
  const auto again = load_robot(folder.write("again.yaml", robot_yaml(*arm, "again.urdf", "")));
  EXPECT_EQ(again->drive_velocity_gain, arm->drive_velocity_gain);
  EXPECT_EQ(again->drive_velocity_integral, arm->drive_velocity_integral);
  struct Wrong {
    std::string key, list, at, value, limit;
  };
  for (const auto& [key, list, at, value, limit] :
       {Wrong{"drive_velocity_gain", "[1, 2, 3, 4, 5, 0]", "", "0", "finite and above 0"},
        Wrong{"drive_velocity_gain", "[1, 2, .nan, 4, 5, 1]", "/2", ".nan",
              "a decimal number with '.' and no unit, such as -1.5 or 1e3"},
        Wrong{"drive_velocity_integral", "[1, 2, 3, 4, 5, -1]", "", "-1", "finite and at least 0"}}) {
    const std::string path = folder.write("arm.yaml", robot_text(key + ": " + list + "\n"));
    EXPECT_THAT([&path] { load_robot(path); },
                refused_at({.file = path, .line = 2, .key = key + at, .value = value, .limit = limit}));
  }
}

TEST(RobotFile, HasAMapOfDrives) {
  const test::TemporaryFolder folder;
  const auto arm = load_robot(folder.write(
      "arm.yaml", robot_text("drives:\n  velocity_gain: [1, 2, 3, 4, 5, 6]\n  velocity_integral: 0\n"
                             "  position_gain: 20\n  torque_rate: {wrist_3_joint: 6, shoulder_pan_joint: 1, "
                             "shoulder_lift_joint: 2, elbow_joint: 3, wrist_1_joint: 4, wrist_2_joint: 5}\n"
                             "  delay: 0.0015\n  rate: 500\n")));
  const auto has_all = [](const RobotModel& model) {
    EXPECT_EQ(model.drive_velocity_gain, JointVector::LinSpaced(6, 1.0, 6.0));
    EXPECT_EQ(model.drive_velocity_integral, JointVector::Zero(6));
    EXPECT_EQ(model.drive_position_gain, JointVector::Constant(6, 20.0));
    EXPECT_EQ(model.drive_torque_rate, JointVector::LinSpaced(6, 1.0, 6.0));
    EXPECT_EQ(model.drive_delay, JointVector::Constant(6, 0.0015));
    EXPECT_EQ(model.drive_rate, 500.0);
  };
  has_all(*arm);
  folder.write("again.urdf", urdf_text(*arm));
  has_all(*load_robot(folder.write("again.yaml", robot_yaml(*arm, "again.urdf", ""))));
  const auto bare = load_robot(folder.write("bare.yaml", robot_text("drives: {}\n")));
  EXPECT_EQ(bare->drive_position_gain.size() + bare->drive_torque_rate.size() + bare->drive_delay.size(), 0);
  EXPECT_EQ(bare->drive_rate, 0.0);
  EXPECT_EQ(robot_yaml(*bare, "again.urdf").find("drives"), std::string::npos);
}

TEST(RobotFile, RefusesDrivesThatNoRobotHas) {
  const test::TemporaryFolder folder;
  const std::string a_number = "a decimal number with '.' and no unit, such as -1.5 or 1e3";
  const std::string positive = "finite and above 0";
  const std::string delay = "finite and at least 0, and at most 0.1";
  struct Wrong {
    std::string key, given, value, limit;
  };
  for (const auto& [key, given, value, limit] :
       {Wrong{"position_gain", "0", "0", positive}, Wrong{"position_gain", "[1, 2, 3]", "3", "6 numbers"},
        Wrong{"torque_rate", "-1", "-1", positive}, Wrong{"torque_rate", "0", "0", positive},
        Wrong{"torque_rate", ".inf", ".inf", a_number}, Wrong{"delay", "-0.001", "-0.001", delay},
        Wrong{"delay", "0.2", "0.2", delay}, Wrong{"rate", "0", "0", "1 to 100000"},
        Wrong{"rate", "1e6", "1e6", "1 to 100000"}, Wrong{"velocity_gain", ".nan", ".nan", a_number},
        Wrong{"velocity_integral", "-1", "-1", "finite and at least 0"},
        Wrong{"gain", "3", "gain",
              "the keys: velocity_gain, velocity_integral, position_gain, torque_rate, delay, rate"}}) {
    const std::string path = folder.write("arm.yaml", robot_text("drives: {" + key + ": " + given + "}\n"));
    EXPECT_THAT(
        [&path] { load_robot(path); },
        refused_at({.file = path, .line = 2, .key = "drives/" + key, .value = value, .limit = limit}));
  }
  const std::string no_map = folder.write("arm.yaml", robot_text("drives: 7\n"));
  EXPECT_THAT([&] { load_robot(no_map); },
              refused_at({.line = 2, .key = "drives", .value = "7", .limit = "a map of 'key: value'"}));
  const std::string twice = folder.write("arm.yaml", robot_text("drive_velocity_gain: [1, 1, 1, 1, 1, 1]\n"
                                                                "drives: {velocity_gain: 2}\n"));
  const InputError error = test::input_error([&] { load_robot(twice); });
  EXPECT_THAT(error, refused_at({.file = twice, .line = 3, .key = "drives/velocity_gain", .value = "2"}));
  EXPECT_THAT(error.what(), HasSubstr("remove the key drive_velocity_gain"));
}

}  // namespace robot_drives_test
}  // namespace armtune::internal
