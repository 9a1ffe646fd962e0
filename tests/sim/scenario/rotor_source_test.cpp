// Where a robot file says that its rotor inertia comes from.

#include "core/robot/rotor_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/robot_writer.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace rotor_source_test {

std::string arm_with_rotors(const test::TemporaryFolder& folder, const std::string& rotors) {
  return folder.write(
      "arm.yaml", "urdf: " + test::source_dir() + "/sim/robots/ur10.urdf\nrotor_inertia: " + rotors + "\n");
}

TEST(RotorSource, IsTheMarkInTheRobotFileAndInTheFileThatIsWrittenAgain) {
  const test::TemporaryFolder folder;
  const JointVector values = JointVector::LinSpaced(6, 1.0, 6.0);
  const std::string list = "[1, 2, 3, 4, 5, 6]";
  const auto expect_source = [&](const std::string& rotors, RotorSource source, std::size_t estimates) {
    const auto arm = load_robot(arm_with_rotors(folder, rotors));
    folder.write("again.urdf", urdf_text(*arm));
    const auto again = load_robot(folder.write("again.yaml", robot_yaml(*arm, "again.urdf")));
    for (const auto& robot : {arm, again}) {
      EXPECT_EQ(robot->rotor_source, source) << rotors;
      EXPECT_EQ(robot->estimated_rotors.size(), estimates) << rotors;
      EXPECT_EQ(robot->chain.rotor_inertia, values) << rotors;
    }
  };
  expect_source(list, RotorSource::kGiven, 0);
  for (const RotorSource source : {RotorSource::kMeasured, RotorSource::kPublished, RotorSource::kAssumed})
    expect_source(std::string("{") + name(source) + ": " + list + "}", source, 0);
  expect_source("{estimated: " + list + "}", RotorSource::kGiven, 6);
  expect_source(
      "{published: {shoulder_pan_joint: 1, shoulder_lift_joint: 2, elbow_joint: 3, wrist_1_joint: 4, "
      "wrist_2_joint: 5, wrist_3_joint: 6}}",
      RotorSource::kPublished, 0);
}

TEST(RotorSource, AMarkNeedsANumberForEveryJointAndOtherMarksAreRefused) {
  const test::TemporaryFolder folder;
  const std::string few = arm_with_rotors(folder, "{assumed: [0.1, 0.2]}");
  EXPECT_THAT(
      [&] { load_robot(few); },
      test::refused_at(
          {.file = few, .line = 2, .key = "rotor_inertia/assumed", .value = "2", .limit = "6 numbers"}));
  const std::string guessed = arm_with_rotors(folder, "{guessed: [1, 2, 3, 4, 5, 6]}");
  EXPECT_THAT([&] { load_robot(guessed); }, test::refused_at({.file = guessed, .line = 2}));
  const std::string two =
      arm_with_rotors(folder, "{assumed: [1, 2, 3, 4, 5, 6], published: [1, 2, 3, 4, 5, 6]}");
  EXPECT_THAT([&] { load_robot(two); }, test::refused_at({.file = two, .line = 2}));
}

TEST(RotorSource, OfTheBundledArmsIsMarked) {
  EXPECT_EQ(load_robot("ur10")->rotor_source, RotorSource::kAssumed);
  EXPECT_EQ(load_robot("fr3")->rotor_source, RotorSource::kPublished);
  EXPECT_EQ(load_robot("youbot")->rotor_source, RotorSource::kPublished);
  for (const char* name : {"ur10", "fr3", "youbot"})
    EXPECT_TRUE(load_robot(name)->estimated_rotors.empty()) << name << ": only estimates are varied";
}

}  // namespace rotor_source_test
}  // namespace armtune::internal
