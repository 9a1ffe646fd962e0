#include "core/robot/urdf_interfaces.hpp"

#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_interfaces_test {

using testing::ElementsAre;

class UrdfInterfaces : public test::UrdfFiles {
 protected:
  /// Of one joint, with this beside its limits of -1 .. 2.
  JointLimits limits_with(const std::string& safety, const UrdfOptions& options = {}) const {
    return read(test::robot(test::one_joint(test::kInertial, "<axis xyz='0 0 1'/>" + test::kLimit + safety)),
                options)
        .joints[0]
        .limits;
  }
};

TEST_F(UrdfInterfaces, SoftLimitsOfASafetyControllerAreThePositionLimits) {
  const JointLimits soft =
      limits_with("<safety_controller soft_lower_limit='-0.9' soft_upper_limit='1.5' k_velocity='10'/>");
  EXPECT_EQ(soft.lower, -0.9);
  EXPECT_EQ(soft.upper, 1.5);
  EXPECT_TRUE(soft.soft);
  EXPECT_FALSE(limits_with("").soft);
}

TEST_F(UrdfInterfaces, SoftLimitsBeyondTheHardOnesOrWithoutARangeDoNotCount) {
  const JointLimits wide =
      limits_with("<safety_controller soft_lower_limit='-9' soft_upper_limit='1.5' k_velocity='10'/>");
  EXPECT_EQ(wide.lower, -1.0);
  EXPECT_EQ(wide.upper, 1.5);
  const JointLimits none = limits_with("<safety_controller k_velocity='10'/>");
  EXPECT_EQ(none.lower, -1.0);
  EXPECT_EQ(none.upper, 2.0);
  EXPECT_FALSE(none.soft);
}

TEST_F(UrdfInterfaces, LimitsThatAreGivenStandInPlaceOfSoftOnes) {
  UrdfOptions options;
  options.limits["j"].lower = -3.0;
  options.limits["j"].upper = 3.0;
  const JointLimits given = limits_with(
      "<safety_controller soft_lower_limit='-0.9' soft_upper_limit='1.5' k_velocity='10'/>", options);
  EXPECT_EQ(given.upper, 3.0);
  EXPECT_FALSE(given.soft);
}

TEST_F(UrdfInterfaces, Ros2ControlSaysWhatCanBeCommandedAndRead) {
  const RobotModel arm = read(test::robot(
      test::one_joint() +
      "<ros2_control name='a' type='system'><joint name='j'>"
      "<command_interface name='position'/><command_interface name='velocity'/><state_interface name='position'/>"
      "</joint></ros2_control>"
      "<ros2_control name='b' type='system'><joint name='j'><command_interface name='velocity'/>"
      "<state_interface name='effort'/></joint><joint name='elsewhere'/></ros2_control>"));
  EXPECT_THAT(arm.joints[0].interfaces.command, ElementsAre("position", "velocity"));
  EXPECT_THAT(arm.joints[0].interfaces.state, ElementsAre("position", "effort"));
  EXPECT_TRUE(read(test::robot(test::one_joint())).joints[0].interfaces.command.empty());
}

}  // namespace urdf_interfaces_test
}  // namespace armtune::internal
