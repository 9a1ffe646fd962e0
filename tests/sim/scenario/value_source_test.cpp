// Where a robot file says that its rotor inertia and its friction come from.

#include "core/robot/value_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/robot_writer.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace value_source_test {

/// A key of robot files with a number for each joint and a mark, and where the model has these.
struct MarkedKey {
  const char* key;
  JointVector Chain::*values;
  ValueSource RobotModel::*source;
};

constexpr MarkedKey kRotorKey{"rotor_inertia", &Chain::rotor_inertia, &RobotModel::rotor_source};
constexpr MarkedKey kViscousKey{"viscous_friction", &Chain::viscous_friction, &RobotModel::viscous_source};
constexpr MarkedKey kCoulombKey{"coulomb_friction", &Chain::coulomb_friction, &RobotModel::coulomb_source};

std::string arm_with(const test::TemporaryFolder& folder, const MarkedKey& key, const std::string& values) {
  return folder.write(
      "arm.yaml", "urdf: " + test::source_dir() + "/sim/robots/ur10.urdf\n" + key.key + ": " + values + "\n");
}

class AValueSource : public testing::TestWithParam<MarkedKey> {};
INSTANTIATE_TEST_SUITE_P(OfEachKey, AValueSource, testing::Values(kRotorKey, kViscousKey, kCoulombKey),
                         [](const auto& key) { return std::string(key.param.key); });

TEST_P(AValueSource, IsTheMarkInTheRobotFileAndInTheFileThatIsWrittenAgain) {
  const test::TemporaryFolder folder;
  const JointVector values = JointVector::LinSpaced(6, 1.0, 6.0);
  const std::string list = "[1, 2, 3, 4, 5, 6]";
  const bool rotors = GetParam().source == kRotorKey.source;
  const auto expect_source = [&](const std::string& text, ValueSource source, std::size_t estimates = 0) {
    const auto arm = load_robot(arm_with(folder, GetParam(), text));
    folder.write("again.urdf", urdf_text(*arm));
    const auto again = load_robot(folder.write("again.yaml", robot_yaml(*arm, "again.urdf")));
    for (const auto& robot : {arm, again}) {
      for (const MarkedKey& key : {kRotorKey, kViscousKey, kCoulombKey})
        EXPECT_EQ((*robot).*key.source, key.source == GetParam().source ? source : ValueSource::kGiven)
            << text;
      EXPECT_EQ(robot->estimated_rotors.size(), estimates) << text;
      EXPECT_EQ(robot->chain.*GetParam().values, values) << text;
    }
  };
  expect_source(list, ValueSource::kGiven);
  for (const ValueSource source : {ValueSource::kMeasured, ValueSource::kPublished, ValueSource::kAssumed})
    expect_source(std::string("{") + name(source) + ": " + list + "}", source);
  // Joints with an estimated rotor inertia are listed by name; the mark is that of the others.
  expect_source("{estimated: " + list + "}", rotors ? ValueSource::kGiven : ValueSource::kEstimated,
                rotors ? 6 : 0);
  expect_source(
      "{published: {shoulder_pan_joint: 1, shoulder_lift_joint: 2, elbow_joint: 3, wrist_1_joint: 4, "
      "wrist_2_joint: 5, wrist_3_joint: 6}}",
      ValueSource::kPublished);
}

TEST_P(AValueSource, NeedsANumberForEveryJointAndOtherMarksAreRefused) {
  const test::TemporaryFolder folder;
  const std::string few = arm_with(folder, GetParam(), "{assumed: [0.1, 0.2]}");
  EXPECT_THAT([&] { load_robot(few); }, test::refused_at({.file = few,
                                                          .line = 2,
                                                          .key = std::string(GetParam().key) + "/assumed",
                                                          .value = "2",
                                                          .limit = "6 numbers"}));
  const std::string guessed = arm_with(folder, GetParam(), "{guessed: [1, 2, 3, 4, 5, 6]}");
  EXPECT_THAT([&] { load_robot(guessed); }, test::refused_at({.file = guessed, .line = 2}));
  const std::string two =
      arm_with(folder, GetParam(), "{assumed: [1, 2, 3, 4, 5, 6], published: [1, 2, 3, 4, 5, 6]}");
  EXPECT_THAT([&] { load_robot(two); }, test::refused_at({.file = two, .line = 2}));
}

TEST(ValueSource, OfTheBundledArmsIsMarked) {
  EXPECT_EQ(load_robot("ur10")->rotor_source, ValueSource::kAssumed);
  EXPECT_EQ(load_robot("fr3")->rotor_source, ValueSource::kPublished);
  EXPECT_EQ(load_robot("youbot")->rotor_source, ValueSource::kPublished);
  for (const char* name : {"ur10", "fr3", "youbot"})
    EXPECT_TRUE(load_robot(name)->estimated_rotors.empty()) << name << ": only estimates are varied";
  for (const std::string& name : bundled_names("robots")) {
    const auto robot = load_robot(name);
    EXPECT_EQ(robot->viscous_source == ValueSource::kGiven, robot->chain.viscous_friction.isZero(0.0))
        << name;
    EXPECT_EQ(robot->coulomb_source == ValueSource::kGiven, robot->chain.coulomb_friction.isZero(0.0))
        << name;
  }
}

}  // namespace value_source_test
}  // namespace armtune::internal
